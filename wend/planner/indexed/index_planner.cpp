#include "wend/planner/indexed/index_planner.hpp"

#include "wend/planner/failure_causes.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/rest_of_path.hpp"

namespace wend {
namespace {

using AnswersResult = Expected<std::unique_ptr<IndexAnswers>, Error>;

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
  /// Builds an index for another FreeSpace.
  using IndexBuilder = std::function<Expected<IndexBytes, Error>(const FreeSpace&)>;
  /// Opens an index.
  using Opener = std::function<AnswersResult(const FreeSpace&, IndexBytes)>;

  IndexPlanner(FreeSpace space, IndexBuilder build, Opener open)
      : Planner(std::move(space)), build_(std::move(build)), open_(std::move(open)) {}

  /// Why the index cannot be used, if it cannot.
  std::optional<Error> use(IndexBytes index) {
    auto opened = open_(free_space(), index);
    if (!opened) return why_none_ = opened.error();
    answers_ = *std::move(opened);
    index_ = std::move(index);
    return std::nullopt;
  }

 private:
  std::optional<Status> do_check(const Query& query) override {
    if (answers_ == nullptr) return why_none_.status;
    return cells_.assign(free_space(), Adjacency::edges, query);
  }

  Status do_plan(const Query& query, Plan& out) override {
    const Limits& limits = query.limits;
    if (const auto status = stopped(limits)) return *status;
    const double begin = limits.now();
    const Cell start = cells_.start;
    const Cell goal = nearest_goal(start, out.metrics);
    if (start != goal) find(start, goal, out.metrics);
    if (limits.timed() && limits.now() - begin > limits.seconds) return Status::time_limit;
    if (start == goal) {
      answers_->write_place(start, out.path);
      out.metrics = {1, 1, 1};
      out.cost = 0;
    } else {
      const auto cost = answers_->write(out.path);
      if (!cost) return Status::index_mismatch;
      out.cost = *cost;
    }
    out.bound = answers_->bound();
    return Status::found;
  }

  double find(Cell start, Cell goal, SearchMetrics& metrics) {
    const double cost = answers_->find(start, goal);
    const SearchMetrics work = answers_->metrics();
    metrics.expanded += work.expanded;
    metrics.generated += work.generated;
    metrics.max_frontier = std::max(metrics.max_frontier, work.max_frontier);
    return cost;
  }

  /// With one goal there is nothing to look up.
  Cell nearest_goal(Cell start, SearchMetrics& metrics) {
    if (cells_.goals.size() == 1 && cells_.goals.front().is_one_place()) {
      return cells_.goals.front().any();
    }
    goals_.clear();
    const auto open = [&](Cell cell) {
      return free_space().contains(cell) &&
             free_space().components().connected(start, cell, Adjacency::edges);
    };
    append_entrances(cells_.goals, start, open, goals_);
    Cell nearest = goals_.front();
    if (goals_.size() == 1) return nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const Cell goal : goals_) {
      const double cost = goal == start ? 0 : find(start, goal, metrics);
      if (cost < least) nearest = goal;
      least = std::min(least, cost);
    }
    return nearest;
  }

  std::vector<FailureCause> do_failure(const Query& query, Status status) const override {
    if (answers_ == nullptr) return {OwnText{why_none_.message}};
    return causes_in_cells(free_space(), query, status);
  }

  std::optional<Plan> do_rest_of(const Path& path, const Query& query,
                                 std::size_t& passed) const override {
    if (answers_ == nullptr) return std::nullopt;
    if (path.cells().empty())
      return rest_of_lines(free_space(), Adjacency::edges, path, query, passed);
    return rest_of_steps(free_space(), {}, path.cells(), query, passed);
  }

  std::unique_ptr<Planner> do_clone() const override {
    auto planner = std::make_unique<IndexPlanner>(free_space(), build_, open_);
    if (answers_ == nullptr) {
      planner->why_none_ = why_none_;
    } else {
      planner->use(*index_);  // NOLINT(bugprone-unchecked-optional-access): answers have one
    }
    return planner;
  }

  /// An edit does not build the index again: that may take minutes. The index is used as long as it matches.
  std::optional<Error> do_update(const SpaceChange& change) override {
    answers_.reset();  // frees its memory first
    if (!change.everything && index_) return use(*index_);
    index_.reset();
    auto built = build_(free_space());
    if (!built) return why_none_ = built.error();
    return use(*std::move(built));
  }

  void do_release() override { answers_.reset(); }

  IndexBuilder build_;
  Opener open_;
  std::optional<IndexBytes> index_;  // the last one that could be used; clones share it
  std::unique_ptr<IndexAnswers> answers_;
  Error why_none_{Status::found, {}};  // if there are no answers
  GridQuery cells_;
  std::vector<Cell> goals_;  // where a path enters those of cells_
};

class MethodSupport final : public IndexSupport {
 public:
  MethodSupport(IndexMethod method, std::string planner)
      : method_(std::move(method)), planner_(std::move(planner)) {}

  Expected<IndexBytes, Error> build(const FreeSpace& space,
                                    const IndexBuilding& building) const override {
    if (auto refused = refused_terrain(planner_, space)) return Unexpected<Error>(*refused);
    auto built = method_.build(space.passable(), building);
    if (!built) return Unexpected<Error>(built.error());
    return *std::move(built);
  }

  PlannerResult make_planner(const FreeSpace& space, const OptionValues& options,
                             IndexBytes index) const override {
    if (auto refused = refused_options(options)) {
      return Unexpected<Error>(*std::move(refused));
    }
    // The planner may outlive this object.
    const auto build = [method = method_, name = planner_](const FreeSpace& other) {
      return MethodSupport(method, name).build(other, {});
    };
    const auto open = [method = method_, name = planner_](const FreeSpace& other,
                                                          IndexBytes bytes) {
      return MethodSupport(method, name).open(other, std::move(bytes));
    };
    auto planner = std::make_unique<IndexPlanner>(space, build, open);
    if (auto fault = planner->use(std::move(index))) return Unexpected<Error>(*std::move(fault));
    return planner;
  }

 private:
  AnswersResult open(const FreeSpace& space, IndexBytes index) const {
    if (auto refused = refused_terrain(planner_, space)) return Unexpected<Error>(*refused);
    auto opened = method_.open(std::move(index), space);
    if (!opened)
      return failure(Status::index_mismatch, "index does not match: " + opened.error().message,
                     opened.error().where);
    return *std::move(opened);
  }

  IndexMethod method_;
  std::string planner_;
};

}  // namespace

PlannerInfo with_index(PlannerInfo info, const IndexMethod& method) {
  info.capabilities.jumps = true;
  const auto support = std::make_shared<const MethodSupport>(method, info.name);
  info.index_support = support;
  info.make = [support](const FreeSpace& space, const OptionValues& options) -> PlannerResult {
    auto index = support->build(space, {});
    if (!index) return Unexpected<Error>(index.error());
    return support->make_planner(space, options, *std::move(index));
  };
  return info;
}

}  // namespace wend
