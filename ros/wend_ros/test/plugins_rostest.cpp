// planner_server with a planner from outside, and with files that are not plugins.

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <signal.h>
#include <sys/wait.h>
#include <wend_ros/PlanPath.h>

#include <array>
#include <cstdio>
#include <string>

#include "next_message.hpp"
#include "planner_client.hpp"
#include "process_of_node.hpp"

namespace wend_ros {
namespace {

FILE* start_server(const std::string& arguments) {
  return popen((std::string(PLANNER_SERVER) + " " + arguments + " 2>&1").c_str(), "r");
}

class Plugins : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    XmlRpc::XmlRpcValue list;
    list[0] = PLUGIN;
    ros::param::set("planner_server/plugins", list);
    ros::param::set("planner_server/planner", "swirl");
    server_ = start_server("");
    ASSERT_NE(server_, nullptr);
  }

  static void TearDownTestSuite() {
    if (const int pid = pid_of("/planner_server"); pid > 0) kill(pid, SIGINT);
    pclose(server_);
  }

  static inline FILE* server_ = nullptr;
};

PlanResult plan(const PlanRequest& request) {
  ros::NodeHandle node;
  auto client = node.serviceClient<PlanPath>("plan_path");
  EXPECT_TRUE(client.waitForExistence(kPatience));
  PlanPath call;
  call.request.request = request;
  EXPECT_TRUE(client.call(call));
  return call.response.result;
}

TEST_F(Plugins, PlanByTheParametersName) {
  const PlanResult result = plan(request(7.5, 5.5));
  ASSERT_EQ(result.status, 0) << result.reason;
  EXPECT_GE(result.path.poses.size(), 11U);
  EXPECT_EQ(result.path.poses.back().pose.position.x, 7.5);
}

TEST_F(Plugins, PlanBesideThePlannersOfTheLibrary) {
  PlanRequest asked = request(7.5, 5.5);
  asked.planner = "astar";
  const double shortest = plan(asked).cost;
  asked.planner = "swirl";
  EXPECT_GE(plan(asked).cost, shortest);
}

TEST(BrokenPlugins, EndTheNodeWithTheNameOfAFileThatIsNone) {
  for (const std::string file : {"/nowhere/swirl.so", PLANNER_SERVER}) {
    FILE* const pipe = start_server("__name:=broken _plugins:=" + file);
    ASSERT_NE(pipe, nullptr);
    std::string said;
    for (std::array<char, 256> text{}; fgets(text.data(), text.size(), pipe) != nullptr;) {
      said += text.data();
    }
    EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 2);
    EXPECT_NE(said.find("FATAL"), std::string::npos) << said;
    EXPECT_NE(said.find("~plugins: " + file), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace wend_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "plugins_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
