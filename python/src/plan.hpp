#pragma once

// Planned: a path that Python holds, and what found it.

#include <nanobind/nanobind.h>

#include <optional>

#include "wend/session/plan_request.hpp"

namespace wend::python {

/// A plan of a session. The path may have been refined.
struct Planned {
  PlanAnswer answer;

  const Path& path() const { return answer.path(); }
  Adjacency adjacency() const {
    return answer.moves ? answer.moves->adjacency() : Adjacency::edges;
  }
};

/// Options by name, as text.
OptionValues options_of(const nanobind::dict& options);

}  // namespace wend::python
