#include "bench/plot/plot_style.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "wend/control/controller.hpp"
#include "wend/planner/planners.hpp"

namespace wend {
namespace {

using Names = std::vector<std::string>;
using Numbers = std::vector<std::size_t>;

TEST(PlotColours, AreTheSameInEveryPlot) {
  for (const PlannerInfo& info : planners()) {
    const Names alone{info.name};
    const std::size_t own = plot_colours_of(alone).front();
    for (const PlannerInfo& other : planners()) {
      if (other.name == info.name) continue;
      const Names both{other.name, info.name};
      EXPECT_EQ(plot_colours_of(both).back(), own) << info.name << " beside " << other.name;
      EXPECT_NE(plot_colours_of(both).front(), own) << info.name << " and " << other.name;
    }
  }
}

TEST(PlotColours, OfControllersDifferFromEachOther) {
  Names names;
  for (const auto& info : controllers()) names.push_back(info.name);
  const Numbers colours = plot_colours_of(names);
  EXPECT_EQ(std::set<std::size_t>(colours.begin(), colours.end()).size(), names.size());
  std::reverse(names.begin(), names.end());
  Numbers turned = plot_colours_of(names);
  std::reverse(turned.begin(), turned.end());
  EXPECT_EQ(turned, colours);
}

TEST(PlotColours, AreFreeOnesForOtherNamesAndOtherOptions) {
  EXPECT_EQ(plot_colours_of(Names{"mine", "astar"}), (Numbers{1, 0}));
  EXPECT_EQ(plot_colours_of(Names{"car:weight=2", "car", "astar"}), (Numbers{10, 1, 0}));
  Names many(30, "mine");
  const Numbers colours = plot_colours_of(many);
  EXPECT_EQ(*std::max_element(colours.begin(), colours.end()), kLightPlot.names.size() - 1);
  EXPECT_TRUE(plot_colours_of({}).empty());
}

TEST(PlotColours, DifferOnEveryPage) {
  for (const PlotColours& plot : {kLightPlot, kDarkPlot, kPrintPlot}) {
    std::set<std::uint32_t> all(plot.names.begin(), plot.names.end());
    EXPECT_EQ(all.size(), plot.names.size());
    EXPECT_FALSE(all.contains(plot.page));
  }
}

}  // namespace
}  // namespace wend
