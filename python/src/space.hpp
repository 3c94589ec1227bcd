#pragma once

// Space: a map with a robot for Python: a session, and its free space as it is now. Every call takes its own
// view(), which an edit in another thread does not change.

#include <nanobind/nanobind.h>

#include <memory>
#include <mutex>
#include <optional>

#include "wend/session/session.hpp"

namespace wend::python {

class Space {
 public:
  /// `session` has a map and a valid robot.
  explicit Space(std::unique_ptr<Session> session, Session::View view)
      : session_(std::move(session)), view_(std::move(view)) {}

  Session& session() const { return *session_; }

  /// The free space as it is now. The caller holds the interpreter lock, which another thread may take meanwhile.
  Session::View view() const;

  /// Edits the map, in place if no view is held elsewhere. The caller does not hold the interpreter lock. Fails as
  /// Session::edit() does.
  Expected<SpaceChange, Error> edit(const MapEdit& edit, const Deadline& deadline);

 private:
  std::unique_ptr<Session> session_;
  mutable std::mutex mutex_;           // guards view_
  std::optional<Session::View> view_;  // nothing while an edit is going on
};

/// Adds plan() and plan_many().
void bind_planning(nanobind::class_<Space>& space);

/// Adds explore().
void bind_exploration(nanobind::class_<Space>& space);

/// Adds explain_drive().
void bind_drives(nanobind::class_<Space>& space);

/// What explanations call the arguments of Python.
Hints hints();

/// Adds edit() and edit_cells().
void bind_edits(nanobind::class_<Space>& space);

}  // namespace wend::python
