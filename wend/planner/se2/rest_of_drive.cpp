#include "wend/planner/se2/rest_of_drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/path/path_collision.hpp"

namespace wend {
namespace {

constexpr double kRoundingOfRest = 1e-6;  // cells, radians

/// A line whose ends were rounded is no arc, which may cost more.
Motion motion_between(const Pose& from, const Pose& to) {
  constexpr double kNoTurn = 1e-9;  // radians
  const Segment segment = segment_between(from, to);
  const double turn = std::abs(segment.turn) < kNoTurn ? 0 : segment.turn;
  return {segment.length, turn, segment.course};
}

DrivenMotions drive_from(std::span<const Pose> poses, const PlaceOnDrive& place) {
  DrivenMotions drive;
  Pose from = place.pose;
  for (const Pose& to : poses.subspan(place.joint + 1)) {
    drive.push_back({from, motion_between(from, to)});
    from = to;
  }
  return drive;
}

/// The number of motions up to the last one that is not free. The motions that were checked when the path was found
/// were others, so that the check with a margin may refuse these.
std::size_t first_free(std::span<const Pose> poses, const PlaceOnDrive& place,
                       const FreeSpace& space) {
  std::size_t begin = place.joint + 1;
  Path tail;
  tail.drive_to(place.pose);
  for (const Pose& pose : poses.subspan(begin)) tail.drive_to(pose);
  while (const auto collision = first_collision(tail, space)) {
    begin += collision->piece + 1;
    tail.clear();
    for (const Pose& pose : poses.subspan(begin - 1)) tail.drive_to(pose);
    if (begin >= poses.size()) break;
  }
  return begin - (place.joint + 1);
}

/// What is behind a length of a drive.
struct Tail {
  std::size_t first = 0;  // motion that is cut
  Pose knot;
  DrivenMotions drive;
};

Tail tail_after(const DrivenMotions& drive, double length) {
  Tail tail;
  std::size_t& i = tail.first;
  while (i < drive.size() && std::abs(drive[i].motion.length) <= length) {
    length -= std::abs(drive[i++].motion.length);
  }
  if (i == drive.size()) {
    tail.knot = pose_after(drive.back().from, drive.back().motion);
    return tail;
  }
  const auto& [from, motion] = drive[i];
  const double share = length / std::abs(motion.length);
  tail.knot = pose_after(from, part_of(motion, share));
  // The course stays: it is measured from the heading, which turns with it.
  tail.drive.push_back({tail.knot, part_of(motion, 1 - share)});
  tail.drive.insert(tail.drive.end(), drive.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                    drive.end());
  return tail;
}

/// The cheapest connection to the tail, and the tail behind it.
std::optional<DrivenMotions> connected(const Pose& robot, Tail tail, const MotionCheck& check,
                                       const Steering& steering) {
  std::array<Connection, 1> best;
  constexpr double kAnyCost = std::numeric_limits<double>::infinity();
  if (steering.connect(robot, tail.knot, 0, kAnyCost, best) == 0) return std::nullopt;
  DrivenMotions drive;
  Pose pose = robot;
  for (const Motion& motion : best[0].all()) {
    if (!check.fits(pose, motion)) return std::nullopt;
    drive.push_back({pose, motion});
    pose = pose_after(pose, motion);
  }
  drive.insert(drive.end(), tail.drive.begin(), tail.drive.end());
  return drive;
}

/// The cheapest drive back to the path and along it.
std::optional<DrivenMotions> cheapest_connected(const DrivenMotions& drive, std::size_t free_from,
                                                const PlaceOnDrive& place, const Pose& robot,
                                                const MotionCheck& check,
                                                const Steering& steering) {
  std::optional<DrivenMotions> best;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](Tail tail) {
    if (tail.first < free_from) return;
    auto joined = connected(robot, std::move(tail), check, steering);
    if (!joined) return;
    const double cost = cost_of(*joined, check, steering);
    if (cost >= least * (1 - kRoundingOfRest)) return;
    least = cost;
    best = std::move(joined);
  };
  if (drive.empty()) {
    offer({0, place.pose, {}});
    return best;
  }
  double whole = 0;
  for (const DrivenMotion& driven : drive) whole += std::abs(driven.motion.length);
  // A car comes back to its path in a few turning radii.
  const double step = std::max(1.0, steering.radius() / 2);
  double ahead = step;
  while (ahead < whole) {
    offer(tail_after(drive, ahead));
    ahead *= 2;
  }
  offer(tail_after(drive, whole));
  return best;
}

Path path_of(const Pose& start, const DrivenMotions& drive, const Pose& end) {
  Path path;
  path.drive_to(start);
  for (std::size_t i = 0; i < drive.size(); ++i) {
    const auto& [from, motion] = drive[i];
    const auto parts = std::max(
        1, static_cast<int>(std::ceil(std::abs(motion.turn) / (kPi / 2) - kRoundingOfRest)));
    for (int part = 1; part < parts; ++part) {
      path.drive_to(pose_after(from, part_of(motion, static_cast<double>(part) / parts)));
    }
    path.drive_to(i + 1 < drive.size() ? drive[i + 1].from : end);
  }
  return path;
}

}  // namespace

std::optional<RestOfDrive> rest_of_drive(std::span<const Pose> poses, const PlaceOnDrive& place,
                                         const Pose& robot, const MotionCheck& check,
                                         const Steering& steering) {
  DrivenMotions ahead = drive_from(poses, place);
  const std::size_t free_from = first_free(poses, place, check.free_space());
  const bool on_path = place.distance < kRoundingOfRest && place.turn < kRoundingOfRest;
  if (on_path && free_from > 0) return std::nullopt;
  auto drive = on_path ? std::optional(std::move(ahead))
                       : cheapest_connected(ahead, free_from, place, robot, check, steering);
  if (!drive) return std::nullopt;
  RestOfDrive rest{path_of(robot, *drive, poses.back())};
  join(*drive);
  rest.cost = cost_of(*drive, check, steering);
  return rest;
}

}  // namespace wend
