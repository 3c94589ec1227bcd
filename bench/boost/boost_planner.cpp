#include "bench/boost/boost_planner.hpp"

#include <utility>

#include "bench/boost/boost_astar.hpp"
#include "wend/planner/planner.hpp"

namespace wend::bench {
namespace {

class BoostPlanner final : public Planner {
 public:
  explicit BoostPlanner(FreeSpace space) : Planner(std::move(space)), astar_(free_space()) {}

 private:
  std::optional<Status> do_check(const Query& query) override {
    if (query.goals.size() > 1) return Status::unsupported_query;
    start_ = cell_at(query.start.point());
    goal_ = cell_at(query.goals.front().point);
    limits_ = query.limits;
    if (!free_space().map().contains(start_)) return Status::start_outside;
    if (!free_space().map().contains(goal_)) return Status::goal_outside;
    if (!free_space().passable(start_)) return Status::start_blocked;
    if (!free_space().passable(goal_)) return Status::goal_blocked;
    return std::nullopt;
  }

  Status do_plan(const Query& /*query*/, Plan& out) override {
    const BoostAStar::Answer answer = astar_.plan(start_, goal_, out.path, limits_);
    out.cost = answer.cost;
    out.metrics.expanded = answer.expanded;
    if (answer.status == Status::found) out.bound = 1;
    return answer.status;
  }

  std::unique_ptr<Planner> do_clone() const override {
    return std::make_unique<BoostPlanner>(free_space());
  }
  std::optional<Error> do_update(std::span<const Cell> /*changed*/) override {
    astar_ = BoostAStar(free_space());
    return refused_terrain("boost-astar", free_space());
  }

  BoostAStar astar_;
  Cell start_;
  Cell goal_;
  Limits limits_;
};

PlannerResult make_boost(const FreeSpace& space, const OptionValues& options) {
  if (auto refused = refused_options(options)) {
    return Unexpected<Error>(*std::move(refused));
  }
  if (auto refused = refused_terrain("boost-astar", space)) {
    return Unexpected<Error>(*std::move(refused));
  }
  return std::make_unique<BoostPlanner>(space);
}

}  // namespace

PlannerInfo boost_astar_planner() {
  return {.name = "boost-astar",
          .summary = "Boost.Graph's astar_search, the yardstick",
          .idea =
              "The grid as a compressed sparse row graph, an octile heuristic, a visitor that "
              "ends the search at the goal.",
          .citation = "J. Siek, L.-Q. Lee and A. Lumsdaine, \"The Boost Graph Library\", 2002",
          .guarantee_text = "optimal",
          .time = "O(cells + n log n) in the n cells expanded",
          .memory = "some 100 bytes a cell",
          .when = "To compare with.",
          .guarantee = Guarantee::optimal,
          .preprocessing = Preprocessing::none,
          .options = {},
          .make = make_boost};
}

}  // namespace wend::bench
