#pragma once

// Space: a map with a robot for Python: a session of which neither changes.

#include <nanobind/nanobind.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "wend/session/session.hpp"

namespace wend::python {

struct Space {
  std::unique_ptr<Session> session;
  Session::View view;

  const FreeSpace& free() const { return view.space; }
  const Frame& frame() const { return view.space.map().frame(); }
};

/// What Python says of a search besides its ends.
struct SearchSettings {
  PlannerSpec planner;
  Limits limits = {};
};

/// Reads them. `time_limit` in seconds. Throws Failed.
SearchSettings settings_of(std::string planner, const nanobind::dict& options,
                           std::optional<double> time_limit,
                           std::optional<std::int64_t> expansions);

/// The request for a start and a list of goals. Throws Failed.
PlanRequest request_of(nanobind::handle start, const nanobind::list& goals,
                       const SearchSettings& settings);

}  // namespace wend::python
