#pragma once

// SearchPlanner: a planner that answers by a SearchEngine. Who derives from it takes queries apart,
// begins the engine, and says what the path that it found is worth.

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "wend/planner/planner.hpp"
#include "wend/planner/search_engine.hpp"

namespace wend {

template <class Engine>
class SearchPlanner : public Planner {
 public:
  /// False if there was no memory for the search; true where there is no engine, because the map is
  /// of a kind that it cannot plan on.
  bool allocated() const { return engine_ == nullptr || engine_->allocated(); }

 protected:
  explicit SearchPlanner(FreeSpace free_space) : Planner(std::move(free_space)) {}

  /// The error if allocated() is false, for planners of poses.
  std::optional<Error> no_memory_for(const std::string& whose) const {
    if (allocated()) return std::nullopt;
    return Error{Status::memory_limit,
                 "no memory for the " + std::to_string(state_count()) + " poses of " + whose};
  }

  /// Goes on with a search that has begun, to its end.
  Status run_on(SearchOutcome outcome, const Limits& limits, Plan& out) {
    while (outcome == SearchOutcome::running || outcome == SearchOutcome::improved) {
      if (outcome == SearchOutcome::improved) {
        take_solution(out);
        if (is_enough(limits)) return Status::found;
      }
      outcome = engine_->run();
    }
    return finish(outcome, out);
  }

  Status plan_by_search(const Query& query, Plan& out) {
    begin_search(query.limits, query.observer);
    return run_on(SearchOutcome::running, query.limits, out);
  }

  std::optional<Status> begin_by_search(const Query& query, Plan& out) {
    limits_ = query.limits;
    begin_search(limits_, query.observer);
    out.metrics = engine_->metrics();
    return std::nullopt;
  }

  std::shared_ptr<Engine> engine_;

 private:
  /// Begins the search of the query that was checked last. Both live as long as the search.
  virtual void begin_search(const Limits& limits, SearchObserver* observer) = 0;

  Status do_plan(const Query& query, Plan& out) override { return plan_by_search(query, out); }
  std::optional<Status> do_begin(const Query& query, Plan& out) override {
    return begin_by_search(query, out);
  }

  /// Cost, bound and whatever else there is to say of the path in `out`.
  virtual void assess(Plan& out) = 0;

  std::optional<Status> do_step(Plan& out) final {
    const SearchOutcome outcome = engine_->step();
    out.metrics = engine_->metrics();
    if (outcome == SearchOutcome::improved) {
      take_solution(out);
      if (is_enough(limits_)) return Status::found;
    }
    if (outcome == SearchOutcome::running || outcome == SearchOutcome::improved) {
      return std::nullopt;
    }
    return finish(outcome, out);
  }

  bool do_anytime() const final { return engine_ != nullptr && engine_->bound().has_value(); }

  OpenList do_open_list(std::size_t most) const final {
    return engine_ == nullptr ? OpenList{} : engine_->open_list(most);
  }

  /// A path after which an anytime search goes on.
  void take_solution(Plan& out) {
    write(out);
    tell_solution(out);
  }

  /// Was the search cancelled by who received the last path?
  static bool is_enough(const Limits& limits) {
    return limits.cancel != nullptr && limits.cancel->load(std::memory_order_relaxed);
  }

  Status finish(SearchOutcome outcome, Plan& out) {
    if (outcome != SearchOutcome::found) {
      clear(out);  // an earlier path
      out.metrics = engine_->metrics();
      return status_of(outcome);
    }
    write(out);
    return Status::found;
  }

  void write(Plan& out) {
    out.metrics = engine_->metrics();
    out.moves.clear();
    engine_->write_path(out.path);
    assess(out);
  }

  Limits limits_;  // of a search that is stepped
};

}  // namespace wend
