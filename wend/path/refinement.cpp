#include "wend/path/refinement.hpp"

#include "wend/path/simplification.hpp"
#include "wend/path/smoothing.hpp"

namespace wend {
namespace {

Path simplified_by(const Simplification& simplify, const Path& path, const FreeSpace& space,
                   Adjacency adjacency) {
  switch (simplify.by) {
    case SimplifyBy::collinear:
      return without_collinear(path);
    case SimplifyBy::tolerance:
      return simplified(path, simplify.tolerance, space, adjacency);
    case SimplifyBy::sight:
      return string_pulled(path, space, adjacency);
  }
  return path;
}

SmoothingResult smoothed_by(const SmootherChoice& choice, const Path& path, const FreeSpace& space,
                            Adjacency adjacency) {
  OptionValues options = choice.options;
  if (!path.driven() && adjacency == Adjacency::edges_and_corners) {
    options.insert(options.begin(), {"squeeze", "true"});
  }
  const auto smoother = make_smoother(choice.name, options);
  if (!smoother) return Unexpected<Error>(smoother.error());
  return (*smoother)(path, space);
}

}  // namespace

SmootherChoice smoother_for(const Path& path, const SmootherChoice& choice) {
  const bool gradient = choice.name == SmootherChoice{}.name;
  return path.driven() && gradient ? SmootherChoice{"drive", choice.options} : choice;
}

Expected<Refined, Error> refined(const Path& path, const FreeSpace& space,
                                 const Refinement& refinement) {
  const Adjacency adjacency = refinement.adjacency;
  Refined refined{path};
  if (refinement.simplify) {
    if (path.driven()) {
      return failure(Status::unsupported_query,
                     "a path of poses cannot be simplified: its arcs need their end points");
    }
    refined.path = simplified_by(*refinement.simplify, path, space, adjacency);
  }
  if (refinement.smoother) {
    // Long lines of cells have too few points to bend.
    if (!refined.path.cells().empty() && !refined.path.of_steps()) {
      refined.path = resampled(refined.path, 1, space, adjacency);
    }
    auto smoothed =
        smoothed_by(smoother_for(path, *refinement.smoother), refined.path, space, adjacency);
    if (!smoothed) return Unexpected<Error>(std::move(smoothed).error());
    refined.path = smoothed->path;
    refined.smoothing = *std::move(smoothed);
  }
  if (refinement.spacing) {
    const double points = refined.path.length() / *refinement.spacing;
    if (points > static_cast<double>(kMostResampled)) {
      return failure(Status::invalid_option,
                     "resampling would make " + std::to_string(static_cast<std::uint64_t>(points)) +
                         " points, and " + std::to_string(kMostResampled) +
                         " is the limit: choose a larger spacing");
    }
    refined.path = resampled(refined.path, *refinement.spacing, space, adjacency);
  }
  return refined;
}

}  // namespace wend
