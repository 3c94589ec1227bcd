#pragma once

// Baseline: ratios of what a suite measured to its yardstick, kept in a file, and how they have changed since. Ratios of
// one run are compared with ratios of another, never times.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"

namespace wend {

/// How many times as fast as the yardstick something is.
struct BaselineRow {
  std::string subject;  // "astar:weight=2"
  std::string measure;  // "first query"
  double ratio;
};

struct Baseline {
  std::string machine;
  std::string commit;
  std::string times;       // what the ratios are: "times as fast as ..."
  double tolerance = 0.3;  // this share of a ratio may be lost before that counts
  std::size_t sample = 0;  // queries a map
  std::vector<BaselineRow> rows;
};

/// An error names the file and what is wrong with it.
Expected<Baseline, Error> read_baseline(const std::filesystem::path& file);

/// The text of the file.
std::string baseline_json(const Baseline& baseline);

/// A table of now, baseline and change for people, and whether something got slower than the tolerance allows, or was
/// not measured.
struct BaselineVerdict {
  std::string table;
  bool slower = false;
};

/// Rows are found by subject and measure. What the baseline lacks is shown without a comparison.
BaselineVerdict compared(const Baseline& baseline, const std::vector<BaselineRow>& now);

}  // namespace wend
