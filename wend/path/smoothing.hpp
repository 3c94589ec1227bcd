#pragma once

// What all smoothers do before and after: refuse what cannot be smoothed, and let no safe result be
// longer than the path.

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "wend/path/smoother.hpp"

namespace wend {

inline Unexpected<SmoothingError> refused(Status status, std::string what) {
  return Unexpected<SmoothingError>({status, std::move(what)});
}

inline Unexpected<SmoothingError> refused_drive() {
  return refused(Status::unsupported_query,
                 "a car's drive is not smoothed: it is arcs that a car can drive already");
}

/// Why gradient descent with such weights would not converge; nothing if it does. `in_place`: each
/// point sees where its neighbours are already, not where they were in the sweep before.
std::optional<std::string> fault_of_weights(double alpha, double beta, bool in_place);

/// Moves the points of a path wherever they are to go: what is left of MovablePath for an unsafe
/// smoother.
class UnboundPath {
 public:
  explicit UnboundPath(std::vector<Point> points) : points_(std::move(points)) {}

  const std::vector<Point>& points() const { return points_; }
  double move(std::size_t i, Point to) {
    points_[i] = to;
    return 1;
  }

 private:
  std::vector<Point> points_;
};

/// Puts the points into the result, or the path where they are longer.
inline void finish(Smoothed& smoothed, const Path& path, std::span<const Point> points,
                   bool may_be_longer) {
  smoothed.path = Path::along({points.begin(), points.end()});
  const double longest = path.length() * (1 + 1e-12);  // summed up in another order
  if (may_be_longer || smoothed.path.length() <= longest) return;
  smoothed.path = Path::along(path.points());
  smoothed.returned = true;
}

/// Tells of a smoother by its options: those texts of them that are wrong are Status::invalid_option.
template <class Options, class Smooth>
SmootherInfo smoother_with(std::string name, std::string summary, std::string citation,
                           Smooth&& smooth) {
  return {std::move(name), std::move(summary), std::move(citation), option_schema<Options>(),
          [smooth](const Path& path, const FreeSpace& space,
                   const OptionValues& values) -> SmoothingResult {
            const auto options = parse_options<Options>(values);
            if (!options) return refused(Status::invalid_option, options.error().message());
            return smooth(path, space, *options);
          }};
}

}  // namespace wend
