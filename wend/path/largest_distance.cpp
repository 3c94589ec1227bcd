#include "wend/path/largest_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "wend/geometry/line.hpp"
#include "wend/path/polyline.hpp"

namespace wend {
namespace {

constexpr double kLookSpacing = 0.5;  // cells
constexpr double kMostLooks = 1e5;

/// Points along a polyline, its own among them.
std::vector<Point> looks_along(const Polyline& line) {
  const double spacing = std::max(kLookSpacing, line.length() / kMostLooks);
  std::vector<Point> looks{line.points().front()};
  for (std::size_t i = 1; i < line.points().size(); ++i) {
    const Line piece{line.points()[i - 1], line.points()[i]};
    const int count = std::max(1, static_cast<int>(std::ceil(piece.length() / spacing)));
    for (int k = 1; k <= count; ++k) looks.push_back(piece.at(static_cast<double>(k) / count));
  }
  return looks;
}

/// A step that visits all of `count` places, each far from the one before.
std::size_t stride_over(std::size_t count) {
  constexpr double kGolden = 0.618;
  auto stride =
      std::max<std::size_t>(1, static_cast<std::size_t>(kGolden * static_cast<double>(count)));
  while (std::gcd(stride, count) != 1) ++stride;
  return stride;
}

/// The distance from a point to the nearest line, or any that is not above `enough`; once it must stop, to some point on
/// them. Begins at the line that `begin`
/// names, and goes on to both sides.
double distance_to(const std::vector<Point>& looks, Point point, std::size_t begin, double enough,
                   DeadlineCheck& stop) {
  double least = distance(looks[begin], point);
  const auto look_at = [&](std::size_t i) {
    least = std::min(least, distance(Line{looks[i], looks[i + 1]}, point));
  };
  const std::size_t lines = looks.size() - 1;
  for (std::size_t off = 0; off <= lines && least > enough && !stop(); ++off) {
    if (begin + off < lines) look_at(begin + off);
    if (off > 0 && off <= begin) look_at(begin - off);
  }
  return least;
}

/// The largest distance from a point of one to the other, or `most` if that is more.
double farther_than(double most, const std::vector<Point>& from, const std::vector<Point>& to,
                    DeadlineCheck& stop) {
  const std::size_t stride = stride_over(from.size());
  std::size_t i = 0;
  for (std::size_t looked = 0; looked < from.size(); ++looked) {
    const std::size_t begin = i * to.size() / from.size();
    most = std::max(most, distance_to(to, from[i], begin, most, stop));
    i = (i + stride) % from.size();
  }
  return most;
}

}  // namespace

double largest_distance(const Path& a, const Path& b, const Deadline& deadline) {
  DeadlineCheck stop(&deadline);
  const auto looks_a = looks_along(polyline_of(a));
  const auto looks_b = looks_along(polyline_of(b));
  return farther_than(farther_than(0, looks_a, looks_b, stop), looks_b, looks_a, stop);
}

}  // namespace wend
