#include "wend/map/place_text.hpp"

#include <cmath>

#include "wend/base/number_text.hpp"
#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/compass.hpp"

namespace wend {
namespace {

std::string pair_text(MapPoint point) {
  return general_text(point.x, 6) + ',' + general_text(point.y, 6);
}

std::string range_text(double from, double to) {
  return general_text(from, 6) + " to " + general_text(to, 6);
}

/// With so many digits after the point as a scale of 10, 100, 1000 .. says.
std::string rounded_text(double value, double scale) {
  const double rounded = std::round(value * scale) / scale + 0.0;  // no -0
  constexpr double kMostWhole = 1e15;                              // not 1e+06
  if (std::abs(rounded) < kMostWhole && rounded == std::trunc(rounded)) {
    return std::to_string(static_cast<long long>(rounded));
  }
  return format_number(std::isfinite(rounded) ? rounded : value);
}

}  // namespace

std::string cell_text(Cell cell) {
  return '(' + std::to_string(cell.x) + ',' + std::to_string(cell.y) + ')';
}

std::string metres_text(MapPoint point) {
  return '(' + rounded_text(point.x, 1e4) + ',' + rounded_text(point.y, 1e4) + ") m";
}

std::string heading_text(double radians, const Frame& frame) {
  if (const auto heading = exact_heading(radians)) return std::string(letter_of(*heading, frame));
  const double in_map = frame.to_metres(Pose{0, 0, radians}).heading;
  const double degrees = std::round(degrees_from(in_map) * 1e6) / 1e6 + 0.0;  // not 1e-14
  return general_text(degrees, 4) + "deg";
}

std::string pose_text(Point point, std::optional<double> heading, const Frame& frame) {
  const MapPoint at = frame.metric ? frame.to_metres(point) : MapPoint{point.x, point.y};
  return '(' + rounded_text(at.x, 1e3) + ',' + rounded_text(at.y, 1e3) + ',' +
         (heading ? heading_text(*heading, frame) : "any") + (frame.metric ? ") m" : ")");
}

std::string pose_text(const Pose& pose, const Frame& frame) {
  return pose_text(pose.point(), pose.heading, frame);
}

std::string distance_text(double cells, const Frame& frame) {
  if (frame.metric) return general_text(cells * frame.resolution, 3) + " m";
  return general_text(cells, 4) + (cells == 1 ? " cell" : " cells");
}

std::string covered_metres(const Frame& frame, int width, int height) {
  const double right = width;
  const double top = height;
  const auto corner = [&](double x, double y) { return frame.to_metres(Point{x, y}); };
  const MapPoint low = corner(0, 0);
  const MapPoint high = corner(right, top);
  if (frame.origin.heading == 0) {
    return "x from " + range_text(low.x, high.x) + " m and y from " + range_text(low.y, high.y) +
           " m";
  }
  return "the rectangle " + pair_text(low) + " to " + pair_text(corner(right, 0)) + " to " +
         pair_text(high) + " to " + pair_text(corner(0, top)) + " m";
}

}  // namespace wend
