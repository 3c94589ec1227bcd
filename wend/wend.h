#pragma once

// The C interface: maps, robots, plans and fields of costs, for engines and for other languages.
//
//   wend_map* map = NULL;
//   wend_session* session = NULL;
//   wend_plan* plan = NULL;
//   wend_error error;
//   wend_request request;
//   wend_status status = wend_map_create(cells, sizeof cells, 3, 2, NULL, &map, &error);
//   if (status == WEND_OK) status = wend_session_create(map, NULL, NULL, &session, &error);
//   wend_map_free(map);
//   wend_request_init(&request, sizeof request);
//   request.start = start;
//   request.goals = &goal;
//   request.goal_count = 1;
//   if (status == WEND_OK) status = wend_session_plan(session, &request, &plan, &error);
//   if (status != WEND_OK) report(error.message);
//   for (size_t i = 0; i < wend_plan_pose_count(plan); ++i) drive_to(wend_plan_poses(plan)[i]);
//   wend_plan_free(plan);
//   wend_session_free(session);
//
// Errors: a function that can fail returns a status, WEND_OK (0) if it did not. It also writes the status and
// a sentence into the caller's wend_error, if that is not null. A null pointer, a size that does not fit, NaN
// and infinity are errors (WEND_INVALID_ARGUMENT), never a crash. No C++ exception leaves the library.
//
// Ownership: a function that makes an object writes it to its last parameter but one, null if it failed. The
// caller owns the object and frees it once, with the function of its type; freeing null does nothing. Objects
// do not need each other: a map may be freed as soon as a session has it. No function keeps a pointer that the
// caller passes, unless it is an object of the library.
//
// Units: poses are in metres and radians, in the map's frame. Cell (column, row) of a map covers the points
//
//    origin + rotate(origin.heading, resolution * (column..column + 1, row..row + 1))
//
// Threads: all threads may use a session at the same time. A map, a robot, a plan and a field do not change;
// all threads may read them. Free an object when no other thread uses it.
//
// Growth: structures with a `struct_size` are made by their init function, which sets the defaults and takes
// the size that the caller was compiled with. A structure of another size is an error. New fields of a request have no
// member: wend_request_set() sets them by name. A program that may run
// with another library than that of its header compares wend_abi_version() with WEND_ABI_VERSION first.

#include <stddef.h>
#include <stdint.h>

/// Marks what libwend.so exports.
#if defined(WEND_SHARED)
#define WEND_C_API __attribute__((visibility("default")))
#else
#define WEND_C_API
#endif

/// Grows when a function or a structure changes so that programs must be compiled again. New functions do not
/// change it.
#define WEND_ABI_VERSION 3

#ifdef __cplusplus
extern "C" {
#endif

/// WEND_ABI_VERSION of the library that runs.
WEND_C_API uint32_t wend_abi_version(void);

/// The version of the library that runs: "0.2.0". Static.
WEND_C_API const char* wend_version(void);

/// How a function ended: a value of wend_status_code.
typedef int32_t wend_status;

/// The values of wend_status. Their numbers never change.
enum wend_status_code {
  WEND_OK = 0,                  // it did what was asked
  WEND_START_OUTSIDE = 1,       // the start lies outside the map
  WEND_GOAL_OUTSIDE = 2,        // the goal lies outside the map
  WEND_START_BLOCKED = 3,       // the robot cannot stand on the start
  WEND_GOAL_BLOCKED = 4,        // the robot cannot stand on the goal
  WEND_UNREACHABLE = 5,         // start and goal are both free, and no path joins them
  WEND_STEP_LIMIT = 6,          // a walk used up its steps
  WEND_EXPANSION_LIMIT = 7,     // wend_request.expansions was reached
  WEND_TIME_LIMIT = 8,          // wend_request.seconds passed
  WEND_MEMORY_LIMIT = 9,        // the system had no memory left
  WEND_CANCELLED = 10,          // the search was cancelled
  WEND_UNSUPPORTED_MAP = 11,    // this planner cannot plan on such a map (terrain, size)
  WEND_UNSUPPORTED_QUERY = 12,  // this planner cannot answer such a query
  WEND_INVALID_OPTION = 13,     // an option of a planner or a robot is unknown or out of range
  WEND_INVALID_MAP = 14,     // the parts of a map do not fit together, or a value is out of range
  WEND_INVALID_FILE = 15,    // a file cannot be read, or its content is invalid
  WEND_INDEX_MISSING = 16,   // the planner needs an index, and has none
  WEND_INDEX_MISMATCH = 17,  // the index is damaged or belongs to another map
  WEND_INVALID_ARGUMENT = 100,  // a pointer is null, a number is NaN, a size does not fit
  WEND_INTERNAL_ERROR = 101     // a bug of wend
};

/// "ok", "start_outside", ..., or "unknown" for another number. Static.
WEND_C_API const char* wend_status_name(wend_status status);

/// The size of wend_error.message.
#define WEND_MESSAGE_SIZE 1024

/// What went wrong. The caller's; it needs no init function and never grows.
typedef struct wend_error {
  wend_status status;  // the same as the function returned
  int32_t truncated;   // 1 if the message was cut to fit, else 0
  uint64_t expanded;   // states that a search had expanded until it failed
  uint64_t generated;  // states that it had reached
  char message
      [WEND_MESSAGE_SIZE];  // a sentence in UTF-8 without a full stop, 0 behind it; "" for WEND_OK
} wend_error;

/// A position and a heading. A library function that takes one reads it through a pointer.
typedef struct wend_pose {
  double x;        // metres
  double y;        // metres
  double heading;  // radians, from +x to +y
} wend_pose;

/// A position.
typedef struct wend_point {
  double x;  // metres
  double y;  // metres
} wend_point;

/// A map: cells that are free, occupied or unknown, and how they lie in the world.
typedef struct wend_map wend_map;

/// What the bytes of wend_map_create() mean.
enum wend_cells {
  WEND_CELLS_STATE = 0,  // 0 free, 1 occupied, 2 unknown; another value is an error
  WEND_CELLS_MASK = 1,   // 0 free, everything else occupied
  WEND_CELLS_ROS = 2     // nav_msgs/OccupancyGrid: 0 to 100; other values, such as -1, unknown
};

/// How wend_map_create() reads cells.
typedef struct wend_map_options {
  size_t struct_size;     // sizeof(wend_map_options)
  double resolution;      // metres a cell, > 0; default 1
  wend_pose origin;       // the corner of cell (0, 0) and the direction of its row; default 0
  int32_t cells;          // a value of wend_cells; default WEND_CELLS_STATE
  int32_t occupied_from;  // WEND_CELLS_ROS: the least occupied value, 1 to 100; default 65
  const double*
      terrain;  // cost of a unit of length in each cell, finite, >= 1; default null: 1 everywhere
  size_t terrain_count;  // the number of these multipliers, which is that of the cells; default 0
} wend_map_options;

/// Sets the defaults. `struct_size` is sizeof(wend_map_options).
WEND_C_API wend_status wend_map_options_init(wend_map_options* options, size_t struct_size);

/// Makes a map from `size` = `width` * `height` bytes, row by row; the first is cell (0, 0). The bytes are
/// copied. `options` may be null. Free the map with wend_map_free(). Fails with WEND_INVALID_ARGUMENT or
/// WEND_INVALID_MAP. O(cells).
WEND_C_API wend_status wend_map_create(const uint8_t* cells, size_t size, int32_t width,
                                       int32_t height, const wend_map_options* options,
                                       wend_map** map, wend_error* error);

/// Loads a map file: a ROS map.yaml, a MovingAI map, a text grid or an image. wend_map_note() has what is unusual in
/// it. Maps without a resolution have
/// 1 m a cell, and their first row is on top. Free the map with wend_map_free(). Fails with WEND_INVALID_FILE.
WEND_C_API wend_status wend_map_load(const char* file, wend_map** map, wend_error* error);

/// The same from the bytes of a file. `name` is a name for errors, whose extension decides the format:
/// "office.map". The image of a map.yaml is searched for in the working folder.
WEND_C_API wend_status wend_map_parse(const void* bytes, size_t size, const char* name,
                                      wend_map** map, wend_error* error);

/// Makes a map from a nav_msgs/OccupancyGrid: `size` = `width` * `height` values, row by row. Values from
/// `occupied_from` (1 to 100) to 100 are occupied, lower ones v are free and cost 1 + `cost_factor` v / 100 times
/// their length, all others are unknown. `origin` may be null: 0. Free the map with wend_map_free(). Fails with
/// WEND_INVALID_ARGUMENT, WEND_INVALID_MAP, or WEND_INVALID_OPTION for a factor that is not in 0..1e6. O(cells).
WEND_C_API wend_status wend_map_from_occupancy(const int8_t* values, size_t size, int32_t width,
                                               int32_t height, double resolution,
                                               const wend_pose* origin, int32_t occupied_from,
                                               double cost_factor, wend_map** map,
                                               wend_error* error);

/// The same from a costmap of costmap_2d: 253 and 254 are occupied, 255 is unknown, and lower costs v are free and
/// cost 1 + `cost_factor` v / 252 times their length.
WEND_C_API wend_status wend_map_from_costmap(const uint8_t* costs, size_t size, int32_t width,
                                             int32_t height, double resolution,
                                             const wend_pose* origin, double cost_factor,
                                             wend_map** map, wend_error* error);

/// Loads a mask: "FILE" or "keepout:FILE", whose occupied cells are zones to keep out of, or "speed:FILE", whose
/// values are speed limits in percent. Free the mask with wend_map_free(). Fails with WEND_INVALID_FILE or
/// WEND_INVALID_OPTION.
WEND_C_API wend_status wend_mask_load(const char* mask, wend_map** map, wend_error* error);

/// Makes a copy of a map under a mask: occupied cells of the mask are blocked, and costs of its free cells
/// multiply those of the map. The mask may lie anywhere on the map. Free the copy with wend_map_free(). Fails with
/// WEND_INVALID_MAP if the mask does not touch the map. O(cells).
WEND_C_API wend_status wend_map_masked(const wend_map* map, const wend_map* mask, wend_map** masked,
                                       wend_error* error);

/// Makes a copy of a map with other costs of a unit of length: `count` multipliers, one for each cell, finite and
/// at least 1, row by row. Free the copy with wend_map_free(). Fails with WEND_INVALID_ARGUMENT or
/// WEND_INVALID_MAP. O(cells).
WEND_C_API wend_status wend_map_with_terrain(const wend_map* map, const double* terrain,
                                             size_t count, wend_map** changed, wend_error* error);

/// The cost of a unit of length in cell (x, y), finite and at least 1. `context` is the caller's.
typedef double (*wend_cost_function)(int32_t x, int32_t y, void* context);

/// The same with `cost_of(x, y, context)` for each cell, called once, row by row.
WEND_C_API wend_status wend_map_with_costs(const wend_map* map, wend_cost_function cost_of,
                                           void* context, wend_map** changed, wend_error* error);

/// The number of columns; 0 for null.
WEND_C_API int32_t wend_map_width(const wend_map* map);
/// The number of rows; 0 for null.
WEND_C_API int32_t wend_map_height(const wend_map* map);
/// Metres a cell; 0 for null.
WEND_C_API double wend_map_resolution(const wend_map* map);
/// Writes the corner of cell (0, 0) and the direction of its row to `origin`.
WEND_C_API wend_status wend_map_origin(const wend_map* map, wend_pose* origin, wend_error* error);

/// The number of notes on a map or mask from a file: what is legal there, but unusual or probably not meant, such as
/// thresholds by which the unknown grey of map savers is free ground. 0 for maps from memory, copies, and null.
WEND_C_API size_t wend_map_note_count(const wend_map* map);
/// A note, a sentence for people. Valid until the map is freed; null for null and for an index out of range.
WEND_C_API const char* wend_map_note(const wend_map* map, size_t index);

/// Frees a map. Sessions that use it keep what they need.
WEND_C_API void wend_map_free(wend_map* map);

/// A robot: its shape, and the distance that it likes to keep.
typedef struct wend_robot wend_robot;

/// The robot that wend_robot_create() makes: the shape of `footprint` if that is set, else a polygon if it has corners,
/// else a disc.
typedef struct wend_robot_options {
  size_t struct_size;  // sizeof(wend_robot_options)
  double radius;       // metres, >= 0; 0 with corners; default 0: a point
  const wend_point*
      corners;          // in the robot's own coordinates, +x ahead, base point (0, 0); default null
  size_t corner_count;  // 3 to 4096, or 0
  double clearance_distance;  // metres from obstacles within which cells cost more; default 0: off
  double clearance_cost;      // extra cost of a cell where the robot touches, >= 0; default 4
  const char*
      footprint;  // the shape as text, in metres, in place of radius and corners: "disc:0.2",
                  // "rect:0.8x0.5,0.2" (length, width, how far its centre lies ahead), or
                  // corners "0.4,0.2;0.4,-0.2;-0.3,0"; default null
} wend_robot_options;

/// Sets the defaults. `struct_size` is sizeof(wend_robot_options).
WEND_C_API wend_status wend_robot_options_init(wend_robot_options* options, size_t struct_size);

/// Makes a robot. The corners are copied; they are those of a simple polygon, in either orientation, that need not
/// contain the base point. Repeated corners in a row count once.
/// Free the robot with wend_robot_free(). Fails with WEND_INVALID_ARGUMENT or WEND_INVALID_OPTION.
WEND_C_API wend_status wend_robot_create(const wend_robot_options* options, wend_robot** robot,
                                         wend_error* error);

/// Frees a robot.
WEND_C_API void wend_robot_free(wend_robot* robot);

/// A map with a robot on it, and planners that keep what they have prepared.
typedef struct wend_session wend_session;

/// What counts as free. By default unknown cells do not; nor does the outside, but of a map file in cells.
enum wend_policy {
  WEND_POLICY_DEFAULT = 0,  // as above
  WEND_POLICY_BLOCKED = 1,  // an obstacle
  WEND_POLICY_FREE = 2      // free
};

/// What is free for the robot of a session.
typedef struct wend_session_options {
  size_t struct_size;  // sizeof(wend_session_options)
  int32_t unknown;     // a value of wend_policy, for unknown cells
  int32_t outside;     // a value of wend_policy: may the robot's shape hang over the map's edge?
} wend_session_options;

/// Sets the defaults. `struct_size` is sizeof(wend_session_options).
WEND_C_API wend_status wend_session_options_init(wend_session_options* options, size_t struct_size);

/// Makes a session. `robot` may be null: a point. `options` may be null. O(1); the first call that needs
/// distances to obstacles computes them, in O(cells). Free the session with wend_session_free().
WEND_C_API wend_status wend_session_create(const wend_map* map, const wend_robot* robot,
                                           const wend_session_options* options,
                                           wend_session** session, wend_error* error);

/// Replaces the map. Calls that have begun end on the old one.
WEND_C_API wend_status wend_session_set_map(wend_session* session, const wend_map* map,
                                            wend_error* error);

/// Changes a box of cells: `states` are `size` = `width` * `height` bytes as WEND_CELLS_STATE has them, row by
/// row; the first is for cell (x, y). Repairs what depends on these cells, and planners keep the rest of what
/// they have prepared; one with an index fails with WEND_INDEX_MISMATCH from then on. Calls that have begun
/// end on the old map. Fails with WEND_INVALID_ARGUMENT, or with WEND_INVALID_MAP if the box reaches beyond
/// the map, and changes nothing then. O(cells near the box), but O(cells) while another call uses the map.
WEND_C_API wend_status wend_session_edit(wend_session* session, int32_t x, int32_t y, int32_t width,
                                         int32_t height, const uint8_t* states, size_t size,
                                         wend_error* error);

/// The same for costs: `terrain` are `count` = `width` * `height` multipliers of a unit of length, finite and at
/// least 1, row by row; the first is for cell (x, y). Cells stay free, blocked or unknown. Fails with
/// WEND_INVALID_ARGUMENT or WEND_INVALID_MAP.
WEND_C_API wend_status wend_session_edit_terrain(wend_session* session, int32_t x, int32_t y,
                                                 int32_t width, int32_t height,
                                                 const double* terrain, size_t count,
                                                 wend_error* error);

/// Replaces the robot; null: a point. Calls that have begun end with the old one.
WEND_C_API wend_status wend_session_set_robot(wend_session* session, const wend_robot* robot,
                                              wend_error* error);

/// Writes 1 to `fits` if the robot may stand at the pose, else 0. Exact up to rounding.
WEND_C_API wend_status wend_session_fits(wend_session* session, const wend_pose* pose,
                                         int32_t* fits, wend_error* error);

/// Writes the nearest pose with the same heading at which the robot fits to `nearest`; `pose` itself if it
/// does. Fails with WEND_UNSUPPORTED_QUERY if there is none.
WEND_C_API wend_status wend_session_nearest(wend_session* session, const wend_pose* pose,
                                            wend_pose* nearest, wend_error* error);

/// Frees a session. Its plans and fields stay.
WEND_C_API void wend_session_free(wend_session* session);

/// A path and its cost.
typedef struct wend_plan wend_plan;

/// Receives a path of an anytime planner, on the thread that plans. The plan is the library's, valid until the
/// function returns; its path is as the planner found it. Returns 0 to go on; another number ends the search, and this
/// path is the answer. The function must not use the session.
typedef int32_t (*wend_solution_function)(const wend_plan* plan, void* context);

/// A flag that ends calls: see wend_request.cancel.
typedef struct wend_cancel wend_cancel;

/// Makes a flag that is not set. Free it with wend_cancel_free(), after the calls that it is for.
WEND_C_API wend_status wend_cancel_create(wend_cancel** cancel, wend_error* error);
/// Sets the flag (1) or clears it (0); nothing for null. Any thread may call it at any time, and so may a signal
/// handler.
WEND_C_API void wend_cancel_set(wend_cancel* cancel, int32_t set);
/// Frees a flag.
WEND_C_API void wend_cancel_free(wend_cancel* cancel);

/// A query: from where to where, and how.
typedef struct wend_request {
  size_t struct_size;        // sizeof(wend_request)
  wend_pose start;           // planners on cells ignore the heading
  const wend_pose* goals;    // the cheapest is found; a heading of NaN: any
  size_t goal_count;         // 1 to 1,000,000
  double tolerance;          // metres, >= 0: how far from its goal a path may end; default 0
  double heading_tolerance;  // radians, >= 0: the same for the heading; default 0
  const char* planner;       // a planner and its options: "astar:weight=1.5"; default "astar"
  uint64_t expansions;       // the most states to expand; default UINT64_MAX
  double seconds;      // of the whole call, with all that it has to make, >= 0; default infinity
  double spacing;      // metres, of the poses along the path; default 0: where the planner has them
  int32_t straighten;  // 1: joins cells by lines along which the robot fits; default 0
  int32_t explain;     // 1: says why there is no path, in O(cells log cells); default 1
  wend_solution_function on_solution;  // receives each path of wend_session_plan(); default null
  void* context;                       // what it receives besides; default null
  double keep;  // >= 0: the share by which another path must be cheaper than the rest of the last
                // one for wend_session_replan() to take it; default 0
  double
      escape;  // metres, >= 0: the longest way out of a start where the robot does not fit, along which it
               // never overlaps more of what blocks it; the path begins with it. Default 0: none
  int32_t
      closest;  // 1: if no path reaches a goal, ends at the reachable place nearest to one; default 0
  int32_t
      nearest;  // 1: moves blocked ends, and goals that no path reaches, to the nearest place; default 0
  double
      nearest_limit;  // metres, >= 0: how far at most; default NaN: 1, on a map without a resolution any distance
  const wend_cancel*
      cancel;  // ends the call with WEND_CANCELLED when another thread sets it; default null
  double by_name[32];  // the fields without a member, which wend_request_set() sets; NaN: unset
} wend_request;

/// Sets the defaults. `struct_size` is sizeof(wend_request). Start and goals have none.
WEND_C_API wend_status wend_request_init(wend_request* request, size_t struct_size);

/// Sets a field by name: one with a member ("tolerance", "nearest": 0 or 1), or one that a later library added to the
/// list, so that the structure keeps its size. Names are those of wend_request_field_at() and their older ones. Fails
/// with WEND_INVALID_OPTION for an unknown name, with the most similar one in the message, and for a value that is not
/// in the field's range.
WEND_C_API wend_status wend_request_set(wend_request* request, const char* name, double value,
                                        wend_error* error);

/// A field of a request. The texts belong to the library and stay.
typedef struct wend_field_info {
  const char* name;      // "goal_tolerance"
  const char* unit;      // "m", "rad", "s", or ""
  const char* help;      // what it is, without a full stop
  int32_t flag;          // 1 if its values are 0 and 1 only
  double least;          // the least value
  double greatest;       // the greatest value; may be infinite
  double default_value;  // NaN where it has none
} wend_field_info;

/// The number of fields that wend_request_set() knows.
WEND_C_API size_t wend_request_field_count(void);
/// Writes what is known of a field. Fails with WEND_INVALID_ARGUMENT for an index of wend_request_field_count() or more.
WEND_C_API wend_status wend_request_field_at(size_t index, wend_field_info* info);

/// Plans. If there is no path, the status says what happened, the message where, why and what would help.
/// Free the plan with wend_plan_free().
WEND_C_API wend_status wend_session_plan(wend_session* session, const wend_request* request,
                                         wend_plan** plan, wend_error* error);

/// Plans like wend_session_plan(), for a robot that drives while its map changes. What is left of the path that the
/// last call answered, from the robot's place on, is answered again unless another path is cheaper by more than
/// wend_request.keep: if it is free on the present map, is for the same planner and goals, and the robot is no farther
/// from it than two cells, or 0.3 m if that is more. Planners from cell to cell that are optimal and need no index are
/// replaced by "replanner" with the same moves, which keeps what it found for the next call and repairs it after
/// edits; planners that resume do so themselves, all others plan anew.
WEND_C_API wend_status wend_session_replan(wend_session* session, const wend_request* request,
                                           wend_plan** plan, wend_error* error);

/// The number of poses, at least 1; 0 for null.
WEND_C_API size_t wend_plan_pose_count(const wend_plan* plan);
/// The poses from start to goal. Valid until the plan is freed; null for null. A pose on cells heads for the
/// next one.
WEND_C_API const wend_pose* wend_plan_poses(const wend_plan* plan);
/// The gears of the pieces between the poses, one fewer than poses: 1 ahead, -1 in reverse, 0 for a turn in place. A
/// piece between two poses is the arc that ends at the second with its heading, or a turn in place or a step to the
/// side. Valid until the plan is freed; null for null.
WEND_C_API const int32_t* wend_plan_gears(const wend_plan* plan);
/// How far the path's first pose is from the start that was asked for, in metres: 0 wherever the robot can go from there
/// to the middle of the cell, where the path of a planner on cells begins otherwise; planners on lattices begin at a
/// vertex. NaN for null.
WEND_C_API double wend_plan_start_shift(const wend_plan* plan);
/// The same for the last pose and the goal that it is nearest to, tolerance included. 0 for a plan of a field.
WEND_C_API double wend_plan_goal_shift(const wend_plan* plan);
/// The cost of the path as the planner found it, before it was straightened: cells, times terrain. NaN for null.
WEND_C_API double wend_plan_cost(const wend_plan* plan);
/// The cost is at most this many times the cheapest one: 1 for an optimal path, infinity without a guarantee.
/// NaN for null.
WEND_C_API double wend_plan_bound(const wend_plan* plan);
/// The length of the path in metres; NaN for null.
WEND_C_API double wend_plan_length(const wend_plan* plan);
/// 1 for what was left of the path that wend_session_replan() had answered before, else 0; 0 for null.
WEND_C_API int32_t wend_plan_kept(const wend_plan* plan);
/// The states that the search expanded; 0 for null.
WEND_C_API uint64_t wend_plan_expanded(const wend_plan* plan);
/// The states that the search reached; 0 for null.
WEND_C_API uint64_t wend_plan_generated(const wend_plan* plan);

/// The number of metrics that wend_plan_metric() knows: of the path, then of its search.
WEND_C_API size_t wend_metric_count(void);
/// The name of a metric: "length", "turning", "smallest_clearance", "expanded", ...; null for an index of
/// wend_metric_count() or more.
WEND_C_API const char* wend_metric_name(size_t index);
/// Its unit: "m", "rad", or "" for a count; null as above.
WEND_C_API const char* wend_metric_unit(size_t index);
/// What it is, in a sentence without its full stop; null as above.
WEND_C_API const char* wend_metric_help(size_t index);
/// Writes a metric of the plan to `value`; infinity for the turning radius of a line, and for the clearance if nothing
/// is near. The first call measures the path, in O(cells). Fails with WEND_INVALID_OPTION for an unknown name.
WEND_C_API wend_status wend_plan_metric(const wend_plan* plan, const char* name, double* value,
                                        wend_error* error);

/// The length in metres of the way out that the path begins with (wend_request.escape); 0 without one, NaN for null.
WEND_C_API double wend_plan_lead_out_length(const wend_plan* plan);
/// How many poses of that way come before the first one where the robot fits; 0 without one, and for null.
WEND_C_API size_t wend_plan_lead_out_pose_count(const wend_plan* plan);
/// Why the robot does not fit at the start; "" without a way out. Valid until the plan is freed; null for null.
WEND_C_API const char* wend_plan_lead_out_reason(const wend_plan* plan);
/// The distance in metres from the path's end to the nearest goal that was asked for: 0 if a goal was reached. NaN if
/// neither wend_request.closest was set nor a goal was moved because no path reaches it, and for null.
WEND_C_API double wend_plan_remaining(const wend_plan* plan);

/// Frees a plan.
WEND_C_API void wend_plan_free(wend_plan* plan);

/// The cost from every cell to the nearest goal.
typedef struct wend_field wend_field;

/// Computes the field of the request's goals, for the moves of its planner, which steps from cell to cell.
/// Start, spacing, straighten and explain are ignored. O(cells log cells); the field of the same goals on the
/// same map is kept. Free it with wend_field_free().
WEND_C_API wend_status wend_session_field(wend_session* session, const wend_request* request,
                                          wend_field** field, wend_error* error);

/// The number of columns; 0 for null.
WEND_C_API int32_t wend_field_width(const wend_field* field);
/// The number of rows; 0 for null.
WEND_C_API int32_t wend_field_height(const wend_field* field);
/// The costs row by row, in cells times terrain; infinity where no path leads to a goal. Valid until the field
/// is freed; null for null.
WEND_C_API const double* wend_field_costs(const wend_field* field);
/// The cost of the cell under a point in metres; infinity outside the map, NaN for null.
WEND_C_API double wend_field_cost_at(const wend_field* field, double x, double y);
/// The states that the search for the field expanded; 0 if the field was kept, and for null.
WEND_C_API uint64_t wend_field_expanded(const wend_field* field);

/// The cheapest path from a pose to a goal, without a search. The heading is ignored. Fails with
/// WEND_START_OUTSIDE, WEND_START_BLOCKED or WEND_UNREACHABLE. O(length). Free the plan with
/// wend_plan_free().
WEND_C_API wend_status wend_field_plan(const wend_field* field, const wend_pose* start,
                                       wend_plan** plan, wend_error* error);

/// Frees a field.
WEND_C_API void wend_field_free(wend_field* field);

#ifdef __cplusplus
}
#endif
