#include "wend/path/refinement.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/path/joins.hpp"
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

/// What refined() does with a path without joins.
Expected<Refined, Error> refined_leg(const Path& path, const FreeSpace& space,
                                     const Refinement& refinement, const Deadline& deadline) {
  const Adjacency adjacency = refinement.adjacency;
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

/// How the smoothing of legs went, one after the other. `held` is a share of the points.
Smoothed in_a_row(std::span<const Smoothed> legs) {
  Smoothed all = legs.front();
  std::vector<Path> paths{all.path};
  auto points = static_cast<double>(all.path.size());
  for (const Smoothed& leg : legs.subspan(1)) {
    const auto more = static_cast<double>(leg.path.size());
    all.held = (all.held * points + leg.held * more) / (points + more);
    points += more;
    paths.push_back(leg.path);
    all.sweeps += leg.sweeps;
    all.converged &= leg.converged;
    all.returned &= leg.returned;
    all.stopped |= leg.stopped;
    all.distance = std::max(all.distance, leg.distance);
    all.within_bound &= leg.within_bound;
  }
  all.path = end_to_end(paths);
  return all;
}

Expected<Refined, Error> refined_legs(const Path& path, const FreeSpace& space,
                                      const Refinement& refinement, const Deadline& deadline) {
  Refined whole;
  std::vector<Path> paths;
  std::vector<Smoothed> smoothed;
  std::size_t last = 0;
  for (const Path& leg : legs_between(path, refinement.joins)) {
    auto refined = refined_leg(leg, space, refinement, deadline);
    if (!refined) return refined;
    if (!paths.empty()) whole.joins.push_back(last);
    last += refined->path.size() - 1;
    paths.push_back(std::move(refined->path));
    if (refined->smoothing) smoothed.push_back(*std::move(refined->smoothing));
  }
  whole.path = end_to_end(paths);
  if (!smoothed.empty()) whole.smoothing = in_a_row(smoothed);
  return whole;
}

}  // namespace

SmootherChoice smoother_for(const Path& path, const SmootherChoice& choice) {
  const bool gradient = choice.name == SmootherChoice{}.name;
  return path.driven() && gradient ? SmootherChoice{"drive", choice.options} : choice;
}

Expected<Refined, Error> refined(const Path& path, const FreeSpace& space,
                                 const Refinement& refinement, const Deadline& deadline) {
  if (auto fault = fault_of(path, space)) return Unexpected<Error>(*std::move(fault));
  if (refinement.max_distance) {
    if (auto fault = fault_of_length("max_distance", *refinement.max_distance)) {
      return Unexpected<Error>(*std::move(fault));
    }
  }
  if (auto fault = fault_of_joins(refinement.joins, path.size())) {
    return Unexpected<Error>(*std::move(fault));
  }
  return refinement.joins.empty() ? refined_leg(path, space, refinement, deadline)
                                  : refined_legs(path, space, refinement, deadline);
}

}  // namespace wend
