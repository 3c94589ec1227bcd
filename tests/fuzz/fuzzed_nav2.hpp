#pragma once

// What Nav2's servers may ask of the plugins, in any order and with any numbers: costmaps that change or have another
// size, poses of NaN, footprints of a few points. Poses and commands of answers are finite, no planned pose lies in an
// obstacle, and failures are sentences.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "checks.hpp"
#include "fuzzed_bytes.hpp"
#include "fuzzed_follow.hpp"
#include "wend/control/controller.hpp"
#include "wend/planner/planners.hpp"
#include "wend_nav2/path_follower.hpp"
#include "wend_nav2/path_planner.hpp"
#include "wend_nav2/path_smoother.hpp"

namespace wend::test {

class FuzzedNav2 {
 public:
  explicit FuzzedNav2(std::string_view input) : bytes_(input) {}

  /// What is wrong, empty if nothing is.
  std::string run() {
    take_costs();
    for (int step = 0; step < kSteps && !bytes_.empty(); ++step) {
      std::string wrong = act();
      if (!wrong.empty()) return wrong;
    }
    return {};
  }

 private:
  static constexpr int kSteps = 8;
  static constexpr std::uint8_t kLethal = 254;

  std::string act() {
    switch (bytes_.byte() % 8) {
      case 0:
        return take_costs();
      case 1:
        return change_costs();
      case 2:
        return take_robot();
      case 3:
        return set_planner();
      case 4:
        return smooth();
      case 5:
        return follow();
      default:
        return plan();
    }
  }

  std::string take_costs() {
    layout_ = {.width = bytes_.byte() % 12,
               .height = bytes_.byte() % 12,
               .resolution = bytes_.byte() < 230 ? 0.1 : bytes_.number(),
               .origin = {bytes_.number(), bytes_.number()},
               .frame_id = "map"};
    costs_.assign(layout_.size(), 0);
    for (std::uint8_t& cost : costs_) {
      const std::uint8_t kind = bytes_.byte();
      if (kind >= 190) cost = kind < 220 ? kLethal : kind;
    }
    read_costs();
    return {};
  }

  std::string change_costs() {
    if (costs_.empty()) return {};
    const std::size_t count = bytes_.byte() % 5;
    for (std::size_t i = 0; i < count; ++i) costs_[bytes_.byte() % costs_.size()] = bytes_.byte();
    read_costs();
    return {};
  }

  void read_costs() {
    planner_.costmap().read(layout_, costs_);
    smoother_.costmap().read(layout_, costs_);
    follower_.costmap().read(layout_, costs_);
  }

  std::string take_robot() {
    std::vector<MapPoint> corners;
    const int count = bytes_.byte() % 6;
    for (int i = 0; i < count; ++i) corners.push_back({bytes_.number() - 1, bytes_.number() - 1});
    const auto footprint = wend_nav2::footprint_from(corners);
    if (!footprint) return check_text(footprint.error().message);
    robot_ = {.footprint = *footprint, .inflated = bytes_.byte() < 128};
    covers_its_origin_ = false;  // its origin may lie outside, and in an obstacle
    return {};
  }

  std::string set_planner() {
    const auto& infos = planners();
    const auto at = bytes_.byte() % static_cast<std::size_t>(infos.end() - infos.begin());
    const PlannerInfo& info = *(infos.begin() + static_cast<std::ptrdiff_t>(at));
    const std::uint8_t flags = bytes_.byte();
    OptionValues values{{"time_limit", "0.05"}, {"escape", "0"}};
    const auto flag = [&](std::uint8_t bit, const char* name) {
      values.emplace_back(name, (flags & bit) != 0 ? "true" : "false");
    };
    flag(1, "nearest");
    flag(2, "closest");
    flag(4, "replan");
    flag(8, "explain");
    flag(16, "allow_unknown");
    if ((flags & 32) != 0) values.emplace_back("obstacles", "inscribed");
    if ((flags & 64) != 0) values.emplace_back("tolerance", "0");
    const auto settings = wend_nav2::settings_from(info.name, values);
    if (!settings) return check_text(settings.error().message);
    planner_.set(*settings);
    return {};
  }

  MapPose place() {
    const MapPose corner{layout_.origin.x, layout_.origin.y, 0};
    if (bytes_.byte() >= 240) return {bytes_.number(), bytes_.number(), bytes_.number()};
    const double cell = layout_.resolution;
    return {corner.x + cell * (bytes_.byte() % 130) / 10,
            corner.y + cell * (bytes_.byte() % 130) / 10, 0.1 * (bytes_.byte() - 128)};
  }

  std::string plan() {
    const wend_nav2::PathRequest request{place(), place(), robot_};
    const auto poses = planner_.plan(request, nullptr);
    if (!poses) return check_text(poses.error().message);
    if (poses->empty()) return "a path without poses";
    for (const MapPose& pose : *poses) {
      if (!is_finite(pose)) return "a pose that is not finite";
      if (covers_its_origin_ && lies_in_obstacle(pose)) return "a pose in an obstacle";
    }
    path_ = *poses;
    return {};
  }

  std::string smooth() {
    const auto result = smoother_.smooth(given_path(), robot_, [] { return false; });
    if (!result) return check_text(result.error().message);
    return std::ranges::all_of(result->poses, [](const MapPose& pose) { return is_finite(pose); })
               ? ""
               : "a smoothed pose that is not finite";
  }

  std::string follow() {
    const auto names = controllers();
    const auto at = bytes_.byte() % static_cast<std::size_t>(names.end() - names.begin());
    const auto settings = wend_nav2::control_settings_from(
        (names.begin() + static_cast<std::ptrdiff_t>(at))->name, {});
    if (!settings) return check_text(settings.error().message);
    follower_.set(*settings);
    follower_.set_goal_tolerance(bytes_.number(), bytes_.number());
    follower_.set_speed_limit(bytes_.number());
    if (const auto taken = follower_.set_path(given_path()); !taken)
      return check_text(taken.error().message);
    MapPose at_pose = path_.empty() ? place() : path_.front();
    for (int i = 0; i < 4; ++i) {
      const Velocity measured{bytes_.number(), bytes_.number(), 0};
      const auto velocity = follower_.command(
          {at_pose, at_pose, measured, robot_, bytes_.byte() < 230 ? 0.05 : bytes_.number()});
      if (!velocity) {
        std::string wrong = check_text(velocity.error().message);
        if (!wrong.empty()) return wrong;
      } else if (!test::is_finite(*velocity)) {
        return "a command that is not finite";
      }
      if (bytes_.byte() >= 128) at_pose = place();
    }
    return {};
  }

  /// The last one that was planned, or any poses.
  std::vector<MapPose> given_path() {
    if (bytes_.byte() < 150) return path_;
    std::vector<MapPose> path;
    const int count = bytes_.byte() % 8;
    for (int i = 0; i < count; ++i) path.push_back(place());
    return path;
  }

  static bool is_finite(const MapPose& pose) {
    return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
  }

  bool lies_in_obstacle(const MapPose& pose) const {
    const double column = (pose.x - layout_.origin.x) / layout_.resolution;
    const double row = (pose.y - layout_.origin.y) / layout_.resolution;
    // Near an edge of a cell, rounding decides.
    const auto is_inside = [](double at) { return std::abs(at - std::round(at)) > 1e-6; };
    if (!is_inside(column) || !is_inside(row)) return false;
    if (!(column > 0 && row > 0 && column < layout_.width && row < layout_.height)) return false;
    const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(layout_.width) +
                      static_cast<std::size_t>(column);
    return costs_[cell] == kLethal;
  }

  FuzzedBytes bytes_;
  wend_nav2::CostmapLayout layout_;
  std::vector<std::uint8_t> costs_;
  wend_nav2::RobotShape robot_;
  bool covers_its_origin_ = true;
  wend_nav2::PathPlanner planner_;
  wend_nav2::PathSmoother smoother_;
  wend_nav2::PathFollower follower_;
  std::vector<MapPose> path_;
};

inline std::string fuzz_nav2(std::string_view input) { return FuzzedNav2(input).run(); }

}  // namespace wend::test
