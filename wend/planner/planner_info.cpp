#include "wend/planner/planner_info.hpp"

namespace wend {

std::string_view to_string(Guarantee guarantee) {
  switch (guarantee) {
    case Guarantee::none:
      return "none";
    case Guarantee::complete:
      return "complete";
    case Guarantee::fewest_steps:
      return "fewest steps";
    case Guarantee::bounded:
      return "bounded";
    case Guarantee::optimal:
      return "optimal";
  }
  return {};
}

std::string_view to_string(Motion motion) {
  switch (motion) {
    case Motion::cells:
      return "cells";
    case Motion::car:
      return "car";
  }
  return {};
}

std::string_view to_string(Preprocessing preprocessing) {
  switch (preprocessing) {
    case Preprocessing::none:
      return "none";
    case Preprocessing::quick:
      return "quick";
    case Preprocessing::slow:
      return "slow";
  }
  return {};
}

std::optional<PlannerError> refused_terrain(std::string_view planner, const FreeSpace& space) {
  if (space.uniform_terrain()) return std::nullopt;
  return PlannerError{
      Status::unsupported_map,
      std::string(planner) +
          " supports uniform terrain only; this map has terrain or clearance costs"};
}

}  // namespace wend
