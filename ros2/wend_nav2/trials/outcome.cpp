// SPDX-License-Identifier: Apache-2.0
#include "outcome.hpp"

#include <chrono>
#include <cmath>
#include <tuple>
#include <utility>

#include <nav2_core/planner_exceptions.hpp>

#include "../src/pose_messages.hpp"

namespace wend_nav2::trials {
namespace {

geometry_msgs::msg::PoseStamped stamped(const wend::MapPose& pose) {
  geometry_msgs::msg::PoseStamped message;
  message.header.frame_id = "map";
  message.pose = to_message(pose);
  return message;
}

/// The exceptions in the order in which the planner server catches them.
std::pair<std::string, std::string> code_of_current_exception() {
  try {
    throw;
  } catch (const nav2_core::InvalidPlanner& error) {
    return {"INVALID_PLANNER", error.what()};
  } catch (const nav2_core::StartOccupied& error) {
    return {"START_OCCUPIED", error.what()};
  } catch (const nav2_core::GoalOccupied& error) {
    return {"GOAL_OCCUPIED", error.what()};
  } catch (const nav2_core::NoValidPathCouldBeFound& error) {
    return {"NO_VALID_PATH", error.what()};
  } catch (const nav2_core::PlannerTimedOut& error) {
    return {"TIMEOUT", error.what()};
  } catch (const nav2_core::StartOutsideMapBounds& error) {
    return {"START_OUTSIDE_MAP", error.what()};
  } catch (const nav2_core::GoalOutsideMapBounds& error) {
    return {"GOAL_OUTSIDE_MAP", error.what()};
  } catch (const nav2_core::PlannerTFError& error) {
    return {"TF_ERROR", error.what()};
  } catch (const nav2_core::PlannerCancelled& error) {
    return {"CANCELED", error.what()};
  } catch (const std::exception& error) {
    return {"UNKNOWN", error.what()};
  }
}

}  // namespace

Outcome call(nav2_core::GlobalPlanner& planner, const wend::MapPose& start,
             const wend::MapPose& goal, const CancelChecker& cancelled) {
  Outcome outcome;
  const auto begin = std::chrono::steady_clock::now();
  try {
    outcome.path = planner.createPlan(stamped(start), stamped(goal), cancelled);
    outcome.code = outcome.path.poses.empty() ? "NO_VALID_PATH" : "NONE";
  } catch (...) {
    std::tie(outcome.code, outcome.message) = code_of_current_exception();
  }
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  outcome.milliseconds = took.count();
  return outcome;
}

double length_of(const nav_msgs::msg::Path& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.poses.size(); ++i) {
    const auto& a = path.poses[i - 1].pose.position;
    const auto& b = path.poses[i].pose.position;
    length += std::hypot(b.x - a.x, b.y - a.y);
  }
  return length;
}

}  // namespace wend_nav2::trials
