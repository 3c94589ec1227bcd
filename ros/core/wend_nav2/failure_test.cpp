// SPDX-License-Identifier: Apache-2.0
#include "wend_nav2/failure.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace wend_nav2 {
namespace {

using wend::Status;

TEST(Failure, EveryStatusHasTheKindThatTheTableSays) {
  const std::map<Status, FailureKind> expected{
      {Status::start_outside, FailureKind::start_outside},
      {Status::goal_outside, FailureKind::goal_outside},
      {Status::start_blocked, FailureKind::start_occupied},
      {Status::goal_blocked, FailureKind::goal_occupied},
      {Status::unreachable, FailureKind::no_valid_path},
      {Status::step_limit, FailureKind::timed_out},
      {Status::expansion_limit, FailureKind::timed_out},
      {Status::time_limit, FailureKind::timed_out},
      {Status::memory_limit, FailureKind::other},
      {Status::cancelled, FailureKind::cancelled},
      {Status::unsupported_map, FailureKind::invalid_planner},
      {Status::unsupported_query, FailureKind::invalid_planner},
      {Status::invalid_option, FailureKind::invalid_planner},
      {Status::invalid_map, FailureKind::other},
      {Status::invalid_file, FailureKind::invalid_planner},
      {Status::index_missing, FailureKind::invalid_planner},
      {Status::index_mismatch, FailureKind::invalid_planner}};
  EXPECT_EQ(expected.size(), static_cast<std::size_t>(Status::index_mismatch));
  for (const auto& [status, kind] : expected) {
    EXPECT_EQ(to_string(kind_of(status)), to_string(kind)) << to_string(status);
  }
}

TEST(Failure, KindsHaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (int kind = 0; kind <= static_cast<int>(FailureKind::other); ++kind) {
    names.insert(to_string(static_cast<FailureKind>(kind)));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(FailureKind::other) + 1);
}

TEST(Failure, OfAnErrorKeepsItsSentence) {
  const Failure failure = failure_of({Status::invalid_option, "no such planner", "planner"});
  EXPECT_EQ(failure, (Failure{FailureKind::invalid_planner, "no such planner"}));
}

}  // namespace
}  // namespace wend_nav2
