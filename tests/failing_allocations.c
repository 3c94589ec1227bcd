/* Every allocation fails once: the C interface answers WEND_MEMORY_LIMIT or plans without it, leaks nothing, and its
   session stays usable. This program has malloc() and mmap() of its own, which fail when they are told to.

     failing_allocations          a share of the allocations of each configuration
     failing_allocations --all    all of them */

#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "wend/wend.h"

/* What the allocator does. */
static int counting = 0;
static long allocations = 0;
static long failing = 0;     /* the number of the allocation that fails; 0: none */
static int failing_ever = 0; /* all later ones fail too */
static long blocks = 0;      /* allocated while counting, and not yet freed */

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);
extern void __libc_free(void*);

static int fails(void) {
  if (!counting) return 0;
  ++allocations;
  if (failing == 0 || allocations < failing || (allocations > failing && !failing_ever)) return 0;
  errno = ENOMEM;
  return 1;
}

static void* counted(void* block) {
  if (counting && block != NULL) ++blocks;
  return block;
}

void* malloc(size_t size) { return fails() ? NULL : counted(__libc_malloc(size)); }

void* calloc(size_t count, size_t size) {
  return fails() ? NULL : counted(__libc_calloc(count, size));
}

void* realloc(void* block, size_t size) {
  if (fails()) return NULL;
  void* const moved = __libc_realloc(block, size);
  return block == NULL ? counted(moved) : moved;
}

void* aligned_alloc(size_t alignment, size_t size) {
  return fails() ? NULL : counted(__libc_memalign(alignment, size));
}

void* memalign(size_t alignment, size_t size) { return aligned_alloc(alignment, size); }

int posix_memalign(void** block, size_t alignment, size_t size) {
  *block = aligned_alloc(alignment, size);
  return *block == NULL ? ENOMEM : 0;
}

void free(void* block) {
  if (counting && block != NULL) --blocks;
  __libc_free(block);
}

void* mmap(void* address, size_t size, int protection, int flags, int file, off_t offset) {
  static void* (*system_mmap)(void*, size_t, int, int, int, off_t) = NULL;
  if (system_mmap == NULL) *(void**)&system_mmap = dlsym(RTLD_NEXT, "mmap");
  return fails() ? MAP_FAILED : system_mmap(address, size, protection, flags, file, offset);
}

/* What is planned: a map with rooms, with each planner, with and without costs. */
enum { kSide = 24 };
static uint8_t cells[kSide * kSide];
static double terrain[kSide * kSide];

static const char* const kPlanners[] = {
    "astar",     "dijkstra",         "alt",        "ara_star",        "jps",          "hub_labels",
    "any_angle", "euclidean_labels", "theta_star", "lazy_theta_star", "greedy",       "bfs",
    "dfs",       "random_walk",      "replanner",  "d_star_lite",     "hybrid_astar", "lattice",
    "car"};
enum { kPlannerCount = sizeof kPlanners / sizeof *kPlanners };

struct configuration {
  const char* planner;
  int costs;
};

static struct configuration configuration_of(int number) {
  const struct configuration configuration = {kPlanners[number / 2], number % 2};
  return configuration;
}

static void make_world(void) {
  for (int i = 0; i < kSide * kSide; ++i) {
    const int x = i % kSide;
    const int y = i / kSide;
    cells[i] = (x == 12 && y != 4 && y != 5 && y != 17) || (y == 11 && x % 11 > 2) ? 1 : 0;
    terrain[i] = 1 + (x * 7 + y * 3) % 5;
  }
}

/* What went wrong in the runs, apart from allocations. */
static int faults = 0;
static int warming =
    0; /* the first run makes what lives as long as the program, which counts as not freed */

static void fault(const char* what, const char* message) {
  if (warming) return;
  ++faults;
  printf("  allocation %ld, %s: %s\n", failing, what, message);
}

/* A status and what comes with it belong together. */
static int good(wend_status status, const wend_error* error, const char* call) {
  if (status != error->status) fault(call, "the status is not that of wend_error");
  if (status != WEND_OK && error->message[0] == '\0') fault(call, "no message");
  if (status == WEND_INTERNAL_ERROR) fault(call, error->message);
  return status == WEND_OK;
}

static wend_map* make_map(int costs) {
  wend_map* map = NULL;
  wend_error error;
  wend_map_options options;
  wend_map_options_init(&options, sizeof options);
  options.resolution = 0.5;
  if (costs) {
    options.terrain = terrain;
    options.terrain_count = kSide * kSide;
  }
  good(wend_map_create(cells, sizeof cells, kSide, kSide, &options, &map, &error), &error, "map");
  return map;
}

static wend_robot* make_robot(const char* planner) {
  static const wend_point kCorners[] = {{.4, .2}, {.4, -.2}, {-.1, -.2}, {-.1, .2}};
  wend_robot* robot = NULL;
  wend_error error;
  wend_robot_options options;
  wend_robot_options_init(&options, sizeof options);
  if (strcmp(planner, "hybrid_astar") == 0 || strcmp(planner, "lattice") == 0) {
    options.corners = kCorners;
    options.corner_count = 4;
  } else {
    options.radius = 0.1;
  }
  good(wend_robot_create(&options, &robot, &error), &error, "robot");
  return robot;
}

static wend_request request_of(const char* planner, const wend_pose* goal) {
  wend_request request;
  wend_request_init(&request, sizeof request);
  request.start = (wend_pose){1.2, 1.2, 0};
  request.goals = goal;
  request.goal_count = 1;
  request.planner = planner;
  request.straighten = 1;
  request.spacing = 0.3;
  request.expansions = 600;
  return request;
}

static void edit(wend_session* session) {
  static const uint8_t kWall[] = {1, 1, 1, 1};
  static const double kMud[] = {3, 3, 3, 3};
  wend_error error;
  good(wend_session_edit(session, 7, 7, 2, 2, kWall, 4, &error), &error, "edit");
  good(wend_session_edit_terrain(session, 15, 15, 2, 2, kMud, 4, &error), &error, "edit_terrain");
}

/* Asks all that can be asked of a session. */
static void ask(wend_session* session, const char* planner) {
  const wend_pose goal = {10.2, 10.2, 0};
  const wend_pose blocked = {6.2, 0.2, 0};
  wend_request request = request_of(planner, &goal);
  wend_plan* plan = NULL;
  wend_field* field = NULL;
  wend_pose nearest;
  int32_t fits = 0;
  wend_error error;
  good(wend_session_plan(session, &request, &plan, &error), &error, "plan");
  wend_plan_free(plan);
  edit(session);
  good(wend_session_replan(session, &request, &plan, &error), &error, "replan");
  wend_plan_free(plan);
  good(wend_session_fits(session, &blocked, &fits, &error), &error, "fits");
  good(wend_session_nearest(session, &blocked, &nearest, &error), &error, "nearest");
  if (good(wend_session_field(session, &request, &field, &error), &error, "field")) {
    good(wend_field_plan(field, &request.start, &plan, &error), &error, "field_plan");
    wend_plan_free(plan);
  }
  wend_field_free(field);
  request.start = blocked;
  good(wend_session_plan(session, &request, &plan, &error), &error, "plan from a blocked start");
  wend_plan_free(plan);
}

/* Once memory is there again, the session plans as a new one does. */
static void check_usable(wend_session* session, const wend_map* map) {
  const wend_pose goal = {10.2, 10.2, 0};
  const wend_request request = request_of("astar", &goal);
  wend_session* fresh = NULL;
  wend_plan* plan = NULL;
  wend_plan* expected = NULL;
  wend_error error;
  good(wend_session_set_robot(session, NULL, &error), &error, "set_robot");
  good(wend_session_set_map(session, map, &error), &error, "set_map");
  good(wend_session_create(map, NULL, NULL, &fresh, &error), &error, "session");
  good(wend_session_plan(fresh, &request, &expected, &error), &error, "plan of a new session");
  if (!good(wend_session_plan(session, &request, &plan, &error), &error, "plan afterwards")) {
    fault("plan afterwards", error.message);
  } else if (wend_plan_cost(plan) != wend_plan_cost(expected)) {
    fault("plan afterwards", "another cost than that of a new session");
  }
  wend_plan_free(plan);
  wend_plan_free(expected);
  wend_session_free(fresh);
}

/* A session from its beginning to its end, in which one allocation, or all from one on, fail. */
static void run(struct configuration configuration, long which, int ever) {
  wend_session* session = NULL;
  wend_error error;
  failing = which;
  failing_ever = ever;
  allocations = 0;
  blocks = 0;
  counting = 1;
  wend_map* map = make_map(configuration.costs);
  wend_robot* robot = map == NULL ? NULL : make_robot(configuration.planner);
  if (robot != NULL) {
    good(wend_session_create(map, robot, NULL, &session, &error), &error, "session");
  }
  if (session != NULL) ask(session, configuration.planner);
  failing_ever = 0; /* from here on there is memory */
  const long seen = allocations;
  if (session != NULL) check_usable(session, map);
  wend_session_free(session);
  wend_robot_free(robot);
  wend_map_free(map);
  counting = 0;
  allocations = seen;
  if (blocks != 0) fault("at the end", "memory was not freed");
}

/* Where a run stands, for the case that it ends the process. */
static long* standing;

/* The runs of a configuration, in a process of its own. */
static int check_all(int number, long most) {
  const struct configuration configuration = configuration_of(number);
  warming = 1;
  run(configuration, 0, 0);
  warming = 0;
  run(configuration, 0, 0);
  const long total = allocations;
  const long stride = most > 0 && total > most ? total / most : 1;
  long runs = 0;
  for (int ever = 0; ever < 2; ++ever) {
    for (long which = 1 + (number + ever) % stride; which <= total; which += stride) {
      *standing = which;
      run(configuration, which, ever);
      ++runs;
    }
  }
  printf("%s%s: %ld allocations, %ld runs, %d faults\n", configuration.planner,
         configuration.costs ? " with costs" : "", total, runs, faults);
  return faults;
}

/* Did the process of a configuration end as it should? */
static int passes(int number, long most) {
  fflush(stdout);
  const pid_t process = fork();
  if (process == 0) {
    const int failed = check_all(number, most) != 0;
    fflush(stdout);
    _exit(failed);
  }
  int status = 0;
  waitpid(process, &status, 0);
  if (WIFSIGNALED(status)) {
    printf("%s: signal %d at allocation %ld\n", configuration_of(number).planner, WTERMSIG(status),
           *standing);
  }
  return status == 0;
}

int main(int argc, char** argv) {
  const int all = argc > 1 && strcmp(argv[1], "--all") == 0;
  const long most = all ? 0 : 60;
  int failed = 0;
  standing =
      mmap(NULL, sizeof *standing, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  make_world();
  for (int number = 0; number < 2 * kPlannerCount; ++number) failed += !passes(number, most);
  return failed == 0 ? 0 : 1;
}
