/* Plans in C: a map from bytes, a robot, a path, the costs to its goal, and why there is none. */
#include <math.h>
#include <stdio.h>

#include "wend/wend.h"

/* 0 free, 1 occupied; the first row has the least y. */
static const uint8_t kCells[] = {
    0, 0, 0, 0, 0, 0, 0, 0, /* */
    0, 0, 1, 1, 1, 1, 0, 0, /* */
    0, 0, 1, 1, 1, 1, 0, 0, /* */
    0, 0, 0, 0, 0, 0, 0, 0, /* */
};

static wend_session* make_session(wend_error* error) {
  wend_map* map = NULL;
  wend_robot* robot = NULL;
  wend_session* session = NULL;
  wend_map_options map_options;
  wend_robot_options robot_options;
  wend_map_options_init(&map_options, sizeof map_options);
  wend_robot_options_init(&robot_options, sizeof robot_options);
  map_options.resolution = 0.5;
  robot_options.radius = 0.2;
  if (wend_map_create(kCells, sizeof kCells, 8, 4, &map_options, &map, error) == WEND_OK &&
      wend_robot_create(&robot_options, &robot, error) == WEND_OK) {
    wend_session_create(map, robot, NULL, &session, error);
  }
  wend_map_free(map);
  wend_robot_free(robot);
  return session;
}

static void plan(wend_session* session, const wend_request* request) {
  wend_plan* plan = NULL;
  wend_error error;
  if (wend_session_plan(session, request, &plan, &error) != WEND_OK) {
    printf("%s: %s\n", wend_status_name(error.status), error.message);
    return;
  }
  printf("%.2f m\n", wend_plan_length(plan));
  for (size_t i = 0; i < wend_plan_pose_count(plan); ++i) {
    printf("%.2f %.2f\n", wend_plan_poses(plan)[i].x, wend_plan_poses(plan)[i].y);
  }
  wend_plan_free(plan);
}

static void print_costs(wend_session* session, const wend_request* request) {
  wend_field* field = NULL;
  if (wend_session_field(session, request, &field, NULL) != WEND_OK) return;
  for (int32_t row = 0; row < wend_field_height(field); ++row) {
    const double* costs = wend_field_costs(field) + row * wend_field_width(field);
    for (int32_t column = 0; column < wend_field_width(field); ++column) {
      printf("%5.1f", costs[column]);
    }
    printf("\n");
  }
  wend_field_free(field);
}

int main(void) {
  const wend_pose start = {0.25, 0.75, 0};
  wend_pose goal = {3.75, 1.25, NAN}; /* with any heading */
  wend_error error;
  wend_request request;
  wend_session* session = NULL;
  if (wend_abi_version() != WEND_ABI_VERSION) return 2;
  session = make_session(&error);
  if (session == NULL) return puts(error.message), 2;
  wend_request_init(&request, sizeof request);
  request.start = start;
  request.goals = &goal;
  request.goal_count = 1;
  request.planner = "astar:weight=1";
  request.straighten = 1;
  plan(session, &request);
  print_costs(session, &request);
  goal.x = 1.75;
  plan(session, &request);
  wend_session_free(session);
  return 0;
}
