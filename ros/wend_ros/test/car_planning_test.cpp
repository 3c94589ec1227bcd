#include "wend_ros/car_planning.hpp"

#include <gtest/gtest.h>

#include "wend_ros/car_client_arguments.hpp"

namespace wend_ros {
namespace {

CarRequest empty_yard() {
  CarRequest request;
  request.mapWidth = request.mapHeight = 20;
  request.start.d = 2;
  request.goal.x = request.goal.y = 18;
  request.goal.d = 2;
  return request;
}

YardCell cell(int x, int y) {
  YardCell cell;
  cell.x = x;
  cell.y = y;
  return cell;
}

TEST(CarPlanning, DrivesTheEmptyYardByEighteenTurns) {
  const CarResult result = plan_car(empty_yard());
  ASSERT_EQ(result.status, 0) << result.reason;
  EXPECT_EQ(result.moves.size(), 18U);
  EXPECT_EQ(result.path.size(), 19U);
  EXPECT_NEAR(result.fuel, 28.2743, 1e-4);
  EXPECT_EQ(commands_of(result)[1], "Go FWD_RIGHT -> (1,1,S)");
}

TEST(CarPlanning, ChecksItsRequest) {
  CarRequest outside = empty_yard();
  outside.obstacles = {cell(3, 3), cell(19, 4)};
  EXPECT_EQ(plan_car(outside).reason,
            "obstacles[1]: the cell (19,4) is outside: x from 0 to 18, y from 0 to 18");
  EXPECT_EQ(plan_car(outside).status, 257);
  CarRequest turned = empty_yard();
  turned.goal.d = 4;
  EXPECT_EQ(plan_car(turned).status, 257);
  CarRequest small = empty_yard();
  small.mapWidth = 1;
  EXPECT_EQ(plan_car(small).status, 257);
  CarRequest beyond = empty_yard();
  beyond.goal.x = 20;
  EXPECT_EQ(plan_car(beyond).status, 204);
  CarRequest blocked = empty_yard();
  blocked.obstacles = {cell(0, 0)};
  EXPECT_EQ(plan_car(blocked).status, 205);
}

TEST(CarPlanning, MovesAreNumberedAsTheMessageSays) {
  CarRequest back = empty_yard();
  back.start.x = back.start.y = 5;
  back.goal.x = 3;
  back.goal.y = 5;
  const CarResult result = plan_car(back);
  ASSERT_EQ(result.moves.size(), 2U);
  EXPECT_EQ(result.moves[0], CarResult::REV);
  EXPECT_EQ(commands_of(result),
            (std::vector<std::string>{"Start (5,5,E)", "Go 2 x REV -> (3,5,E)"}));
}

TEST(CarArguments, AreTenOrNone) {
  const auto none = car_request({}, 1);
  ASSERT_TRUE(none) << none.error();
  EXPECT_EQ(none->obstacles.size(), 25U);
  EXPECT_EQ(none->roughRoads.size(), 25U);
  const auto ten = car_request({"30", "10", "1", "2", "0", "28", "8", "3", "4", "5"}, 1);
  ASSERT_TRUE(ten) << ten.error();
  EXPECT_EQ(ten->mapWidth, 30);
  EXPECT_EQ(ten->goal.d, 3);
  EXPECT_EQ(ten->obstacles.size(), 4U);
  EXPECT_FALSE(car_request({"30"}, 1));
  const auto wrong = car_request({"30", "10", "1", "2", "0", "x", "8", "3", "4", "5"}, 1);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error(), "goalX must be a whole number, not 'x'");
  EXPECT_FALSE(car_request({"4", "4", "0", "0", "0", "3", "3", "3", "400", "5"}, 1));
}

TEST(CarArguments, TheSameSeedMakesTheSameYard) {
  EXPECT_EQ(car_request({}, 7)->obstacles.size(), car_request({}, 7)->obstacles.size());
  const auto first = car_request({}, 7);
  const auto again = car_request({}, 7);
  for (std::size_t i = 0; i < first->obstacles.size(); ++i) {
    EXPECT_EQ(first->obstacles[i].x, again->obstacles[i].x);
    EXPECT_EQ(first->obstacles[i].y, again->obstacles[i].y);
  }
}

}  // namespace
}  // namespace wend_ros
