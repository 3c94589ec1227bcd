#pragma once

// Space: a map with a robot for Python: a session of which neither changes.

#include <nanobind/nanobind.h>

#include <memory>

#include "wend/session/session.hpp"

namespace wend::python {

struct Space {
  std::unique_ptr<Session> session;
  Session::View view;

  const FreeSpace& free() const { return view.space; }
  const Frame& frame() const { return view.space.map().frame(); }
};

/// Adds plan() and plan_many().
void bind_planning(nanobind::class_<Space>& space);

}  // namespace wend::python
