#include "wend/robot/motion_primitives.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

constexpr double kJoined = 0.02;       // cells
constexpr double kJoinedTurn = 0.01;   // radians
constexpr double kNearVertex = 0.25;   // cells
constexpr double kNearHeading = 0.2;   // radians
constexpr double kSameHeading = 1e-6;  // radians

double turn_between(const Pose& from, const Pose& to) {
  return normalized_angle(to.heading - from.heading);
}

/// How far the poses come up to each, in cells and radians: equal parts of a segment are as long.
std::vector<double> progress_of(std::span<const Pose> poses) {
  std::vector<double> progress{0};
  for (std::size_t i = 1; i < poses.size(); ++i) {
    progress.push_back(progress.back() + distance(poses[i - 1].point(), poses[i].point()) +
                       std::abs(turn_between(poses[i - 1], poses[i])));
  }
  return progress;
}

/// Does one segment from pose i to pose j pass the poses between them?
bool is_one_segment(std::span<const Pose> poses, std::span<const double> progress, std::size_t i,
                    std::size_t j) {
  double turned = 0;
  for (std::size_t k = i; k < j; ++k) turned += turn_between(poses[k], poses[k + 1]);
  const Segment segment = segment_between(poses[i], poses[j]);
  if (std::abs(turned - segment.turn) > kJoinedTurn) return false;  // it would turn the other way
  const double whole = progress[j] - progress[i];
  for (std::size_t k = i + 1; k < j; ++k) {
    const Pose there = pose_on(segment, whole == 0 ? 0 : (progress[k] - progress[i]) / whole);
    if (distance(there.point(), poses[k].point()) > kJoined) return false;
    if (std::abs(turn_between(there, poses[k])) > kJoinedTurn) return false;
  }
  return true;
}

/// Moves the first and the last pose to where they should be, and those between them in proportion.
void spread_errors(std::vector<Pose>& poses, const Pose& first, const Pose& last) {
  const std::vector<double> progress = progress_of(poses);
  const Pose begin = poses.front();
  const Pose end = poses.back();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double share = progress.back() > 0 ? progress[i] / progress.back() : 0;
    const auto mended = [&](double value, double at_begin, double at_end) {
      return value + (1 - share) * at_begin + share * at_end;
    };
    Pose& pose = poses[i];
    pose.x = mended(pose.x, first.x - begin.x, last.x - end.x);
    pose.y = mended(pose.y, first.y - begin.y, last.y - end.y);
    pose.heading = mended(pose.heading, turn_between(begin, first), turn_between(end, last));
  }
  poses.front() = first;
  poses.back() = last;
}

/// The poses without those that repeat the one before.
void drop_repeated(std::vector<Pose>& poses) {
  constexpr double kRounding = 1e-9;
  const auto repeats = [](const Pose& a, const Pose& b) {
    return distance(a.point(), b.point()) + std::abs(turn_between(a, b)) < kRounding;
  };
  const Pose last = poses.back();
  poses.erase(std::unique(poses.begin(), poses.end(), repeats), poses.end());
  poses.back() = last;
}

/// The ends of the longest segments, from the first pose on.
std::vector<Pose> joined(std::span<const Pose> poses) {
  const std::vector<double> progress = progress_of(poses);
  std::vector<Pose> joints{poses.front()};
  std::size_t i = 0;
  while (i + 1 < poses.size()) {
    std::size_t j = i + 1;
    while (j + 1 < poses.size() && is_one_segment(poses, progress, i, j + 1)) ++j;
    joints.push_back(poses[j]);
    i = j;
  }
  return joints;
}

std::string wrong_headings(std::span<const double> headings) {
  if (headings.empty()) return "a set of motion primitives needs at least one heading";
  if (headings.size() > MotionPrimitives::kMostHeadings) {
    return std::to_string(headings.size()) + " headings, the most are " +
           std::to_string(MotionPrimitives::kMostHeadings);
  }
  for (std::size_t i = 0; i < headings.size(); ++i) {
    if (!std::isfinite(headings[i])) return "heading " + std::to_string(i) + " is not finite";
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(normalized_angle(headings[i] - headings[j])) > kSameHeading) continue;
      return "the headings " + std::to_string(j) + " and " + std::to_string(i) + " are equal";
    }
  }
  return {};
}

bool in_reach(double value) { return std::abs(value) <= MotionPrimitives::kFarthest; }

bool is_heading(int heading, std::size_t headings) {
  return heading >= 0 && static_cast<std::size_t>(heading) < headings;
}

std::string wrong_end(const Pose& is, const Pose& should_be, const std::string& name) {
  if (distance(is.point(), should_be.point()) > kNearVertex) {
    return "its " + name + " pose (" + format_number(is.x) + "," + format_number(is.y) +
           ") is not at its vertex (" + format_number(should_be.x) + "," +
           format_number(should_be.y) + "), in cells";
  }
  if (std::abs(turn_between(is, should_be)) > kNearHeading) {
    return "its " + name + " pose has the heading " + format_number(is.heading) +
           " radians instead of " + format_number(should_be.heading);
  }
  return {};
}

/// What is wrong with the numbers of a primitive that is to be used on these headings.
std::string wrong_numbers(const MotionPrimitive& primitive, std::size_t headings) {
  if (!is_heading(primitive.from, headings) || !is_heading(primitive.to, headings)) {
    return "its headings " + std::to_string(primitive.from) + " and " +
           std::to_string(primitive.to) + " must be from 0 to " + std::to_string(headings - 1);
  }
  if (!(primitive.cost_factor > 0 && primitive.cost_factor <= 1e6)) {
    return "its cost factor " + format_number(primitive.cost_factor) +
           " is not above 0 and at most 1e6";
  }
  if (primitive.poses.size() < 2 || primitive.poses.size() > MotionPrimitives::kMostPoses) {
    return std::to_string(primitive.poses.size()) + " poses, there must be 2 to " +
           std::to_string(MotionPrimitives::kMostPoses);
  }
  for (const Pose& pose : primitive.poses) {
    if (in_reach(pose.x) && in_reach(pose.y) && std::isfinite(pose.heading)) continue;
    return "a pose is not finite, or more than " + std::to_string(MotionPrimitives::kFarthest) +
           " cells away";
  }
  if (!in_reach(primitive.by.x) || !in_reach(primitive.by.y)) return "its vertex is too far away";
  return {};
}

/// Puts the ends onto their vertices, and joins segments. Returns what is wrong.
std::string tidy(MotionPrimitive& primitive, std::span<const double> headings) {
  std::string wrong = wrong_numbers(primitive, headings.size());
  if (!wrong.empty()) return wrong;
  const auto heading = [&](int index) { return headings[static_cast<std::size_t>(index)]; };
  const Pose first{0, 0, heading(primitive.from)};
  const Pose last{static_cast<double>(primitive.by.x), static_cast<double>(primitive.by.y),
                  heading(primitive.to)};
  wrong = wrong_end(primitive.poses.front(), first, "first");
  if (wrong.empty()) wrong = wrong_end(primitive.poses.back(), last, "last");
  if (!wrong.empty()) return wrong;
  spread_errors(primitive.poses, first, last);
  if (progress_of(primitive.poses).back() < kNearVertex && first.point() == last.point() &&
      primitive.from == primitive.to) {
    return "it does not move";
  }
  drop_repeated(primitive.poses);
  primitive.poses = joined(primitive.poses);
  return {};
}

Unexpected<Error> invalid(std::string message, std::string where = {}) {
  return failure(Status::invalid_option, std::move(message), std::move(where));
}

// The built-in sets.

constexpr std::array<Cell, 16> kSixteenWays{{{1, 0},
                                             {2, 1},
                                             {1, 1},
                                             {1, 2},
                                             {0, 1},
                                             {-1, 2},
                                             {-1, 1},
                                             {-2, 1},
                                             {-1, 0},
                                             {-2, -1},
                                             {-1, -1},
                                             {-1, -2},
                                             {0, -1},
                                             {1, -2},
                                             {1, -1},
                                             {2, -1}}};

double angle_of(Cell way) { return arc_tangent(way.y, way.x); }
double length_of(Cell way) { return std::sqrt(way.x * way.x + way.y * way.y); }

Pose moved_along(const Pose& pose, Cell way, double length) {
  const double scale = length / length_of(way);
  return {pose.x + way.x * scale, pose.y + way.y * scale, pose.heading};
}

/// From heading a to heading b, its neighbour: straight, an arc that touches both directions, straight.
MotionPrimitive turn_on_arc(int a, int b, double radius) {
  const Cell ahead = kSixteenWays[static_cast<std::size_t>(a)];
  const Cell after = kSixteenWays[static_cast<std::size_t>(b)];
  const double turn = normalized_angle(angle_of(after) - angle_of(ahead));
  const double least_tangent = radius * tangent(std::abs(turn) / 2);
  const auto steps_for = [&](Cell way) {
    return std::max(1, static_cast<int>(std::ceil(least_tangent / length_of(way) - 1e-9)));
  };
  const int m = steps_for(ahead);
  const int n = steps_for(after);
  const double tangent = std::min(m * length_of(ahead), n * length_of(after));
  const Pose start{0, 0, angle_of(ahead)};
  const Pose corner{static_cast<double>(m * ahead.x), static_cast<double>(m * ahead.y),
                    angle_of(after)};
  const Pose begin = moved_along(start, ahead, m * length_of(ahead) - tangent);
  const Pose end = moved_along(corner, after, tangent);
  const Cell by{m * ahead.x + n * after.x, m * ahead.y + n * after.y};
  const Pose last{static_cast<double>(by.x), static_cast<double>(by.y), angle_of(after)};
  return {0, a, b, by, 1, {start, begin, end, last}};
}

MotionPrimitive turn_in_place(int a, int b) {
  const auto pose = [](int heading) {
    return Pose{0, 0, angle_of(kSixteenWays[static_cast<std::size_t>(heading)])};
  };
  return {0, a, b, {0, 0}, 1, {pose(a), pose(b)}};
}

MotionPrimitive straight(int heading) {
  const Cell way = kSixteenWays[static_cast<std::size_t>(heading)];
  const double angle = angle_of(way);
  const Pose end{static_cast<double>(way.x), static_cast<double>(way.y), angle};
  return {0, heading, heading, way, 1, {{0, 0, angle}, end}};
}

/// The same way back.
MotionPrimitive reversed(MotionPrimitive primitive) {
  std::swap(primitive.from, primitive.to);
  std::ranges::reverse(primitive.poses);
  for (Pose& pose : primitive.poses) {
    pose.x -= primitive.by.x;
    pose.y -= primitive.by.y;
  }
  primitive.by = {-primitive.by.x, -primitive.by.y};
  return primitive;
}

}  // namespace

Expected<MotionPrimitives, Error> MotionPrimitives::make(Parts parts) {
  if (parts.resolution && !(*parts.resolution >= 1e-6 && *parts.resolution <= 1e6)) {
    return invalid("the resolution " + format_number(*parts.resolution) +
                   " is not between 1e-6 and 1e6 metres per cell");
  }
  if (std::string wrong = wrong_headings(parts.headings); !wrong.empty()) {
    return invalid(std::move(wrong));
  }
  if (parts.primitives.empty()) return invalid("the set has no motion primitive");
  if (parts.primitives.size() > kMostPrimitives) {
    return invalid(std::to_string(parts.primitives.size()) + " motion primitives, the most are " +
                   std::to_string(kMostPrimitives));
  }
  for (std::size_t i = 0; i < parts.primitives.size(); ++i) {
    std::string wrong = tidy(parts.primitives[i], parts.headings);
    if (!wrong.empty()) return invalid(std::move(wrong), "primitive " + std::to_string(i));
  }
  return in_order(std::move(parts));
}

MotionPrimitives MotionPrimitives::in_order(Parts parts) {
  std::vector<MotionPrimitive> ordered;
  ordered.reserve(parts.primitives.size());
  std::vector<std::size_t> first{0};
  for (int heading = 0; heading < static_cast<int>(parts.headings.size()); ++heading) {
    for (MotionPrimitive& primitive : parts.primitives) {
      if (primitive.from == heading) ordered.push_back(std::move(primitive));
    }
    first.push_back(ordered.size());
  }
  parts.primitives = std::move(ordered);
  return MotionPrimitives(std::make_shared<const Data>(Data{std::move(parts), std::move(first)}));
}

Expected<MotionPrimitives, Error> MotionPrimitives::turning_circle(double radius) {
  if (!(radius >= 0 && radius <= kFarthest)) {
    return invalid("the turning radius " + format_number(radius) + " is not between 0 and " +
                   std::to_string(kFarthest) + " cells");
  }
  Parts parts;
  const int count = static_cast<int>(kSixteenWays.size());
  for (int a = 0; a < count; ++a) {
    parts.headings.push_back(angle_of(kSixteenWays[static_cast<std::size_t>(a)]));
    parts.primitives.push_back(straight(a));
    parts.primitives.push_back(reversed(straight(a)));
    for (const int b : {(a + 1) % count, (a + count - 1) % count}) {
      if (radius == 0) {
        parts.primitives.push_back(turn_in_place(a, b));
      } else {
        parts.primitives.push_back(turn_on_arc(a, b, radius));
        parts.primitives.push_back(reversed(turn_on_arc(b, a, radius)));
      }
    }
  }
  for (std::size_t i = 0; i < parts.primitives.size(); ++i) {
    MotionPrimitive& primitive = parts.primitives[i];
    primitive.number = static_cast<int>(i);
    drop_repeated(primitive.poses);
    const std::string wrong = wrong_numbers(primitive, parts.headings.size());
    if (!wrong.empty()) {
      return invalid("with a turning radius of " + format_number(radius) + " cells, " + wrong);
    }
  }
  return in_order(std::move(parts));
}

MotionPrimitives MotionPrimitives::with_ways_back() const {
  Parts parts = data_->parts;
  for (const MotionPrimitive& primitive : data_->parts.primitives) {
    MotionPrimitive back = reversed(primitive);
    const bool is_there = std::ranges::any_of(leaving(back.from), [&](const auto& other) {
      return other.to == back.to && other.by == back.by;
    });
    if (!is_there) parts.primitives.push_back(std::move(back));
  }
  return in_order(std::move(parts));
}

std::span<const MotionPrimitive> MotionPrimitives::leaving(int heading) const {
  const auto index = static_cast<std::size_t>(heading);
  return all().subspan(data_->first[index], data_->first[index + 1] - data_->first[index]);
}

int MotionPrimitives::nearest_heading(double radians) const {
  const auto gap = [&](double heading) { return std::abs(normalized_angle(heading - radians)); };
  const auto nearest = std::ranges::min_element(headings(), {}, gap);
  return static_cast<int>(nearest - headings().begin());
}

}  // namespace wend
