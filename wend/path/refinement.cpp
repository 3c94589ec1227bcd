#include "wend/path/refinement.hpp"

#include <algorithm>

#include "wend/base/parse.hpp"
#include "wend/path/largest_distance.hpp"
#include "wend/path/length_fault.hpp"
#include "wend/path/path_fault.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/path/smoothing/smoothing.hpp"

namespace wend {
namespace {

Expected<Path, Error> simplified_by(const Simplification& simplify, const Path& path,
                                    const FreeSpace& space, Adjacency adjacency,
                                    const Deadline& deadline) {
  switch (simplify.by) {
    case SimplifyBy::collinear:
      return without_collinear(path);
    case SimplifyBy::tolerance:
      return simplified(path, simplify.tolerance, space, adjacency, deadline);
    case SimplifyBy::sight:
      return string_pulled(path, space, adjacency, deadline);
  }
  return path;
}

SmoothingResult smoothed_by(const SmootherChoice& choice, const Path& path, const FreeSpace& space,
                            Adjacency adjacency, const Deadline& deadline) {
  OptionValues options = choice.options;
  if (!path.driven() && adjacency == Adjacency::edges_and_corners) {
    options.insert(options.begin(), {"squeeze", "true"});
  }
  const auto smoother = make_smoother(choice.name, options);
  if (!smoother) return Unexpected<Error>(smoother.error());
  if (!deadline.bounded()) return (*smoother)(path, space);
  return (*smoother)(path, space, [&deadline] { return deadline.passed(); });
}

/// Why the next stage must not begin.
std::optional<Error> stopped_before(const char* stage, const Deadline& deadline) {
  if (!deadline.passed()) return std::nullopt;
  return Error{deadline.status(), deadline.text() + ", before the path was " + stage};
}

/// Points that may not move at all still need a distance: 0 means any.
void bind(SmootherChoice& choice, double most_distance) {
  constexpr double kLeast = 1e-9;
  constexpr double kMost = 1e6;  // that a smoother takes
  choice.options.emplace_back("max_distance",
                              format_number(std::clamp(most_distance, kLeast, kMost)));
}

/// Smooths points of even distances: what smoothing does to a path depends on how far apart they are, not on how it was
/// given.
SmoothingResult smoothed_evenly(SmootherChoice choice, const Path& path, const FreeSpace& space,
                                Adjacency adjacency, std::optional<double> max_distance,
                                const Deadline& deadline) {
  Path even = path;
  double cut = 0;
  if (!path.driven() && !path.of_steps()) {
    auto resampling = resampled(path, 1, space, adjacency, deadline);
    if (!resampling) return Unexpected<Error>(std::move(resampling).error());
    even = *std::move(resampling);
    cut = largest_distance(path, even, deadline);
  }
  if (max_distance) bind(choice, *max_distance - cut);
  auto smoothed = smoothed_by(choice, even, space, adjacency, deadline);
  if (smoothed) smoothed->distance = largest_distance(path, smoothed->path, deadline);
  return smoothed;
}

}  // namespace

SmootherChoice smoother_for(const Path& path, const SmootherChoice& choice) {
  const bool gradient = choice.name == SmootherChoice{}.name;
  return path.driven() && gradient ? SmootherChoice{"drive", choice.options} : choice;
}

Expected<Refined, Error> refined(const Path& path, const FreeSpace& space,
                                 const Refinement& refinement, const Deadline& deadline) {
  const Adjacency adjacency = refinement.adjacency;
  if (auto fault = fault_of(path, space)) return Unexpected<Error>(*std::move(fault));
  if (refinement.max_distance) {
    if (auto fault = fault_of_length("max_distance", *refinement.max_distance)) {
      return Unexpected<Error>(*std::move(fault));
    }
  }
  Refined refined{path};
  if (refinement.simplify) {
    if (auto stopped = stopped_before("simplified", deadline)) return Unexpected<Error>(*stopped);
    auto simplified = simplified_by(*refinement.simplify, path, space, adjacency, deadline);
    if (!simplified) return Unexpected<Error>(std::move(simplified).error());
    refined.path = *std::move(simplified);
  }
  if (refinement.smoother) {
    if (auto stopped = stopped_before("smoothed", deadline)) return Unexpected<Error>(*stopped);
    const SmootherChoice choice = smoother_for(path, *refinement.smoother);
    auto smoothed =
        smoothed_evenly(choice, refined.path, space, adjacency, refinement.max_distance, deadline);
    if (!smoothed) return Unexpected<Error>(std::move(smoothed).error());
    refined.path = smoothed->path;
    refined.smoothing = *std::move(smoothed);
  }
  if (refinement.spacing) {
    auto even = resampled(refined.path, *refinement.spacing, space, adjacency, deadline);
    if (!even) return Unexpected<Error>(std::move(even).error());
    refined.path = *std::move(even);
  }
  return refined;
}

}  // namespace wend
