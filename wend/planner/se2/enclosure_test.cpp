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

/// A wall with gaps and obstacles on both sides.
FreeSpace random_room(Random& random) {
  Grid<CellState> states(28, 22, CellState::free);
  const int wall = random.between(8, 18);
  const double share = random.chance(0.5) ? 1 : 0.7;
  for (int y = 0; y < 22; ++y) {
    if (random.chance(share)) states[{wall, y}] = CellState::occupied;
  }
  for (int i = random.between(0, 8); i > 0; --i) {
    states[{random.between(0, 27), random.between(0, 21)}] = CellState::occupied;
  }
  return *make_free_space(*make_grid_map(states),
                          {.footprint = *parse_footprint("4.4,1.8; -1.8,1.8; -1.8,-1.8; 4.4,-1.8"),
                           .outside = OutsidePolicy::blocked});
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
        if (!seen.insert(place).second || !space.fits(pose_of(place))) continue;
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
    const Pose from{random.between(4, 26) * 0.5, random.between(4, 40) * 0.5, 0};
    const Pose to{random.between(26, 48) * 0.5, random.between(4, 40) * 0.5, 0};
    if (!space.fits(from) || !space.fits(to)) continue;
    if (!is_enclosed(space, from, to, kNever)) continue;
    ++proofs;
    EXPECT_FALSE(slides_there(space, from, to));
  }
  EXPECT_GT(proofs, test::share_of(5));
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
