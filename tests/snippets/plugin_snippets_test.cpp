// The snippets of the headers of planners from outside, compiled and run as they stand there. (In the program
// of threads, for the reason that added_planners_test.cpp gives.)

#include <gtest/gtest.h>

#include <memory>

#include "tests/snippets/snippets.hpp"
#include "wend/planner/cell_planner.hpp"
#include "wend/planner/planners.hpp"
#include "wend/plugin/load_planners.hpp"

namespace {

using wend::test::open_ground;
using wend::test::report;
using wend::test::reported;

wend::PlannerInfo swirl_planner();

constexpr wend::GridMoves kMoves{};

class Swirl final : public wend::CellPlanner {
 public:
  explicit Swirl(const wend::FreeSpace& space) : CellPlanner(space, kMoves) {}

 private:
  std::optional<wend::Cell> search(wend::CellSearch& search) override;
  std::unique_ptr<wend::Planner> do_clone() const override {
    return std::make_unique<Swirl>(free_space());
  }
};

/// Finds a path only if the start is a goal.
std::optional<wend::Cell> Swirl::search(wend::CellSearch& search) {
  if (!search.expand(search.start()) || !search.is_goal(search.start())) return std::nullopt;
  return search.start();
}

wend::PlannerInfo swirl_planner() {
  return {.name = "swirl",
          .make = [](const wend::FreeSpace& space, const wend::OptionValues& /*options*/)
              -> wend::PlannerResult { return std::make_unique<Swirl>(space); }};
}

TEST(Snippets, OfAddedPlanners) {
  const wend::FreeSpace space = open_ground();
  reported.clear();
  [&] {
    const auto added = wend::add_planners({swirl_planner()});
    if (!added) return report(added.error().message);
    const auto planner = wend::make_planner("swirl", space);
    ASSERT_TRUE(planner);
    EXPECT_TRUE((*planner)->plan(wend::Query::between({1, 1}, {1, 1})));
    EXPECT_FALSE((*planner)->plan(wend::Query::between({1, 1}, {2, 1})));
  }();
  EXPECT_TRUE(reported.empty()) << reported;
}

TEST(Snippets, OfPlugins) {
  reported.clear();
  [&] {
    const auto names = wend::load_planners("libswirl.so");
    if (!names) return report(names.error().message);
  }();
  EXPECT_EQ(reported, "libswirl.so: cannot be opened: No such file or directory");
}

}  // namespace
