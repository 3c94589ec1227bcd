// What planners take from the heap: nothing in a warm query, and at most 20 bytes a cell of their
// own, or 24 a pose. What a follower takes while it drives: nothing. What the C interface does when there is no
// more memory: it says so.

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "conformance/random_map.hpp"
#include "tests/testing/c_objects.hpp"
#include "wend/control/follower.hpp"
#include "wend/control/motion_model.hpp"
#include "wend/generate/generators.hpp"
#include "wend/geometry/curve.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/planners.hpp"
#include "wend/wend.h"

#if defined(__SANITIZE_ADDRESS__)
#define WEND_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define WEND_ADDRESS_SANITIZER 1
#endif
#endif
#ifdef WEND_ADDRESS_SANITIZER
// Of sanitizer/allocator_interface.h, which not every compiler's package has.
extern "C" std::size_t
__sanitizer_get_current_allocated_bytes();  // NOLINT(bugprone-reserved-identifier): its own name
#endif

namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

std::atomic<std::size_t> allocations{0};
std::atomic<std::size_t> first_without_memory{kNone};  // from this allocation on there is no memory

void* counted(std::size_t size, std::size_t alignment) {
  if (++allocations > first_without_memory) throw std::bad_alloc();
  void* const memory =
      alignment <= alignof(std::max_align_t)
          ? std::malloc(size == 0 ? 1 : size)
          : std::aligned_alloc(alignment, (size + alignment - 1) & ~(alignment - 1));
  if (memory == nullptr) std::abort();
  return memory;
}

}  // namespace

// The array and nothrow forms call these. Not inlined, or gcc warns of new that ends in free.
void* operator new(std::size_t size) { return counted(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace wend::test {
namespace {

/// Bytes in use, from malloc and calloc as well as from new.
std::size_t bytes_in_use() {
#ifdef WEND_ADDRESS_SANITIZER
  return __sanitizer_get_current_allocated_bytes();
#else
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
#endif
}

FreeSpace generated(std::string_view kind, int width, int height) {
  return *make_free_space(make_map(kind, width, height, 7).value());
}

std::vector<FreeSpace> maps() {
  return {generated("random", 90, 70), generated("maze", 61, 41), generated("rough", 80, 80),
          generated("car", 40, 40),
          *make_free_space(*make_grid_map(Grid<CellState>(64, 64, CellState::free)))};
}

/// Queries long and short, with one goal and several, some of them without an answer.
std::vector<Query> random_queries(Random& random, const FreeSpace& space) {
  std::vector<Query> queries;
  const auto pose = [&] { return pose_at(random_cell(random, space.width(), space.height())); };
  for (int i = 0; i < 40; ++i) {
    Query query{pose(), {pose()}};
    while (random.chance(0.3)) query.goals.push_back(pose());
    queries.push_back(query);
  }
  return queries;
}

/// A planner, and perhaps options, as people type them.
class Allocation : public ::testing::TestWithParam<std::string> {
 protected:
  const PlannerInfo& info() const { return *planners().find(spec_.name); }
  /// None on a map with terrain, for those that refuse it.
  std::unique_ptr<Planner> make(const FreeSpace& space) const {
    auto made = info().make(space, spec_.options);
    if (made) return *std::move(made);
    EXPECT_EQ(made.error().status, Status::unsupported_map);
    EXPECT_FALSE(space.uniform_terrain());
    return nullptr;
  }

 private:
  PlannerSpec spec_ = parse_planner_specs(GetParam()).value().front();
};

/// Every planner, and those that have memory of their own, or another search, for an option.
std::vector<std::string> specs() {
  std::vector<std::string> specs = planners().names();
  for (const char* const spec :
       {"car:heuristic=obstacles", "car:initial_weight=3", "lattice:initial_weight=3"}) {
    specs.emplace_back(spec);
  }
  return specs;
}

TEST(CountingAllocator, Counts) {
  const std::size_t before = allocations;
  const std::size_t bytes_before = bytes_in_use();
  const auto memory = std::make_unique<std::vector<int>>(1000);
  EXPECT_EQ(allocations - before, 2U);
  EXPECT_GE(bytes_in_use() - bytes_before, 4000U);
}

TEST_P(Allocation, OfAWarmQueryIsNone) {
  int found = 0;
  for (const FreeSpace& space : maps()) {
    Random random(11);
    const auto planner = make(space);
    if (planner == nullptr) continue;
    const std::vector<Query> queries = random_queries(random, space);
    Plan plan;
    for (const Query& query : queries) {
      found += planner->plan(query, plan) == Status::found ? 1 : 0;
    }
    // A planner that learns is warm when it has learned, one that resumes when it has tried its searches.
    const bool changes = info().capabilities.learns || info().capabilities.resumes;
    for (int round = 0; round < (changes ? 50 : 0); ++round) {
      for (const Query& query : queries) planner->plan(query, plan);
    }
    const std::size_t before = allocations;
    for (const Query& query : queries) planner->plan(query, plan);
    EXPECT_EQ(allocations - before, 0U);
  }
  EXPECT_GT(found, 40) << "too few paths to say anything";
}

TEST_P(Allocation, OfAWarmQueryInStepsIsNone) {
  if (!info().capabilities.can_step) GTEST_SKIP() << "it cannot be stepped";
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(64, 64, CellState::free)));
  const auto planner = make(space);
  const Query query = Query::between({3, 60}, {50, 2});
  Plan plan;
  const auto in_steps = [&] {
    auto outcome = planner->begin(query, plan);
    while (!outcome) outcome = planner->step(plan);
    return *outcome;
  };
  in_steps();
  const std::size_t before = allocations;
  const Status outcome = in_steps();
  EXPECT_EQ(allocations - before, 0U);
  EXPECT_EQ(outcome, Status::found);
}

class IdleObserver final : public SearchObserver {
 public:
  void on_generate(const SearchEvent&) override {}
  void on_expand(const SearchEvent&) override {}
  void on_relax(const SearchEvent&) override {}
};

/// The queries are short, so that the frontier, which does not count, is small. A planner that leaps has a map of its
/// own where it leaps, of 5 bytes a cell, and nodes of 16 for a search that is watched.
/// A planner that resumes has more to keep, and says how much.
TEST_P(Allocation, OfAPlannerThatResumesIsWhatItDeclares) {
  if (!info().capabilities.resumes) GTEST_SKIP() << "it does not resume";
  constexpr int kSide = 1000;
  const FreeSpace space =
      *make_free_space(*make_grid_map(Grid<CellState>(kSide, kSide, CellState::free)));
  const auto declared =
      static_cast<std::size_t>(info().bytes_per_cell * static_cast<double>(space.map().size()));
  const std::size_t before = bytes_in_use();
  const auto planner = make(space);
  EXPECT_LE(bytes_in_use() - before, declared) << "when it is made";
  EXPECT_TRUE(planner->plan(Query::between({500, 500}, {503, 503})));
  EXPECT_LE(bytes_in_use() - before, declared + declared / 50) << "after a query";
  EXPECT_GE(bytes_in_use() - before, declared / 2) << "it declares too much";
}

TEST_P(Allocation, OfAPlannerIsAtMost21BytesACellOr24APose) {
  if (info().capabilities.resumes) GTEST_SKIP() << "it keeps more, see above";
  constexpr int kSide = 1000;
  Grid<double> terrain(kSide, kSide, 1);
  terrain[{500, 500}] = 2;
  for (const bool rough : {false, true}) {
    SCOPED_TRACE(rough ? "with terrain" : "uniform");
    const FreeSpace space = *make_free_space(*make_grid_map(
        Grid<CellState>(kSide, kSide, CellState::free), {}, rough ? terrain : Grid<double>()));
    Plan plan;
    Query query = Query::between({500, 500}, {503, 503});
    const std::size_t before = bytes_in_use();
    const auto planner = make(space);
    if (planner == nullptr) continue;
    const bool own_map = info().capabilities.leaps && jumps_on(!rough, info().capabilities);
    const std::size_t most =
        (info().capabilities.vertices == Vertices::corners ? 24 : (own_map ? 21 : 20)) *
        planner->state_count();
    EXPECT_LE(bytes_in_use() - before, most) << "when it is made";
    EXPECT_EQ(planner->plan(query, plan), Status::found);
    EXPECT_LE(bytes_in_use() - before, most) << "after a query";
    IdleObserver idle_observer;
    query.observer = &idle_observer;
    EXPECT_EQ(planner->plan(query, plan), Status::found);
    EXPECT_LE(bytes_in_use() - before, most) << "after a query that was watched";
    planner->update(space);
    EXPECT_LE(bytes_in_use() - before, most) << "after an update";
  }
}

TEST(CurveAllocation, OfWordsIsNone) {
  std::array<Curve, 48> words;
  const std::size_t before = allocations;
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const Pose to{i / 7.0, i / 11.0, i / 13.0};
    found += reeds_shepp_words({1, 2, 3}, to, 1, {}, kNoBound, words);
    found += dubins_words({1, 2, 3}, to, 1, {}, kNoBound, words);
    found += simple_words({1, 2, 3}, to, 1, {}, kNoBound, words);
  }
  EXPECT_EQ(allocations - before, 0U);
  EXPECT_GT(found, 100 * 20);
}

TEST(FollowerAllocation, OfADriveIsNone) {
  const Path path = Path::through({{0, 0, 0}, {5, 0, 0}, {4, 1, -1}, {4, 6, -1}, {6, 9, 0}});
  for (const ControllerInfo& info : controllers()) {
    SCOPED_TRACE(info.name);
    const auto controller = info.make({}).value();
    Follower follower(*controller, {}, {.heading_tolerance = 0.1});
    const Route route(path, {});
    RobotState robot{route.start()};
    follower.follow(route);
    const std::size_t before = allocations;
    FollowerState state = FollowerState::driving;
    while (state == FollowerState::driving) {
      const FollowerStep step = follower.step(robot.pose, 0.05);
      robot = drive({}, robot, step.command, 0.05).to;
      state = step.state;
    }
    EXPECT_EQ(allocations - before, 0U);
    EXPECT_EQ(state, FollowerState::reached);
  }
}

/// Takes all memory but that of so many allocations, while it lives.
class ShortOfMemory {
 public:
  explicit ShortOfMemory(std::size_t left) { first_without_memory = allocations + left; }
  ~ShortOfMemory() { first_without_memory = kNone; }
  ShortOfMemory(const ShortOfMemory&) = delete;
  ShortOfMemory& operator=(const ShortOfMemory&) = delete;
};

/// Calls a function of the C interface with ever more memory, until it succeeds. Returns how often it failed.
template <class Call>
int failures_without_memory(const Call& call) {
  for (std::size_t left = 0;; ++left) {
    wend_error error;
    wend_status status = WEND_OK;
    {
      const ShortOfMemory little(left);
      status = call(&error);
    }
    EXPECT_EQ(error.status, status);
    if (status == WEND_OK) return static_cast<int>(left);
    EXPECT_EQ(status, WEND_MEMORY_LIMIT) << error.message;
    if (status != WEND_MEMORY_LIMIT || left > 100'000) return -1;
  }
}

/// The same for a function that makes an object, which has to be null if there is none.
template <class Object, class Make>
Owned<Object> made_without_memory(const Make& make) {
  Owned<Object> made;
  const int failures = failures_without_memory([&](wend_error* error) {
    auto* object = reinterpret_cast<Object*>(1);
    const wend_status status = make(&object, error);
    if (status == WEND_OK) made.reset(object);
    EXPECT_EQ(object == nullptr, status != WEND_OK);
    return status;
  });
  EXPECT_GT(failures, 0);
  return made;
}

TEST(CInterface, SaysThatThereIsNoMemory) {
  const GridMap cells = generated("random", 30, 20).map();
  const std::vector<std::uint8_t> bytes = bytes_of(cells);
  const auto map = made_without_memory<wend_map>([&](wend_map** out, wend_error* error) {
    return wend_map_create(bytes.data(), bytes.size(), 30, 20, nullptr, out, error);
  });
  made_without_memory<wend_map>([](wend_map** out, wend_error* error) {
    return wend_map_parse("..\n..\n", 6, "m.txt", out, error);
  });
  wend_robot_options options = robot_options();
  options.radius = 0.4;
  const auto robot = made_without_memory<wend_robot>(
      [&](wend_robot** out, wend_error* error) { return wend_robot_create(&options, out, error); });
  const auto session = made_without_memory<wend_session>([&](wend_session** out, wend_error* e) {
    return wend_session_create(map.get(), robot.get(), nullptr, out, e);
  });
  const wend_pose corner{0, 0, 0};
  wend_pose start{};
  EXPECT_GT(failures_without_memory([&](wend_error* error) {
              return wend_session_nearest(session.get(), &corner, &start, error);
            }),
            0);
}

/// Planners that were stopped by an exception leave nothing behind that a later plan could see.
class CInterfaceShortOfMemory : public ::testing::TestWithParam<const char*> {};

TEST_P(CInterfaceShortOfMemory, PlansAsBeforeOnceThereIsMemory) {
  const GridMap cells = generated("random", 30, 20).map();
  const auto session = c_session(c_map(cells).get());
  const auto reference = c_session(c_map(cells).get());
  wend_pose start{};
  wend_pose goal{};
  const wend_pose corner{1.5, 1.5, 0};
  const wend_pose other{28.5, 18.5, 0};
  ASSERT_EQ(wend_session_nearest(session.get(), &corner, &start, nullptr), WEND_OK);
  ASSERT_EQ(wend_session_nearest(session.get(), &other, &goal, nullptr), WEND_OK);
  wend_request request = request_to(goal, start);
  request.planner = GetParam();
  const auto planned = [&](wend_session* with) {
    return made_object<wend_plan>([&](wend_plan** plan, wend_error* error) {
      return wend_session_plan(with, &request, plan, error);
    });
  };
  const auto expected = planned(reference.get());
  const auto plan = made_without_memory<wend_plan>([&](wend_plan** out, wend_error* error) {
    return wend_session_plan(session.get(), &request, out, error);
  });
  const auto again = planned(session.get());
  for (const wend_plan* const each : {plan.get(), again.get()}) {
    EXPECT_EQ(wend_plan_cost(each), wend_plan_cost(expected.get()));
    EXPECT_EQ(wend_plan_pose_count(each), wend_plan_pose_count(expected.get()));
  }
  if (std::string(GetParam()) != "astar") return;
  made_without_memory<wend_field>([&](wend_field** out, wend_error* error) {
    return wend_session_field(session.get(), &request, out, error);
  });
}

INSTANTIATE_TEST_SUITE_P(, CInterfaceShortOfMemory,
                         ::testing::Values("astar", "jps", "lattice", "theta_star"));

INSTANTIATE_TEST_SUITE_P(Registry, Allocation, ::testing::ValuesIn(specs()), [](const auto& test) {
  std::string name = test.param;
  std::replace_if(
      name.begin(), name.end(), [](char letter) { return letter == ':' || letter == '='; }, '_');
  return name;
});

}  // namespace
}  // namespace wend::test
