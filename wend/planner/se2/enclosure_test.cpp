#include "wend/planner/se2/enclosure.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "tests/testing/share.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

const auto kNever = [] { return false; };

/// A room of random obstacles.
FreeSpace random_room(Random& random) {
  Grid<CellState> states(14, 11, CellState::free);
  for (int i = random.between(5, 40); i > 0; --i) {
    states[{random.between(0, 13), random.between(0, 10)}] = CellState::occupied;
  }
  return *make_free_space(
      *make_grid_map(states),
      {.footprint = *parse_footprint("2.2,0.9; -0.9,0.9; -0.9,-0.9; 2.2,-0.9")});
}

/// Does a robot that slides and turns at will get there in small steps? A drive that it finds is one.
bool slides_there(const FreeSpace& space, const Pose& from, const Pose& to) {
  constexpr double kStep = 0.5;
  constexpr int kHeadings = 24;
  using Place = std::tuple<int, int, int>;
  const auto pose_of = [&](const Place& place) {
    const auto& [x, y, heading] = place;
    return Pose{from.x + x * kStep, from.y + y * kStep,
                from.heading + heading * 2 * kPi / kHeadings};
  };
  std::set<Place> seen{{0, 0, 0}};
  std::vector<Place> places{{0, 0, 0}};
  for (std::size_t next = 0; next < places.size(); ++next) {
    const auto [x, y, heading] = places[next];
    if (pose_of(places[next]) == to) return true;
    for (const int by : {-1, 1}) {
      for (const Place& place : {Place{x + by, y, heading}, Place{x, y + by, heading},
                                 Place{x, y, (heading + by + kHeadings) % kHeadings}}) {
        if (!space.fits(pose_of(place)) || !seen.insert(place).second) continue;
        places.push_back(place);
      }
    }
  }
  return false;
}

TEST(IsEnclosed, HoldsOnlyWhereARobotThatSlidesAndTurnsAtWillDoesNotGetOut) {
  int proofs = 0;
  for (std::uint64_t seed = 1; seed <= test::share_of(300U) && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const FreeSpace space = random_room(random);
    const Pose from{random.between(2, 24) * 0.5, random.between(2, 18) * 0.5, 0};
    const Pose to{random.between(2, 24) * 0.5, random.between(2, 18) * 0.5, 0};
    if (!space.fits(from) || !space.fits(to)) continue;
    if (!is_enclosed(space, from, to, kNever)) continue;
    ++proofs;
    EXPECT_FALSE(slides_there(space, from, to));
  }
  EXPECT_GT(proofs, 0);
}

TEST(IsEnclosed, SeesABoxAroundTheRobotAndAnOpenSide) {
  const auto space_of = [](const std::string& drawing) {
    return *make_free_space(
        test::drawn_map(drawing),
        {.footprint = *parse_footprint("1.4,0.9; -0.9,0.9; -0.9,-0.9; 1.4,-0.9")});
  };
  const FreeSpace closed = space_of(
      "..............\n"
      ".######.......\n"
      ".#....#.......\n"
      ".#....#.......\n"
      ".#....#.......\n"
      ".######.......\n"
      "..............\n");
  EXPECT_TRUE(is_enclosed(closed, {3.5, 3.5, 0}, {10.5, 3.5, 0}, kNever));
  EXPECT_FALSE(is_enclosed(closed, {3.5, 3.5, 0}, {10.5, 3.5, 0}, [] { return true; }));
  EXPECT_FALSE(is_enclosed(closed, {3.5, 3.5, 0}, {3.6, 3.5, 0.2}, kNever));
  const FreeSpace open = space_of(
      "..............\n"
      ".######.......\n"
      ".#............\n"
      ".#............\n"
      ".#............\n"
      ".######.......\n"
      "..............\n");
  EXPECT_FALSE(is_enclosed(open, {3.5, 3.5, 0}, {10.5, 3.5, 0}, kNever));
}

}  // namespace
}  // namespace wend
