#pragma once

// Explainer: why a query has no path, in sentences: which end is blocked, by what, how far the nearest
// free cell is, or what separates start and goal, and what would open a path.
//
//   const wend::Explainer explainer(space, wend::Units(space.map()), {}, {});
//   report(explainer.explain(planner, query, ends, planner.failure(query, status), metrics));

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/analysis/no_drive.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/limits.hpp"
#include "wend/base/status.hpp"
#include "wend/planner/failure.hpp"
#include "wend/planner/planner.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/session/failure_text.hpp"
#include "wend/session/leeway.hpp"
#include "wend/session/units.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

class WEND_API Explainer {
 public:
  /// For planners that move so. O(1).
  Explainer(FreeSpace space, Units units, GridMoves moves, Hints hints)
      : space_(std::move(space)), units_(units), moves_(moves), hints_(std::move(hints)) {}

  /// What the queries may do where the robot cannot be. Until then: nothing, but ends are moved however far.
  void allow(const Leeway& leeway) { leeway_ = leeway; }

  /// When explanations must end: what takes longer is left out, and the sentence says so. Until then: never.
  void stop_at(Deadline deadline) { deadline_ = std::move(deadline); }
  /// That deadline.
  const Deadline& deadline() const { return deadline_; }

  /// What is so, as words_of() says it in these units, without looking for what would help.
  std::string words(const Failure& failure, const SearchMetrics& metrics = {}) const;

  /// The same with what would help, as far as it was found to: for a failure of a planner on cells. `ends` are those of
  /// the query. O(cells log cells) if start and goal are not connected, else O(cells until the nearest free one).
  std::string explain(const Failure& failure, const Ends& ends, const SearchMetrics& metrics) const;

  /// The same for a query that `planner` answered, and the failure that it made of it.
  std::string explain(const Planner& planner, const Query& query, const Ends& ends,
                      const Failure& failure, const SearchMetrics& metrics) const;

  /// "the start (3,4) is outside the map, which covers ..."
  std::string outside(const Place& place) const;

  /// "the start (3,4) is blocked: the cell is an obstacle"; empty if it is not.
  std::string blocked(const Place& place) const;

  /// Moves start and goals to free cells by nearest_ends(): the start with the first goal. An end stays if it would
  /// move farther than the leeway says. A sentence for each that moved: "the start (3,4) is blocked: ...; planning from (3,5), 1 cell away".
  std::vector<std::string> move_to_nearest(Ends& ends) const;
  /// The same for a planner with headings, by Planner::nearest_free(). An end stays if there is no free place.
  std::vector<std::string> move_to_nearest(Query& query, const Planner& planner) const;

  /// A sentence about a polygon for which the planner takes the disc around it, as planners on cells do: the radius,
  /// and which planners plan with the polygon itself. Empty for other robots and planners.
  std::string planned_as_disc(const Planner& planner) const;

  /// Why a search was stopped: "stopped after 1000 expansions"; for other statuses, what they mean.
  std::string stopped(Status status, const Limits& limits, const SearchMetrics& metrics) const;

  /// What would open a path: "unknown cells free (--unknown free)".
  std::string change(const Way& way) const;

  /// What would open a drive, each by itself: "a turning radius of at most 0.3 m (--turning-radius 0.3)". Empty if
  /// nothing that was tried does.
  std::vector<std::string> changes(const NoDrive& why) const;

  /// Why there is no drive, and what would open one, in one or more sentences.
  std::string explain(const NoDrive& why) const;

  /// How wide a path is and where it is narrowest: "with a radius of up to 0.3 m, narrowest at ...".
  std::string width(const WidestPath& widest) const;

 private:
  template <class Helped>
  std::string with_help(const Failure& failure, const Ends& ends, const SearchMetrics& metrics,
                        Helped&& helped) const;
  std::string helped(const FailureCause& cause, const Failure& failure, const Ends& ends,
                     const SearchMetrics& metrics) const;
  std::string explain_pose(const Failure& failure, const Planner& planner, const Query& query,
                           const Ends& ends, const SearchMetrics& metrics) const;
  std::string move(Place& place, Cell cell, std::string_view preposition) const;
  std::string nearest(const Place& place, const Place& other) const;
  std::string nearest_place(const Planner& planner, const Goal& end, bool is_start) const;
  std::string planned_from(double away, bool is_start, std::string_view place) const;
  std::string opened_by_unknown(const Planner& planner, const Query& query) const;
  std::string ways_out(const Planner& planner, const Query& query) const;
  std::string too_far(double away) const;
  std::string nearest_beyond_limit(const Planner& planner, const Query& query, Status status) const;
  double most_moved() const;
  std::string hint_of_length(double cells) const;
  std::string unreachable(const Place& start, const Place& goal) const;

  FreeSpace space_;
  Units units_;
  GridMoves moves_;
  Hints hints_;
  std::optional<Leeway> leeway_ = {};
  Deadline deadline_ = {};
};

}  // namespace wend
