/* Uses every function of wend.h from C, as a program that links libwend does. C++ tests in wend/c/ check the
   answers; this says that a C compiler takes the header and that the library exports what it declares. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "wend/wend.h"

static int failures = 0;

#define CHECK(condition)                                              \
  do {                                                                \
    if (!(condition)) {                                               \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                     \
    }                                                                 \
  } while (0)

static const uint8_t kCells[] = {0, 0, 0, 0, 0, /* */
                                 0, 1, 1, 1, 0, /* */
                                 0, 0, 0, 0, 0};

/* A map of 0.5 m a cell, with a wall in the middle. */
static wend_map* make_map(void) {
  wend_map* map = NULL;
  wend_map_options options;
  wend_error error;
  CHECK(wend_map_options_init(&options, sizeof options) == WEND_OK);
  options.resolution = 0.5;
  options.cells = WEND_CELLS_MASK;
  CHECK(wend_map_create(kCells, sizeof kCells, 5, 3, &options, &map, &error) == WEND_OK);
  CHECK(error.message[0] == '\0');
  return map;
}

static void check_map(void) {
  wend_map* map = make_map();
  wend_pose origin = {1, 1, 1};
  CHECK(wend_map_width(map) == 5 && wend_map_height(map) == 3);
  CHECK(wend_map_resolution(map) == 0.5);
  CHECK(wend_map_origin(map, &origin, NULL) == WEND_OK && origin.x == 0 && origin.heading == 0);
  wend_map_free(map);
  CHECK(wend_map_parse("..\n", 3, "m.txt", &map, NULL) == WEND_OK);
  wend_map_free(map);
  CHECK(wend_map_note_count(NULL) == 0 && wend_map_note(NULL, 0) == NULL);
  CHECK(wend_map_parse("P2 2 1 65535 0 254\n", 19, "m.pgm", &map, NULL) == WEND_OK);
  CHECK(wend_map_note_count(map) == 1 && strstr(wend_map_note(map, 0), "almost black") != NULL);
  CHECK(wend_map_note(map, 1) == NULL);
  wend_map_free(map);
  CHECK(wend_map_load("there is no such file.txt", &map, NULL) == WEND_INVALID_FILE);
  CHECK(map == NULL);
}

static double cost_of(int32_t x, int32_t y, void* context) { return 1 + x + *(double*)context * y; }

static void check_costs(void) {
  static const int8_t values[] = {0, 50, 100, -1};
  static const uint8_t costs[] = {0, 126, 254, 255};
  static const double terrain[] = {1, 2, 3, 4};
  double factor = 2;
  wend_map* grid = NULL;
  wend_map* costmap = NULL;
  wend_map* changed = NULL;
  CHECK(wend_map_from_occupancy(values, 4, 2, 2, 0.5, NULL, 65, 4, &grid, NULL) == WEND_OK);
  CHECK(wend_map_from_costmap(costs, 4, 2, 2, 0.5, NULL, 4, &costmap, NULL) == WEND_OK);
  CHECK(wend_map_masked(costmap, grid, &changed, NULL) == WEND_OK && changed != NULL);
  wend_map_free(changed);
  CHECK(wend_map_with_terrain(grid, terrain, 4, &changed, NULL) == WEND_OK && changed != NULL);
  wend_map_free(changed);
  CHECK(wend_map_with_costs(grid, cost_of, &factor, &changed, NULL) == WEND_OK && changed != NULL);
  wend_map_free(changed);
  CHECK(wend_mask_load("speed:there is no such file.yaml", &changed, NULL) == WEND_INVALID_FILE);
  CHECK(changed == NULL);
  wend_map_free(costmap);
  wend_map_free(grid);
}

static wend_robot* make_robot(void) {
  static const wend_point corners[] = {{0.2, 0.1}, {0.2, -0.1}, {-0.2, -0.1}, {-0.2, 0.1}};
  wend_robot* robot = NULL;
  wend_robot_options options;
  CHECK(wend_robot_options_init(&options, sizeof options) == WEND_OK);
  options.corners = corners;
  options.corner_count = 4;
  CHECK(wend_robot_create(&options, &robot, NULL) == WEND_OK);
  return robot;
}

static void check_poses(wend_session* session) {
  const wend_pose wall = {1.25, 0.75, 0};
  wend_pose nearest;
  int32_t fits = 1;
  CHECK(wend_session_fits(session, &wall, &fits, NULL) == WEND_OK && fits == 0);
  CHECK(wend_session_nearest(session, &wall, &nearest, NULL) == WEND_OK);
  CHECK(wend_session_fits(session, &nearest, &fits, NULL) == WEND_OK && fits == 1);
}

static void check_fields(const wend_request* request) {
  size_t i;
  wend_error error;
  wend_field_info info;
  wend_request set = *request;
  CHECK(wend_request_set(&set, "goal_tolerance", 0.2, &error) == WEND_OK && set.tolerance == 0.2);
  CHECK(wend_request_set(&set, "nearest", 1, NULL) == WEND_OK && set.nearest == 1);
  CHECK(wend_request_set(&set, "neerest", 1, &error) == WEND_INVALID_OPTION);
  CHECK(strstr(error.message, "did you mean 'nearest'?") != NULL);
  for (i = 0; i < wend_request_field_count(); ++i) {
    CHECK(wend_request_field_at(i, &info) == WEND_OK && info.help[0] != '\0' && info.unit != NULL);
    CHECK(wend_request_set(&set, info.name, info.default_value, NULL) == WEND_OK);
    CHECK(wend_request_set(&set, info.name, info.least - 1, NULL) == WEND_INVALID_OPTION);
  }
  CHECK(wend_request_field_at(i, &info) == WEND_INVALID_ARGUMENT);
  CHECK(set.tolerance == 0 && set.nearest == 0 && set.expansions == UINT64_MAX);
}

static void check_metrics(const wend_plan* plan) {
  size_t i;
  double value = -1;
  CHECK(wend_plan_metric(plan, "length", &value, NULL) == WEND_OK && fabs(value - 3) < 1e-12);
  for (i = 0; i < wend_metric_count(); ++i) {
    CHECK(wend_plan_metric(plan, wend_metric_name(i), &value, NULL) == WEND_OK && value >= 0);
    CHECK(wend_metric_help(i)[0] != '\0' && wend_metric_unit(i) != NULL);
  }
  CHECK(wend_metric_name(i) == NULL);
}

static void check_plan(wend_session* session, const wend_request* request) {
  wend_plan* plan = NULL;
  wend_error error;
  const wend_pose* poses;
  check_fields(request);
  CHECK(wend_session_plan(session, request, &plan, &error) == WEND_OK);
  CHECK(wend_plan_pose_count(plan) == 7);
  poses = wend_plan_poses(plan);
  CHECK(poses != NULL && poses[0].x == 0.25 && poses[6].x == 2.25);
  CHECK(wend_plan_cost(plan) == 6 && wend_plan_length(plan) == 3 && wend_plan_bound(plan) == 1);
  CHECK(wend_plan_gears(plan)[0] == 1 && wend_plan_gears(plan)[5] == 1);
  CHECK(fabs(wend_plan_start_shift(plan) -
             hypot(request->start.x - poses[0].x, request->start.y - poses[0].y)) < 1e-12);
  CHECK(fabs(wend_plan_goal_shift(plan) -
             hypot(request->goals->x - poses[6].x, request->goals->y - poses[6].y)) < 1e-12);
  CHECK(wend_plan_expanded(plan) > 0 && wend_plan_generated(plan) >= wend_plan_expanded(plan));
  check_metrics(plan);
  wend_plan_free(plan);
  CHECK(wend_session_replan(session, request, &plan, NULL) == WEND_OK);
  CHECK(wend_plan_cost(plan) == 6 && wend_plan_kept(plan) == 0);
  wend_plan_free(plan);
}

static void check_ends(wend_session* session, const wend_request* request) {
  wend_plan* plan = NULL;
  wend_request eased = *request;
  const wend_pose outside = {2.25, -0.6, NAN};
  eased.goals = &outside;
  CHECK(wend_session_plan(session, &eased, &plan, NULL) == WEND_GOAL_OUTSIDE);
  eased.closest = 1;
  eased.escape = 0.25;
  CHECK(wend_session_plan(session, &eased, &plan, NULL) == WEND_OK);
  CHECK(fabs(wend_plan_remaining(plan) - 0.85) < 1e-9);
  CHECK(wend_plan_lead_out_length(plan) == 0 && wend_plan_lead_out_pose_count(plan) == 0);
  CHECK(wend_plan_lead_out_reason(plan)[0] == '\0');
  wend_plan_free(plan);
  eased.nearest = 1;
  eased.nearest_limit = 0.1;
  eased.closest = 0;
  CHECK(wend_session_plan(session, &eased, &plan, NULL) == WEND_GOAL_OUTSIDE);
}

static int32_t take_solution(const wend_plan* plan, void* context) {
  double* last = (double*)context;
  CHECK(wend_plan_cost(plan) <= *last && wend_plan_bound(plan) >= 1);
  *last = wend_plan_cost(plan);
  return 0;
}

static void check_cancel(wend_session* session, const wend_request* request) {
  wend_request stopped = *request;
  wend_cancel* cancel = NULL;
  wend_plan* plan = NULL;
  wend_error error;
  CHECK(wend_cancel_create(&cancel, &error) == WEND_OK);
  stopped.cancel = cancel;
  wend_cancel_set(cancel, 1);
  CHECK(wend_session_plan(session, &stopped, &plan, &error) == WEND_CANCELLED && plan == NULL);
  wend_cancel_set(cancel, 0);
  CHECK(wend_session_plan(session, &stopped, &plan, &error) == WEND_OK);
  wend_plan_free(plan);
  wend_cancel_free(cancel);
}

static void check_solutions(wend_session* session, const wend_request* request) {
  wend_plan* plan = NULL;
  wend_request anytime = *request;
  double last = 1e9;
  anytime.planner = "ara_star:initial_weight=3";
  anytime.on_solution = take_solution;
  anytime.context = &last;
  CHECK(wend_session_plan(session, &anytime, &plan, NULL) == WEND_OK);
  CHECK(wend_plan_cost(plan) == 6 && last == 6 && wend_plan_bound(plan) == 1);
  wend_plan_free(plan);
}

static void check_field(wend_session* session, const wend_request* request) {
  wend_field* field = NULL;
  wend_plan* plan = NULL;
  CHECK(wend_session_field(session, request, &field, NULL) == WEND_OK);
  CHECK(wend_field_width(field) == 5 && wend_field_height(field) == 3);
  CHECK(wend_field_costs(field)[4] == 2 && isinf(wend_field_costs(field)[5 + 2]));
  CHECK(wend_field_cost_at(field, 0.25, 1.25) == 4);
  CHECK(wend_field_expanded(field) == 12);
  CHECK(wend_field_plan(field, &request->start, &plan, NULL) == WEND_OK);
  CHECK(wend_plan_cost(plan) == 6);
  wend_plan_free(plan);
  wend_field_free(field);
}

static void check_session(void) {
  const wend_pose start = {0.25, 0.25, 0};
  const wend_pose goal = {2.25, 1.25, NAN};
  const uint8_t occupied = 1;
  const double dear = 3;
  wend_map* map = make_map();
  wend_robot* robot = make_robot();
  wend_session* session = NULL;
  wend_session_options options;
  wend_request request;
  CHECK(wend_session_options_init(&options, sizeof options) == WEND_OK);
  options.outside = WEND_POLICY_FREE;
  CHECK(wend_session_create(map, robot, &options, &session, NULL) == WEND_OK);
  CHECK(wend_session_set_map(session, map, NULL) == WEND_OK);
  CHECK(wend_session_edit(session, 2, 0, 1, 1, &occupied, 1, NULL) == WEND_OK);
  CHECK(wend_session_edit_terrain(session, 4, 0, 1, 1, &dear, 1, NULL) == WEND_OK);
  CHECK(wend_session_set_map(session, map, NULL) == WEND_OK);
  CHECK(wend_session_set_robot(session, robot, NULL) == WEND_OK);
  wend_robot_free(robot);
  wend_map_free(map);
  CHECK(wend_request_init(&request, sizeof request) == WEND_OK);
  request.start = start;
  request.goals = &goal;
  request.goal_count = 1;
  check_poses(session);
  check_plan(session, &request);
  check_ends(session, &request);
  check_solutions(session, &request);
  check_cancel(session, &request);
  check_field(session, &request);
  wend_session_free(session);
}

/* A car in a yard of 4 m x 4 m. */
static void check_drive(void) {
  static const uint8_t kYard[40 * 40] = {0};
  const wend_pose goal = {2, 3, 3};
  const wend_pose wall = {2, 3.98, 0};
  const wend_pose* poses;
  size_t count;
  wend_map* map = NULL;
  wend_robot* robot = make_robot();
  wend_session* session = NULL;
  wend_plan* plan = NULL;
  wend_map_options options;
  wend_session_options edges;
  wend_request request;
  wend_error error;
  CHECK(wend_map_options_init(&options, sizeof options) == WEND_OK);
  options.resolution = 0.1;
  CHECK(wend_map_create(kYard, sizeof kYard, 40, 40, &options, &map, NULL) == WEND_OK);
  CHECK(wend_session_options_init(&edges, sizeof edges) == WEND_OK);
  edges.outside = WEND_POLICY_BLOCKED;
  CHECK(wend_session_create(map, robot, &edges, &session, NULL) == WEND_OK);
  wend_robot_free(robot);
  wend_map_free(map);
  CHECK(wend_request_init(&request, sizeof request) == WEND_OK);
  request.start.x = request.start.y = 1;
  request.start.heading = 0;
  request.goals = &goal;
  request.goal_count = 1;
  request.planner = "hybrid_astar:turning_radius=0.5";
  request.spacing = 0.05;
  CHECK(wend_session_plan(session, &request, &plan, &error) == WEND_OK);
  count = wend_plan_pose_count(plan);
  poses = wend_plan_poses(plan);
  CHECK(count > 40 && poses[0].x == 1 && poses[0].heading == 0);
  CHECK(fabs(poses[count - 1].y - 3) < 1e-6 && fabs(poses[count - 1].heading - 3) < 1e-6);
  CHECK(wend_plan_length(plan) > 2 && wend_plan_cost(plan) * 0.1 >= wend_plan_length(plan) - 1e-6);
  wend_plan_free(plan);
  request.goals = &wall;
  CHECK(wend_session_plan(session, &request, &plan, &error) == WEND_GOAL_BLOCKED && plan == NULL);
  CHECK(strstr(error.message, "corner reaches over the map's edge") != NULL);
  request.planner = "hybrid_astar:turning_radius=0";
  CHECK(wend_session_plan(session, &request, &plan, &error) == WEND_INVALID_OPTION);
  CHECK(strstr(error.message, "differential") != NULL);
  wend_session_free(session);
}

int main(void) {
  CHECK(wend_abi_version() == WEND_ABI_VERSION);
  CHECK(strlen(wend_version()) > 0);
  CHECK(strcmp(wend_status_name(WEND_UNREACHABLE), "unreachable") == 0);
  check_map();
  check_costs();
  check_session();
  check_drive();
  return failures == 0 ? 0 : 1;
}
