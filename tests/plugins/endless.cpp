// A plugin with a planner that never answers and one that throws.

#include <stdexcept>

#include "wend/planner/cell_planner.hpp"
#include "wend/plugin/planner_plugin.hpp"

namespace {

constexpr wend::GridMoves kMoves{wend::Connectivity::four, wend::CornerRule::none};

template <class Search>
class Broken final : public wend::CellPlanner {
 public:
  explicit Broken(const wend::FreeSpace& space) : CellPlanner(space, kMoves) {}

 private:
  std::optional<wend::Cell> search(wend::CellSearch& search) override { return Search()(search); }
  std::unique_ptr<wend::Planner> do_clone() const override {
    return std::make_unique<Broken>(free_space());
  }
};

struct Loops {
  std::optional<wend::Cell> operator()(wend::CellSearch& search) const {
    for (volatile unsigned turns = 0;;) turns = turns + search.is_goal({-1, -1});
  }
};

struct Throws {
  std::optional<wend::Cell> operator()(wend::CellSearch& /*search*/) const {
    throw std::runtime_error("the map is too beautiful");
  }
};

template <class Search>
wend::PlannerResult make(const wend::FreeSpace& space, const wend::OptionValues& options) {
  if (auto refused = wend::refused_options(options)) return wend::Unexpected<wend::Error>(*refused);
  return std::make_unique<Broken<Search>>(space);
}

wend::PlannerInfo endless_planner() {
  return {.name = "endless",
          .summary = "Never answers",
          .guarantee_text = "none",
          .guarantee = wend::Guarantee::none,
          .make = make<Loops>};
}

wend::PlannerInfo throwing_planner() {
  return {.name = "throwing",
          .summary = "Throws",
          .guarantee_text = "none",
          .guarantee = wend::Guarantee::none,
          .make = make<Throws>};
}

}  // namespace

WEND_PLANNER_PLUGIN(endless_planner, throwing_planner)
