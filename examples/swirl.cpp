// A planner of one's own, outside the library, as a plugin:
//   wend --plugin libswirl.so plan office.yaml --start 1,1 --goal 15,9 --planner swirl
// It goes depth first and turns left where it can. It finds a path if there is one, rarely a short one.
#include <array>

#include "wend/planner/cell_planner.hpp"
#include "wend/plugin/planner_plugin.hpp"

namespace {

constexpr wend::GridMoves kMoves{wend::Connectivity::four, wend::CornerRule::none};
constexpr std::array<wend::Cell, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

wend::Cell after(wend::Cell cell, int step) {
  return {cell.x + kSteps[step].x, cell.y + kSteps[step].y};
}

class Swirl final : public wend::CellPlanner {
 public:
  explicit Swirl(const wend::FreeSpace& space) : CellPlanner(space, kMoves) {}

 private:
  std::optional<wend::Cell> search(wend::CellSearch& search) override {
    std::vector<wend::Cell> open{search.start()};
    while (!open.empty()) {
      const wend::Cell cell = open.back();
      open.pop_back();
      if (!search.expand(cell)) return std::nullopt;
      if (search.is_goal(cell)) return cell;
      for (const int turn : {2, 3, 0, 1}) {  // the last is expanded first: left
        const wend::Cell next = after(cell, (step_to(search, cell) + turn) % 4);
        if (!free_space().passable(next) || search.reached(next)) continue;
        search.reach(next, cell, search.cost(cell) + 1);
        open.push_back(next);
      }
    }
    return std::nullopt;
  }

  static int step_to(const wend::CellSearch& search, wend::Cell cell) {
    const auto parent = search.parent(cell);
    int step = 0;
    while (parent && step < 3 && after(*parent, step) != cell) ++step;
    return step;
  }

  std::unique_ptr<wend::Planner> do_clone() const override {
    return std::make_unique<Swirl>(free_space());
  }
};

wend::PlannerResult make_swirl(const wend::FreeSpace& space, const wend::OptionValues& options) {
  if (auto refused = wend::refused_options(options)) return wend::Unexpected<wend::Error>(*refused);
  return std::make_unique<Swirl>(space);
}

wend::PlannerInfo swirl_planner() {
  return {.name = "swirl",
          .summary = "Swirl: depth first, and to the left where it can",
          .guarantee_text = "complete",
          .guarantee = wend::Guarantee::complete,
          .make = make_swirl};
}

}  // namespace

WEND_PLANNER_PLUGIN(swirl_planner)
