#pragma once

// TypedQuery: the query of `wend plan` and its answer in the user's coordinates: cells, or
// poses. The rest of `wend plan` does not know which.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/parser.hpp"
#include "cli/output/terminal.hpp"
#include "cli/watching/shown_layers.hpp"
#include "wend/analysis/cost_to_go.hpp"
#include "wend/analysis/search_recorder.hpp"
#include "wend/geometry/place_grid.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/scene.hpp"
#include "wend/report/plan_report.hpp"
#include "wend/report/posthoc_trace.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/session/eased_query.hpp"
#include "wend/session/explainer.hpp"

namespace wend::cli {

/// --start, --goal and --goal-tolerance
struct EndArguments {
  std::string start;
  std::vector<std::string> goals;  // one or more
  std::string tolerance = {};      // of all goals; empty: none
};

/// --goal-tolerance. It is read when the map is known, by typed_query().
void add_goal_tolerance(Parser& app, std::string& tolerance);

class TypedQuery {
 public:
  virtual ~TypedQuery() = default;
  TypedQuery(const TypedQuery&) = delete;
  TypedQuery& operator=(const TypedQuery&) = delete;

  /// Throws InputError for layers that such a query does not have.
  virtual void check(const ShownLayers& layers) const = 0;

  /// The query for a planner, without limits.
  virtual Query query() const = 0;

  /// The same in words.
  virtual Ends ends() const = 0;

  /// Takes the ends that --nearest has moved.
  virtual void move_ends(const EasedQuery& eased) = 0;

  /// The map with start and goals.
  virtual Scene scene() const = 0;

  /// The same with the reason why there is no path, as far as it can be drawn.
  virtual Scene scene_of_failure(Status status, GridMoves moves) const = 0;

  /// Costs to the goals from everywhere; nothing if there are none.
  virtual std::optional<CostToGo> cost_to_go(GridMoves moves, const Limits& limits) const = 0;

  /// Observers of a search for it.
  virtual SearchRecorder recorder() const = 0;
  virtual PosthocTrace trace(TraceForm form, std::uint64_t most_events) const = 0;

  /// The path step by step, as lines; empty if the map is too large for that to help.
  virtual std::string steps(const Plan& plan, const Screen& screen) const = 0;

  /// What was found and what it took, a line for each thing.
  virtual std::string summary(const PlanResult& result) const = 0;

 protected:
  TypedQuery() = default;
};

/// The query for the planner's motion. Throws InputError for text that is not a start, goal or tolerance of it.
std::unique_ptr<TypedQuery> typed_query(const PlannerSpec& planner, const FreeSpace& space,
                                        const Coordinates& coordinates, const EndArguments& ends);

class CellQuery final : public TypedQuery {
 public:
  CellQuery(FreeSpace space, const Coordinates& coordinates, const EndArguments& ends);

  void check(const ShownLayers& /*layers*/) const override {}
  Query query() const override;
  Ends ends() const override;
  void move_ends(const EasedQuery& eased) override;
  Scene scene() const override;
  Scene scene_of_failure(Status status, GridMoves moves) const override;
  std::optional<CostToGo> cost_to_go(GridMoves moves, const Limits& limits) const override;
  SearchRecorder recorder() const override;
  PosthocTrace trace(TraceForm form, std::uint64_t most_events) const override;
  std::string steps(const Plan& plan, const Screen& screen) const override;
  std::string summary(const PlanResult& result) const override;

 private:
  std::vector<Cell> goal_cells() const;

  FreeSpace space_;
  Coordinates coordinates_;
  Place start_;
  Point start_point_;  // in grid coordinates
  std::vector<Place> goals_;
  std::vector<Point>
      points_;  // the same as typed; where --nearest moved one, the middle of its cell
  GoalTolerance tolerance_;
};

/// Of a planner whose states have headings.
class PoseQuery final : public TypedQuery {
 public:
  /// `places`: those of the planner.
  PoseQuery(FreeSpace space, const Coordinates& coordinates, const PlaceGrid& places,
            const EndArguments& ends);

  void check(const ShownLayers& layers) const override;
  Query query() const override;
  Ends ends() const override;
  void move_ends(const EasedQuery& eased) override;
  Scene scene() const override;
  /// Components and the widest path apply to discs only.
  Scene scene_of_failure(Status /*status*/, GridMoves /*moves*/) const override { return scene(); }
  std::optional<CostToGo> cost_to_go(GridMoves moves, const Limits& limits) const override;
  SearchRecorder recorder() const override;
  PosthocTrace trace(TraceForm form, std::uint64_t most_events) const override;
  std::string steps(const Plan& plan, const Screen& screen) const override;
  std::string summary(const PlanResult& result) const override;

 private:
  FreeSpace space_;
  Coordinates coordinates_;
  PlaceGrid places_;
  TypedPose start_;
  std::vector<TypedPose> goals_;
  GoalTolerance tolerance_;
};

}  // namespace wend::cli
