#include "wend/robot/car_primitives.hpp"

#include <cassert>
#include <cstddef>
#include <utility>

#include "wend/geometry/angle.hpp"
#include "wend/geometry/compass.hpp"
#include "wend/geometry/segment.hpp"

namespace wend {
namespace {

/// One unit ahead (gear 1) or back (-1), and to a side: plus (1), minus (-1), or straight (0).
MotionPrimitive car_primitive(Heading heading, int gear, int side) {
  const Heading plus = quarter_turned(heading);
  const Cell along = ahead(heading);
  const Cell across = ahead(plus);
  const Cell by{gear * along.x + side * across.x, gear * along.y + side * across.y};
  const Heading after = side == 0 ? heading : gear == side ? plus : opposite(plus);
  return {.from = static_cast<int>(heading),
          .to = static_cast<int>(after),
          .by = by,
          .poses = {pose_of(CornerPose{{0, 0}, heading}), pose_of(CornerPose{by, after})}};
}

MotionPrimitives make_car_primitives() {
  MotionPrimitives::Parts parts;
  parts.vertices = Vertices::corners;
  for (const Heading heading : kAllHeadings) {
    parts.headings.push_back(radians_of(heading));
    for (const int gear : {1, -1}) {
      for (const int side : {0, 1, -1}) {
        parts.primitives.push_back(car_primitive(heading, gear, side));
        parts.primitives.back().number = static_cast<int>(parts.primitives.size() - 1) % kCarMoves;
      }
    }
  }
  auto made = MotionPrimitives::make(std::move(parts));
  assert(made);
  return *std::move(made);
}

/// The same in the car's own frame with every heading.
Segment segment_of(CarMove move) {
  const auto& poses = primitive_of(Heading::plus_x, move).poses;
  return segment_between(poses.front(), poses.back());
}

}  // namespace

const MotionPrimitives& car_primitives() {
  static const MotionPrimitives primitives = make_car_primitives();
  return primitives;
}

const MotionPrimitive& primitive_of(Heading heading, CarMove move) {
  return car_primitives().leaving(static_cast<int>(heading))[static_cast<std::size_t>(move)];
}

bool is_turn(CarMove move) {
  const MotionPrimitive& primitive = primitive_of(Heading::plus_x, move);
  return primitive.from != primitive.to;
}

bool is_reverse(CarMove move) { return segment_of(move).length < 0; }

double length_of(CarMove move) { return is_turn(move) ? kPi / 2 : 1; }

CarMove inverse(CarMove move) {
  const MotionPrimitive& there = primitive_of(Heading::plus_x, move);
  for (const MotionPrimitive& back : car_primitives().leaving(there.to)) {
    if (back.to == there.from && back.by == Cell{-there.by.x, -there.by.y}) {
      return static_cast<CarMove>(back.number);
    }
  }
  assert(false);
  return move;
}

CornerPose moved(const CornerPose& from, CarMove move, int unit) {
  const MotionPrimitive& primitive = primitive_of(from.heading, move);
  return {{from.vertex.x + unit * primitive.by.x, from.vertex.y + unit * primitive.by.y},
          static_cast<Heading>(primitive.to)};
}

std::string_view name_of(CarMove move, const Frame& frame) {
  return name_of(segment_of(move), frame);
}

}  // namespace wend
