#include "wend/report/drive_commands.hpp"

#include <gtest/gtest.h>

#include "wend/geometry/car_move.hpp"

namespace wend {
namespace {

Plan driven(CornerPose place, const std::vector<CarMove>& moves, bool y_up, int unit = 1) {
  Plan plan;
  plan.path.drive_to(pose_of(place, y_up));
  for (const CarMove move : moves) {
    place = moved(place, move, y_up, unit);
    plan.path.drive_to(pose_of(place, y_up));
    plan.moves.push_back(to_string(move));
  }
  return plan;
}

TEST(DriveCommands, AreTheStartAndALineForEachMove) {
  const Plan plan =
      driven({{1, 0}, Heading::east}, {CarMove::fwd_right, CarMove::fwd, CarMove::rev_left}, false);
  EXPECT_EQ(drive_commands(plan, false),
            "Start (1,0,E)\n"
            "Go FWD_RIGHT -> (2,1,S)\n"
            "Go FWD -> (2,2,S)\n"
            "Go REV_LEFT -> (3,1,W)\n");
}

TEST(DriveCommands, SayTheSameOfTheSameDriveWithYUp) {
  const Plan plan = driven({{10, 10}, Heading::east}, {CarMove::fwd_right, CarMove::fwd}, true, 5);
  EXPECT_EQ(drive_commands(plan, true),
            "Start (10,10,E)\n"
            "Go FWD_RIGHT -> (15,5,S)\n"
            "Go FWD -> (15,0,S)\n");
}

TEST(DriveCommands, OfACarThatIsThereAreTheStart) {
  EXPECT_EQ(drive_commands(driven({{1000000, 0}, Heading::north}, {}, false), false),
            "Start (1000000,0,N)\n");
}

TEST(DriveCommands, OfNothingAreNone) { EXPECT_EQ(drive_commands({}, false), ""); }

}  // namespace
}  // namespace wend
