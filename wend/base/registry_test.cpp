#include "wend/base/registry.hpp"

#include <gtest/gtest.h>

namespace wend {
namespace {

struct Tool {
  std::string name;
  int size;
};

const Registry<Tool>& tools() {
  static const Registry<Tool> registry({{"hammer", 3}, {"saw", 5}, {"chisel", 1}});
  return registry;
}

TEST(Registry, FindsEntriesByName) {
  for (const Tool& tool : tools()) {
    ASSERT_NE(tools().find(tool.name), nullptr);
    EXPECT_EQ(tools().find(tool.name)->size, tool.size);
  }
  EXPECT_EQ(tools().find("drill"), nullptr);
  EXPECT_EQ(tools().find("Hammer"), nullptr);
  EXPECT_EQ(tools().find(""), nullptr);
}

TEST(Registry, KeepsTheOrderOfItsEntries) {
  EXPECT_EQ(tools().size(), 3U);
  EXPECT_EQ(tools().names(), (std::vector<std::string>{"hammer", "saw", "chisel"}));
}

TEST(Registry, SuggestsTheNameThatWasMeant) {
  EXPECT_EQ(tools().unknown("tool", "hamer"), "there is no tool 'hamer': did you mean 'hammer'?");
}

TEST(Registry, ListsAllNamesWhereNoneIsNear) {
  EXPECT_EQ(tools().unknown("tool", "drill"),
            "there is no tool 'drill': choose from hammer, saw, chisel");
}

}  // namespace
}  // namespace wend
