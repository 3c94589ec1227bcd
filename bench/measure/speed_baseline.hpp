#pragma once

// SpeedBaseline: our planners' speed relative to Boost's A*, kept in a file, and how it has changed
// since. Ratios of one run are compared with ratios of another, never times.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"

namespace wend {

/// How many times as fast as Boost a planner is: the geometric mean over maps.
struct SpeedRatios {
  double later = 0;    // queries in a stream of many
  double first = 0;    // the first query of a new planner
  double prepare = 0;  // making the planner, with its index
};

struct BaselineRow {
  std::string planner;  // as typed
  SpeedRatios ratios;
};

struct SpeedBaseline {
  std::string machine;
  std::string commit;
  double tolerance = 0.3;  // a planner may lose this share of a ratio before that counts
  std::size_t sample = 0;  // queries a map
  std::vector<BaselineRow> rows;
};

/// An error names the file and what is wrong with it.
Expected<SpeedBaseline, Error> read_baseline(const std::filesystem::path& file);

/// The text of the file.
std::string baseline_json(const SpeedBaseline& baseline);

/// A table of now, baseline and change for people, and whether a planner got slower than the
/// tolerance allows.
struct BaselineVerdict {
  std::string table;
  bool slower = false;
};

/// `now` has the planners of the baseline, in their order.
BaselineVerdict compared(const SpeedBaseline& baseline, const std::vector<BaselineRow>& now);

}  // namespace wend
