#include "wend/render/picture/axis_room.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "wend/render/picture/round_step.hpp"

namespace wend {
namespace {

constexpr double kDigit = 0.65 * kAxisFontSize;  // as wide as one gets
constexpr double kApart = 24;                    // pixels between numbers
constexpr int kEdge = 10;  // where there are no numbers: for a path along the edge

/// Of the longest number, in pixels.
double longest(const FreeSpace& space) {
  const std::string number = std::to_string(std::max(space.width(), space.height()));
  return kDigit * static_cast<double>(number.size());
}

}  // namespace

AxisRoom axis_room(const Scene& scene) {
  if (!scene.unit) return {};
  const auto beside = static_cast<int>(std::ceil(kAxisTick + kAxisGap + longest(scene.space)));
  const auto along = static_cast<int>(std::ceil(kAxisTick + kAxisGap + kAxisDigitHeight));
  const bool y_up = scene.space.map().frame().y_up;
  return {
      .left = beside, .top = y_up ? kEdge : along, .right = kEdge, .bottom = y_up ? along : kEdge};
}

int axis_step(const Scene& scene, double scale) {
  const int unit = scene.unit.value_or(1);
  return unit * round_step((kApart + longest(scene.space)) / (unit * scale));
}

}  // namespace wend
