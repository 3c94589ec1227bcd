#pragma once

// The legs of a request that has vias: planned one after the other, each from where the one before ended, and joined.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/error.hpp"
#include "wend/geometry/frame.hpp"
#include "wend/geometry/pose.hpp"
#include "wend/path/path.hpp"
#include "wend/session/plan_request.hpp"

namespace wend {

/// The legs of a path with so many vias, by name; nothing else of them is known.
WEND_API std::vector<PlanLeg> named_legs(std::size_t vias, bool closed);

/// What to say before what is said of a leg: "leg 2 of 3, from via 1 to the goal: "
WEND_API std::string leg_words(std::span<const PlanLeg> legs, std::size_t leg);

/// Where a path begins, as a pose; its heading is that of a drive.
WEND_API Pose beginning_of(const Path& path);
/// Where it ends.
WEND_API Pose end_of(const Path& path);

/// What plans a leg, and what is known of it.
struct LegPlanner {
  /// Plans a request without vias. The limits on this call, and those that messages name, differ.
  std::function<Expected<PlanAnswer, RequestFailure>(const PlanRequest& leg, const Deadline&,
                                                     std::uint64_t expansions)>
      plan;
  bool headings = false;  // have its states headings?
  bool anytime = false;   // does it use up its limits? Then each leg gets its share of what is left
};

/// Why a request that has_legs() is not valid, as far as that is about its legs.
std::optional<Error> fault_of_legs(const PlanRequest& request);

/// Plans a valid request that has_legs(). The deadline and the limit on expansions are of all legs together.
Expected<PlanAnswer, RequestFailure> plan_legs(const PlanRequest& request, const Frame& frame,
                                               const LegPlanner& planner, const Deadline& deadline);

}  // namespace wend
