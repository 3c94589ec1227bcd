#pragma once

// The options of the planners whose paths turn at any angle, as structs. Front ends set the same fields by
// name.
//
//   const auto planner = wend::make_planner(space, wend::ThetaStarOptions{.weight = 1.5});

#include <string_view>

#include "wend/base/options.hpp"
#include "wend/space/grid/grid_moves.hpp"

namespace wend {

/// When a search looks for obstacles on the line from a parent.
enum class SightCheck {
  when_reached,   // Theta*
  when_expanded,  // Lazy Theta*
};

/// The options of `theta_star` and `lazy_theta_star`.
template <SightCheck kCheck>
struct AnyAngleOptions {
  /// The planner's name.
  static constexpr std::string_view kPlanner =
      kCheck == SightCheck::when_reached ? "theta_star" : "lazy_theta_star";

  CornerRule corner_rule = CornerRule::none;  // what a path may squeeze through
  double weight = 1;                          // w >= 0 in f = g + w h

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"corner_rule",
           "corners that a path may cut: both lets it pass between two obstacles that touch at a "
           "corner; none and one do not"},
          self.corner_rule);
    field({"weight", "w in f = g + w h, where h is the straight distance to the goal"}, self.weight,
          OptionRange{0, 1e6});
  }
};

/// The options of `theta_star`.
using ThetaStarOptions = AnyAngleOptions<SightCheck::when_reached>;
/// The options of `lazy_theta_star`.
using LazyThetaStarOptions = AnyAngleOptions<SightCheck::when_expanded>;

/// The options of `any_angle`.
struct ShortestAnyAngleOptions {
  /// The planner's name.
  static constexpr std::string_view kPlanner = "any_angle";

  CornerRule corner_rule = CornerRule::none;  // what a path may squeeze through

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"corner_rule",
           "corners that a path may cut: both lets it pass between two obstacles that touch at a "
           "corner; none and one do not"},
          self.corner_rule);
  }
};

}  // namespace wend
