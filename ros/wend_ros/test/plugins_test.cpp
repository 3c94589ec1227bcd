#include "wend_ros/plugins.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wend_ros {
namespace {

using Names = std::vector<std::string>;

TEST(PluginFiles, AreAListOrATextWithCommas) {
  EXPECT_EQ(*plugin_files(XmlRpc::XmlRpcValue("")), Names());
  EXPECT_EQ(*plugin_files(XmlRpc::XmlRpcValue("/a b.so")), Names{"/a b.so"});
  EXPECT_EQ(*plugin_files(XmlRpc::XmlRpcValue("/a.so, b.so,")), (Names{"/a.so", "b.so"}));
  XmlRpc::XmlRpcValue list;
  list.setSize(2);
  list[0] = "/a,b.so";
  list[1] = "c.so";
  EXPECT_EQ(*plugin_files(list), (Names{"/a,b.so", "c.so"}));
}

TEST(PluginFiles, AreNotNumbers) {
  EXPECT_FALSE(plugin_files(XmlRpc::XmlRpcValue(3)));
  XmlRpc::XmlRpcValue list;
  list[0] = 3;
  EXPECT_FALSE(plugin_files(list));
}

}  // namespace
}  // namespace wend_ros
