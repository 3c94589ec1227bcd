// The snippet of wend.h, compiled and run as it stands there.

#include <gtest/gtest.h>

#include "tests/snippets/snippets.hpp"
#include "wend/wend.h"

namespace {

using wend::test::report;
using wend::test::reported;

/// Plans from one corner of these cells, 3 x 2, to the other. Returns the number of poses.
int poses_across(const uint8_t (&cells)[6]) {
  const wend_pose start{0.5, 0.5, 0};
  const wend_pose goal{2.5, 1.5, 0};
  int poses = 0;
  const auto drive_to = [&](const wend_pose& /*pose*/) { ++poses; };
  wend_map* map = NULL;
  wend_session* session = NULL;
  wend_plan* plan = NULL;
  wend_error error;
  wend_request request;
  wend_status status = wend_map_create(cells, sizeof cells, 3, 2, NULL, &map, &error);
  if (status == WEND_OK) status = wend_session_create(map, NULL, NULL, &session, &error);
  wend_map_free(map);
  wend_request_init(&request, sizeof request);
  request.start = start;
  request.goals = &goal;
  request.goal_count = 1;
  if (status == WEND_OK) status = wend_session_plan(session, &request, &plan, &error);
  if (status != WEND_OK) report(error.message);
  for (size_t i = 0; i < wend_plan_pose_count(plan); ++i) drive_to(wend_plan_poses(plan)[i]);
  wend_plan_free(plan);
  wend_session_free(session);
  return poses;
}

TEST(Snippets, OfTheCInterface) {
  reported.clear();
  EXPECT_EQ(poses_across({0, 0, 0, 0, 0, 0}), 3);
  EXPECT_EQ(reported, "");
  EXPECT_EQ(poses_across({0, 1, 0, 0, 1, 3}), 0);
  EXPECT_EQ(reported, "cell (2,1) is 3: 0 (free), 1 (occupied) or 2 (unknown) expected");
}

}  // namespace
