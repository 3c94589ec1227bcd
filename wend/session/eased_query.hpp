#pragma once

// EasedQuery: a query, and what a leeway makes of it where the robot cannot be. Front ends plan it like any other:
//
//   wend::EasedQuery eased(query, planner, explainer, wend::Units(space.map()), leeway);
//   wend::Status status = planner.plan(eased.query(), plan);
//   if (eased.ease_goals(status)) status = planner.plan(eased.query(), plan);
//   if (status == wend::Status::found) eased.finish(plan);
//
// First a blocked start is led out (way_out.hpp), then blocked ends are moved, and if no path reaches a goal, the goals
// become the closest places (closest_place.hpp).

#include <optional>
#include <string>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/planner/plan.hpp"
#include "wend/planner/planner.hpp"
#include "wend/session/explainer.hpp"
#include "wend/session/leeway.hpp"
#include "wend/session/plan_request.hpp"
#include "wend/session/way_out.hpp"

namespace wend {

class WEND_API EasedQuery {
 public:
  /// Leads the start out and moves blocked ends. Planner and explainer must outlive it; the explainer is for this leeway
  /// (Explainer::allow()), which is valid.
  EasedQuery(Query query, Planner& planner, const Explainer& explainer, const Units& units,
             const Leeway& leeway);

  /// The query as it is to be planned.
  const Query& query() const { return query_; }
  /// The same to set limits and observers.
  Query& query() { return query_; }

  /// Its ends in words; those that were not moved or led out, as they were typed.
  Ends ends(const EndTexts& typed) const;

  /// May ease_goals() replace the goals after a search? False if it is known before that a path reaches one. O(goals).
  bool may_ease_goals() const;
  /// After a plan failed: puts the closest places in the place of the goals. True if there are some: then plan again.
  bool ease_goals(Status status);

  /// After a plan was found: a sentence for each thing that was eased, and what else there is to say. A path over cells
  /// begins and ends at the points of the query where it can (with_ends()); its cost stays that of the way between the
  /// centres.
  void finish(Plan& plan);

  /// Sentences about ends that were moved, led out or replaced.
  const std::vector<std::string>& notes() const { return notes_; }
  /// The way from the start to where the plan begins; an empty path if it begins at the start.
  const Path& lead() const { return lead_; }
  /// The same as parts of the whole path.
  const std::optional<LeadOut>& lead_out() const { return lead_out_; }
  /// The distance from the path's end to the nearest goal, in cells: 0 where a goal was reached. Set if the leeway says
  /// closest, or goals were replaced.
  std::optional<double> remaining() const { return remaining_; }

 private:
  void lead_start_out();
  void move_ends();
  void end_exactly(Plan& plan) const;
  Point goal_in_cell(Point end) const;
  std::string why_blocked(const Query& query) const;

  Query query_;
  Planner& planner_;
  const Explainer& explainer_;
  Units units_;
  Leeway leeway_;
  Pose asked_start_;
  std::vector<Goal> asked_goals_;
  bool goals_eased_ = false;
  std::vector<std::string> notes_;
  Path lead_;
  std::optional<LeadOut> lead_out_;
  std::optional<double> remaining_;
};

/// The ends of a query in words.
WEND_API Ends ends_of(const Query& query, const Units& units);

/// Puts the lead before a plan's path, with names for its moves if the planner names them.
WEND_API void begin_with(const Path& lead, Plan& plan, const Frame& frame);

}  // namespace wend
