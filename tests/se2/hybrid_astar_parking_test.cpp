// hybrid_astar in parking slots that are little longer than the car. A plain breadth-first search in this file, which
// shares no code with the planner, says which queries have a drive: motions of 5 cm, boxes of 2 cm and a third of a
// degree, and the corners of the car against the walls of the slot.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "tests/testing/share.hpp"
#include "wend/base/cpu_time.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/path/path_collision.hpp"
#include "wend/planner/planner_options.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

constexpr double kFront = 3.6;  // metres from the base point
constexpr double kRear = 0.9;
constexpr double kCarHalfWidth = 0.9;
constexpr double kSlotCell = 0.05;
constexpr int kWallCells = 10;
constexpr double kNearEnough = 0.02;  // metres
constexpr double kAlmostTheHeading = kPi / 180;

/// A closed rectangle from (0, 0), and two places in it with heading 0, in metres.
struct ParkingSlot {
  double length;
  double width;
  double radius;
  Point start;
  Point goal;
};

ParkingSlot random_slot(std::uint64_t seed) {
  constexpr std::array<double, 5> kRadii{4, 5, 6, 7, 8};
  Random random(seed);
  const auto in_cells = [](double metres) { return std::round(metres / kSlotCell) * kSlotCell; };
  ParkingSlot slot{};
  slot.length = in_cells((kFront + kRear) * (1.2 + 0.4 * random.uniform()));
  slot.width = in_cells(2.2 + 1.3 * random.uniform());
  slot.radius = kRadii[seed % kRadii.size()];
  const auto place = [&] {
    return Point{kRear + (slot.length - kRear - kFront) * random.uniform(),
                 kCarHalfWidth + (slot.width - 2 * kCarHalfWidth) * random.uniform()};
  };
  slot.start = place();
  slot.goal = place();
  return slot;
}

/// The breadth-first search.
class PlainSearch {
 public:
  explicit PlainSearch(const ParkingSlot& slot) : slot_(slot) {}

  bool finds_a_drive(std::size_t most) {
    add({slot_.start.x, slot_.start.y, 0});
    for (std::size_t i = 0; i < states_.size() && states_.size() < most; ++i) {
      const State state = states_[i];
      if (std::hypot(state.x - slot_.goal.x, state.y - slot_.goal.y) < kNearEnough &&
          std::abs(state.heading) < kAlmostTheHeading) {
        return true;
      }
      for (const double gear : {1.0, -1.0}) {
        for (const double side : {-1.0, 0.0, 1.0}) drive(state, gear, side / slot_.radius);
      }
    }
    return false;
  }

 private:
  struct State {
    double x, y, heading;
  };

  bool fits(const State& state) const {
    const double sine = std::sin(state.heading);
    const double cosine = std::cos(state.heading);
    for (const double ahead : {kFront, -kRear}) {
      for (const double aside : {kCarHalfWidth, -kCarHalfWidth}) {
        const double x = state.x + cosine * ahead - sine * aside;
        const double y = state.y + sine * ahead + cosine * aside;
        if (x < 1e-9 || y < 1e-9 || x > slot_.length - 1e-9 || y > slot_.width - 1e-9) return false;
      }
    }
    return true;
  }

  void drive(State state, double gear, double curvature) {
    constexpr int kParts = 4;
    constexpr double kPart = 0.05 / kParts;
    for (int i = 0; i < kParts; ++i) {
      const double middle = state.heading + gear * kPart * curvature / 2;
      state = {state.x + gear * kPart * std::cos(middle), state.y + gear * kPart * std::sin(middle),
               state.heading + gear * kPart * curvature};
      if (!fits(state)) return;
    }
    add(state);
  }

  void add(const State& state) {
    const auto box = [](double value, double size) {
      return static_cast<std::int64_t>(std::floor(value / size));
    };
    const std::int64_t key = (box(state.x, 0.02) * 100'000 + box(state.y, 0.005)) * 100'000 +
                             box(state.heading + 3, 0.005);
    if (seen_.insert(key).second) states_.push_back(state);
  }

  ParkingSlot slot_;
  std::vector<State> states_;
  std::unordered_set<std::int64_t> seen_;
};

struct Parked {
  bool found = false;
  double seconds = 0;
  std::string message;
};

/// `budget` is in seconds of CPU time; a sanitizer is slow.
Parked park(const ParkingSlot& slot, double radius, double budget = 2) {
  Grid<CellState> states(170, 100, CellState::occupied);
  const auto cells = [](double metres) {
    return static_cast<int>(std::lround(metres / kSlotCell));
  };
  for (int y = 0; y < cells(slot.width); ++y) {
    for (int x = 0; x < cells(slot.length); ++x) {
      states[{kWallCells + x, kWallCells + y}] = CellState::free;
    }
  }
  Frame frame;
  frame.resolution = kSlotCell;
  frame.metric = true;
  const FreeSpace space =
      *make_free_space(*make_grid_map(states, frame),
                       {.footprint = *parse_footprint("3.6,0.9; -0.9,0.9; -0.9,-0.9; 3.6,-0.9")});
  const auto on_map = [](Point metres) {
    return Pose{metres.x / kSlotCell + kWallCells, metres.y / kSlotCell + kWallCells, 0};
  };
  Goal goal(on_map(slot.goal));
  goal.tolerance = kNearEnough / kSlotCell;
  goal.heading_tolerance = kAlmostTheHeading;
  constexpr double kSlower = share_of(4) == 4 ? 1 : 30;
  const auto planner = *make_planner(
      space, HybridAStarOptions{.turning_radius = radius, .time_budget = kSlower * budget});
  const double begin = cpu_seconds();
  const auto plan = planner->plan({on_map(slot.start), {goal}});
  Parked parked{plan.has_value(), cpu_seconds() - begin, plan ? "" : plan.error().message};
  EXPECT_FALSE(plan && first_collision(plan->path, space));
  return parked;
}

void park_in_slots(std::uint64_t slots, std::size_t most_states) {
  std::vector<double> seconds;
  std::uint64_t found = 0;
  for (std::uint64_t seed = 0; seed < slots; ++seed) {
    const ParkingSlot slot = random_slot(seed);
    if (!PlainSearch(slot).finds_a_drive(most_states)) continue;
    const Parked parked = park(slot, slot.radius);
    seconds.push_back(parked.seconds);
    found += parked.found ? 1 : 0;
    if (!parked.found) fmt::print("slot {}: {}\n", seed, parked.message);
    EXPECT_EQ(parked.message.find("boxed in"), std::string::npos) << "slot " << seed;
  }
  ASSERT_GT(seconds.size(), slots / 3);
  std::ranges::sort(seconds);
  fmt::print("{} of {} drives found; median {:.1f} ms, longest {:.0f} ms\n", found, seconds.size(),
             1e3 * seconds[seconds.size() / 2], 1e3 * seconds.back());
  EXPECT_GE(found * 100, seconds.size() * 99);
  constexpr double kGenerous = 10;  // for builds with assertions and sanitizers
  EXPECT_LT(seconds[seconds.size() / 2], kGenerous * 0.05);
}

TEST(HybridAStarParking, FindsWhatAPlainSearchFinds) { park_in_slots(share_of(40U), 300'000); }

TEST(HybridAStarParking, FindsWhatAPlainSearchFindsInALongRun) { park_in_slots(300, 4'000'000); }

/// A drive of a car is one of a car that turns in a narrower circle.
void park_with_smaller_radii(std::uint64_t slots) {
  for (std::uint64_t seed = 0; seed < slots; ++seed) {
    const ParkingSlot slot = random_slot(seed);
    bool larger_found = false;
    for (const double radius : {24.0, 8.0, 5.0, 3.0}) {
      // The drive of the largest one takes long where there is none; the plain search spares that.
      if (!larger_found) {
        ParkingSlot wider = slot;
        wider.radius = radius;
        if (!PlainSearch(wider).finds_a_drive(100'000)) continue;
      }
      constexpr double kEnough = 20;  // what is found must not hang on the build's speed
      const bool found = park(slot, radius, kEnough).found;
      EXPECT_TRUE(found || !larger_found) << "slot " << seed << ", radius " << radius;
      larger_found = larger_found || found;
    }
  }
}

TEST(HybridAStarParking, FindsNoLessWithASmallerTurningRadius) {
  park_with_smaller_radii(share_of(12U));
}

TEST(HybridAStarParking, FindsNoLessWithASmallerTurningRadiusInALongRun) {
  park_with_smaller_radii(200);
}

/// Straight ahead, and a little aside, in a room that is small beside the turning circle.
TEST(HybridAStarParking, DrivesWithARadiusFarLargerThanTheRoom) {
  const ParkingSlot ahead{7, 3, 0, {1.2, 1.5}, {2.9, 1.5}};
  for (const double radius : {20.0, 100.0, 1000.0}) {
    EXPECT_TRUE(park(ahead, radius).found) << radius;
  }
  const ParkingSlot aside{7, 3, 0, {1.2, 1.4}, {2.9, 1.5}};
  EXPECT_TRUE(park(aside, 40).found);
}

}  // namespace
}  // namespace wend::test
