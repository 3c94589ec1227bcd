#include "wend/planner/indexed/index_planner.hpp"

#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/index_support.hpp"

namespace wend {
namespace {

using EngineResult = Expected<std::unique_ptr<IndexEngine>, PlannerError>;

Unexpected<PlannerError> index_failure(Status status, std::string what) {
  return Unexpected<PlannerError>({status, std::move(what)});
}

/// The status if a limit stops the query before any work.
std::optional<Status> stopped(const Limits& limits) {
  if (limits.cancel != nullptr && limits.cancel->load(std::memory_order_relaxed)) {
    return Status::cancelled;
  }
  if (limits.expansions == 0) return Status::expansion_limit;
  return std::nullopt;
}

class IndexPlanner final : public Planner {
 public:
  using EngineMaker = std::function<EngineResult(const FreeSpace&)>;

  IndexPlanner(FreeSpace space, std::unique_ptr<IndexEngine> engine, EngineMaker make_engine)
      : Planner(std::move(space)),
        make_engine_(std::move(make_engine)),
        engine_(std::move(engine)),
        most_cells_(free_space().passable().count()) {}

 private:
  std::optional<Status> do_check(const Query& query) override {
    if (engine_ == nullptr) return why_none_.status;
    return cells_.assign(free_space(), Adjacency::edges, query);
  }

  Status do_plan(const Query& query, Plan& out) override {
    const Limits& limits = query.limits;
    if (const auto status = stopped(limits)) return *status;
    const double begin = limits.clock ? limits.clock() : 0;
    const Cell start = cells_.start;
    const Cell goal = nearest_goal(start, out.metrics);
    const OctileSteps steps = start == goal ? OctileSteps{} : find(start, goal, out.metrics);
    if (limits.clock && limits.clock() - begin > limits.seconds) return Status::time_limit;
    if (start == goal) {
      out.path.append(cells_.start);
      out.metrics = {1, 1, 1};
      out.cost = 0;
    } else {
      // A shortest path never visits a cell twice: an index that says so was forged.
      if (steps.cells() > most_cells_) return Status::index_mismatch;
      engine_->write(out.path.make_cells(steps.cells()));
      out.cost = steps.cost();
    }
    out.bound = 1;
    return Status::found;
  }

  OctileSteps find(Cell start, Cell goal, SearchMetrics& metrics) {
    const OctileSteps steps = engine_->find(start, goal);
    const SearchMetrics work = engine_->metrics();
    metrics.expanded += work.expanded;
    metrics.generated += work.generated;
    metrics.max_frontier = std::max(metrics.max_frontier, work.max_frontier);
    return steps;
  }

  /// With one goal there is nothing to look up.
  Cell nearest_goal(Cell start, SearchMetrics& metrics) {
    Cell nearest = cells_.goals.front();
    if (cells_.goals.size() == 1) return nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const Cell goal : cells_.goals) {
      const double cost = goal == start ? 0 : find(start, goal, metrics).cost();
      if (cost < least) nearest = goal;
      least = std::min(least, cost);
    }
    return nearest;
  }

  std::string do_reason(const Query& query, Status status) const override {
    if (engine_ == nullptr) return why_none_.what;
    return reason_in_cells(free_space(), query, status);
  }

  void do_update(std::span<const Cell> /*changed*/) override {
    engine_.reset();  // frees its memory first
    most_cells_ = free_space().passable().count();
    auto made = make_engine_(free_space());
    if (made) {
      engine_ = *std::move(made);
    } else {
      why_none_ = made.error();
    }
  }

  EngineMaker make_engine_;  // for another FreeSpace
  std::unique_ptr<IndexEngine> engine_;
  std::size_t most_cells_;
  PlannerError why_none_{Status::found, {}};  // if there is no engine
  GridQuery cells_;
};

class MethodSupport final : public IndexSupport {
 public:
  MethodSupport(IndexMethod method, std::string planner)
      : method_(std::move(method)), planner_(std::move(planner)) {}

  Expected<IndexBytes, PlannerError> build(const FreeSpace& space,
                                           const IndexBuilding& building) const override {
    if (auto refused = refused_terrain(planner_, space)) return Unexpected<PlannerError>(*refused);
    auto built = method_.build(space.passable(), building);
    if (!built) return index_failure(built.error().status, built.error().what);
    return *std::move(built);
  }

  PlannerResult make_planner(const FreeSpace& space, const OptionValues& options,
                             IndexBytes index) const override {
    if (auto refused = refused_options(options)) {
      return Unexpected<PlannerError>(*std::move(refused));
    }
    auto engine = open(space, std::move(index));
    if (!engine) return Unexpected<PlannerError>(engine.error());
    // The planner may outlive this object.
    const auto make_engine = [method = method_, name = planner_](const FreeSpace& other) {
      const MethodSupport self(method, name);
      auto built = self.build(other, {});
      if (!built) return EngineResult(Unexpected<PlannerError>(built.error()));
      return self.open(other, *std::move(built));
    };
    return std::make_unique<IndexPlanner>(space, *std::move(engine), make_engine);
  }

 private:
  EngineResult open(const FreeSpace& space, IndexBytes index) const {
    if (auto refused = refused_terrain(planner_, space)) return Unexpected<PlannerError>(*refused);
    auto opened = method_.open(std::move(index), space.passable());
    if (!opened)
      return index_failure(Status::index_mismatch, "index does not match: " + opened.error());
    return *std::move(opened);
  }

  IndexMethod method_;
  std::string planner_;
};

}  // namespace

PlannerInfo with_index(PlannerInfo info, const IndexMethod& method) {
  info.guarantee = Guarantee::optimal;
  info.plans_on_terrain = false;
  info.can_step = false;
  info.jumps = true;
  const auto support = std::make_shared<const MethodSupport>(method, info.name);
  info.index_support = support;
  info.make = [support](const FreeSpace& space, const OptionValues& options) -> PlannerResult {
    auto index = support->build(space, {});
    if (!index) return Unexpected<PlannerError>(index.error());
    return support->make_planner(space, options, *std::move(index));
  };
  return info;
}

}  // namespace wend
