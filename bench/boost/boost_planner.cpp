#include "bench/boost/boost_planner.hpp"

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bench/boost/boost_astar.hpp"
#include "wend/planner/goal_region.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/planner.hpp"

namespace wend::bench {
namespace {

class BoostPlanner final : public Planner {
 public:
  explicit BoostPlanner(FreeSpace space) : Planner(std::move(space)), astar_(free_space()) {}

 private:
  std::optional<Status> do_check(const Query& query) override {
    const auto refused = cells_.assign(free_space(), Adjacency::edges, query);
    if (refused) return refused;
    goals_.clear();
    const auto open = [&](Cell cell) {
      return free_space().contains(cell) &&
             free_space().components().connected(cells_.start, cell, Adjacency::edges);
    };
    append_entrances(cells_.goals, cells_.start, open, goals_);
    return std::nullopt;
  }

  /// Boost's search knows one goal, so several take as many searches.
  Status do_plan(const Query& query, Plan& out) override {
    Limits limits = query.limits;
    Path path;
    for (const Cell goal : goals_) {
      const BoostAStar::Answer answer = astar_.plan(cells_.start, goal, path, limits);
      out.metrics.expanded += answer.expanded;
      if (answer.status != Status::found) return failed(answer.status, out);
      limits.expansions -= answer.expanded;
      if (answer.cost >= out.cost) continue;
      out.cost = answer.cost;
      out.path = path;
    }
    out.bound = 1;
    return Status::found;
  }

  static Status failed(Status status, Plan& out) {
    out.path.clear();
    out.cost = std::numeric_limits<double>::infinity();
    return status;
  }

  std::unique_ptr<Planner> do_clone() const override {
    return std::make_unique<BoostPlanner>(free_space());
  }
  std::optional<Error> do_update(const SpaceChange& /*change*/) override {
    astar_ = BoostAStar(free_space());
    return refused_terrain("boost-astar", free_space());
  }

  BoostAStar astar_;
  // Of the query that was checked last.
  GridQuery cells_;
  std::vector<Cell> goals_;
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
