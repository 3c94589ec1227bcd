#pragma once

// HybridSearch: hybrid A*: a search over continuous poses, of which one is kept for each small box of positions and
// headings. D. Dolgov, S. Thrun, M. Montemerlo, J. Diebel, "Practical Search Techniques in Path Planning for
// Autonomous Driving", 2008, and "Path Planning for Autonomous Vehicles in Unknown Semi-structured Environments", 2010.
//
// A pose is expanded by short motions (Steering::primitives()). Longer connections come on top: from time to time
// the search follows the descent of the cost field and connects to poses on this trace, or to the goal. They are
// ordinary edges, with their true costs: what the search finds without them, it finds with them.
//
// The search goes on for a while after it has found a path, as long as a better one is likely.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/limits.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/se2/descent_trace.hpp"
#include "wend/planner/se2/drive.hpp"
#include "wend/planner/se2/hybrid_goal.hpp"
#include "wend/planner/se2/hybrid_resolution.hpp"
#include "wend/planner/se2/pose_table.hpp"
#include "wend/search/search_outcome.hpp"
#include "wend/space/se2/coarse_cost_field.hpp"
#include "wend/space/se2/goal_ring.hpp"
#include "wend/space/se2/motion_check.hpp"
#include "wend/space/se2/steering.hpp"
#include "wend/space/se2/turning_cost.hpp"

namespace wend {

class HybridSearch {
 public:
  /// From which end a search begins. A drive from the goal back to the start is one of a robot that faces the other
  /// way, so it costs the same.
  enum class Direction { from_start, from_goal };

  /// All but the resolution must outlive the search.
  HybridSearch(const MotionCheck& check, const Steering& steering, GoalRing& ring,
               const CoarseGrid& grid, const HybridResolution& resolution,
               Direction direction = Direction::from_start);
  virtual ~HybridSearch() = default;
  HybridSearch(const HybridSearch&) = delete;
  HybridSearch& operator=(const HybridSearch&) = delete;

  /// Begins a query. The goals and the observer (may be null) must outlive the search. A search from the goal needs
  /// one goal with a heading. `stop` is asked now and then whether the search must end; null: never. Once it has said
  /// so, the search is of no use.
  void begin(const Pose& start, std::span<const HybridGoal> goals, SearchObserver* observer,
             std::function<bool()> stop = {});

  /// Expands at most `most` poses. Found: no better path is likely.
  SearchOutcome run(std::uint64_t most);

  /// Is there a path, though a better one may come?
  bool has_path() const { return best_ != kNone; }
  double best_cost() const { return best_cost_; }
  /// The index of the goal that the path reaches.
  std::size_t goal() const { return best_goal_; }
  /// Writes the motions of the path from the start on.
  void write_path(DrivenMotions& path) const;

  const SearchMetrics& metrics() const { return metrics_; }
  /// The heuristic from a pose to the goals of the query; no more than is known of it.
  double heuristic(const Pose& pose) const { return estimate(pose).cost; }

 protected:
  using Index = std::uint32_t;
  static constexpr Index kNone = PoseTable::kNone;

  struct Node {
    Pose pose;
    double g;
    double h;
    Index parent;
    Index first_motion;  // in motions_
    std::uint16_t motion_count;
    int gear;          // of the last motion that had one
    bool exact;        // is h that of the settled field?
    bool traced;       // made by a trace
    std::uint8_t age;  // primitives since the last trace
  };

  const Node& node(Index index) const { return nodes_[index]; }
  /// No node has the pose's box any more.
  void free_box(const Pose& pose) { seen_[pose] = kNone; }

  /// Adds the pose, by the cheapest of some connections that the robot can drive.
  bool connect_to(Index node, const Pose& to, std::size_t words, bool exactly = false);
  /// The cost of driving the motions from a node, if the robot can and it costs less than the limit.
  std::optional<double> drive(Index node, std::span<const Motion> motions, double limit);
  /// Adds the pose at the end of some motions, unless its box has one that is as good.
  bool add(Index parent, std::span<const Motion> motions, double cost, bool traced,
           const Pose* exactly = nullptr);
  void try_goals(Index node);

 private:
  struct Open {
    double f;
    Index node;

    friend bool operator<(const Open& a, const Open& b) {
      return a.f > b.f || (a.f == b.f && a.node < b.node);
    }
  };

  CoarseCostField::Value estimate(const Pose& pose) const;
  CoarseCostField::Seed seed_of(const HybridGoal& goal) const;
  double f_of(const Node& node) const { return node.g + resolution_.weight * node.h; }
  bool may_stop(double least_f) const;

  void expand(Index node);
  /// Adds what a pose leads to; `to_goal`: the goals are to be tried, too.
  virtual void expand_from(Index node, bool to_goal);
  void expand_primitives(Index node);
  void expand_to_contact(Index node, const Motion& primitive);
  bool is_near_goal(Index node) const;
  bool is_worth_trying(Index node);
  double way_of(const Pose& pose, const Motion& motion) const;
  double arrival(const Pose& pose, const HybridGoal& goal) const;
  void expand_trace(Index node);
  void connect_trace(Index node);
  bool try_goal(Index node, const HybridGoal& goal);
  void keep(Node& node, Index parent, std::span<const Motion> motions);
  void offer_goal(Index node, const HybridGoal& goal);
  void write_way(const Node& node);
  void tell(const Node& node, bool expanded);

  const MotionCheck& check_;
  const Steering& steering_;
  const CoarseGrid& grid_;
  Direction direction_;
  HybridGoal start_as_goal_;
  HybridResolution resolution_;
  TurningCost turning_;
  GoalRing& ring_;
  CoarseCostField field_;
  DescentTrace trace_;
  PoseTable seen_;
  PoseTable traced_;
  std::vector<Node> nodes_;
  std::vector<Motion> motions_;
  std::vector<Open> open_;
  std::vector<CoarseCostField::Seed> seeds_;
  std::span<const HybridGoal> goals_;
  SearchObserver* observer_ = nullptr;
  std::vector<Pose> way_;  // of the event that is told
  SearchMetrics metrics_;
  Index best_ = kNone;
  double best_cost_ = 0;
  std::size_t best_goal_ = 0;
  std::uint64_t expanded_at_first_path_ = 0;
  double nearest_try_ =
      0;  // the least heuristic from which a search to contact has tried the goals
};

}  // namespace wend
