#include "wend/planner/planner_info.hpp"

namespace wend {

std::string_view to_string(Promise promise) {
  switch (promise) {
    case Promise::none:
      return "none";
    case Promise::complete:
      return "complete";
    case Promise::fewest_steps:
      return "fewest steps";
    case Promise::bounded:
      return "bounded";
    case Promise::optimal:
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

}  // namespace wend
