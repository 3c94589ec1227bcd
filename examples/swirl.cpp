// A planner of one's own, outside the library, as a plugin:
//   wend --plugin libswirl.so plan office.yaml --start 1,1 --goal 15,9 --planner swirl
// It goes depth first and turns left where it can. It finds a path if there is one, rarely a short one.
#include <array>

#include "wend/map/grid.hpp"
#include "wend/planner/cell_planner.hpp"
#include "wend/planner/planner_plugin.hpp"

namespace {

constexpr wend::GridMoves kMoves{wend::Connectivity::four, wend::CornerRule::none};
constexpr std::array<wend::Cell, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
constexpr int kStart = 4;  // the start was reached by no step

class Swirl final : public wend::CellPlanner {
 public:
  explicit Swirl(const wend::FreeSpace& space) : CellPlanner(space, kMoves) {}

 private:
  wend::SearchOutcome search(wend::CellSearch& search, wend::Path& path) override {
    reached_by_ = wend::Grid<int>(free_space().width(), free_space().height(), -1);
    open_.clear();
    generate(search, search.start(), kStart, 0);
    while (!open_.empty()) {
      const Visit visit = open_.back();
      open_.pop_back();
      if (!search.expand(visit.cell, before(visit.cell), visit.g)) return search.outcome();
      if (search.is_goal(visit.cell)) return write(visit.cell, path);
      const int ahead = reached_by_[visit.cell];
      for (const int turn : {2, 3, 0, 1}) {  // the last is expanded first: left
        const int step = (ahead + turn) % 4;
        const wend::Cell next{visit.cell.x + kSteps[step].x, visit.cell.y + kSteps[step].y};
        if (!free_space().passable(next) || reached_by_[next] >= 0) continue;
        generate(search, next, step, visit.g + 1);
      }
    }
    return wend::SearchOutcome::exhausted;
  }

  void generate(wend::CellSearch& search, wend::Cell cell, int step, double g) {
    reached_by_[cell] = step;
    search.generate(cell, before(cell), g);
    open_.push_back({cell, g});
  }

  std::optional<wend::Cell> before(wend::Cell cell) const {
    const int step = reached_by_[cell];
    if (step == kStart) return std::nullopt;
    return wend::Cell{cell.x - kSteps[step].x, cell.y - kSteps[step].y};
  }

  wend::SearchOutcome write(wend::Cell goal, wend::Path& path) const {
    for (std::optional<wend::Cell> cell = goal; cell; cell = before(*cell)) path.append(*cell);
    path.reverse();
    return wend::SearchOutcome::found;
  }

  std::unique_ptr<wend::Planner> do_clone() const override {
    return std::make_unique<Swirl>(free_space());
  }

  struct Visit {
    wend::Cell cell;
    double g;
  };
  wend::Grid<int> reached_by_;  // the step that led to a cell; -1: none yet
  std::vector<Visit> open_;
};

wend::PlannerInfo swirl_planner() {
  return {.name = "swirl",
          .summary = "Swirl: depth first, and to the left where it can",
          .idea = "It turns left before it goes ahead.",
          .guarantee_text = "complete",
          .guarantee = wend::Guarantee::complete,
          .make = [](const wend::FreeSpace& space,
                     const wend::OptionValues& options) -> wend::PlannerResult {
            if (auto refused = wend::refused_options(options)) {
              return wend::Unexpected<wend::Error>(*std::move(refused));
            }
            return std::make_unique<Swirl>(space);
          }};
}

}  // namespace

WEND_PLANNER_PLUGIN(swirl_planner)
