#pragma once

// Refinement: simplify, then smooth, then resample a path, as far as each is asked for.
//
//   const auto refined = wend::refined(plan->path, space,
//                                      {.simplify = wend::Simplification{wend::SimplifyBy::sight},
//                                       .smoother = wend::SmootherChoice{"gradient"}});

#include <array>
#include <optional>
#include <string>

#include "wend/base/compiler.hpp"
#include "wend/base/deadline.hpp"
#include "wend/base/options.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/path/smoothing/simplification.hpp"
#include "wend/path/smoothing/smoother.hpp"

namespace wend {

/// How a path is simplified.
enum class SimplifyBy {
  collinear,  // without_collinear()
  tolerance,  // simplified()
  sight,      // string_pulled()
};

constexpr std::array<Choice<SimplifyBy>, 3> choice_names(SimplifyBy) {
  return {{{"collinear", SimplifyBy::collinear},
           {"tolerance", SimplifyBy::tolerance},
           {"sight", SimplifyBy::sight}}};
}

/// The settings of simplification.
struct Simplification {
  SimplifyBy by = SimplifyBy::sight;  // the method
  double tolerance = 0.5;             // cells; of SimplifyBy::tolerance
};

/// A smoother by name.
struct SmootherChoice {
  std::string name = "gradient";  // as in smoothers()
  OptionValues options{};         // as text; the smoother checks them
};

/// The smoother that is used for a path: for a path of poses `drive` in place of `gradient`, the default.
WEND_API SmootherChoice smoother_for(const Path& path, const SmootherChoice& choice);

struct Refinement {
  std::optional<Simplification> simplify{};  // nothing: not simplified
  std::optional<SmootherChoice> smoother{};  // nothing: not smoothed
  std::optional<double> spacing{};           // cells, > 0: resample
  Adjacency adjacency = Adjacency::edges;    // what a point may squeeze through
  /// How far from the path (simplified, if that is asked for) smoothing may lead, in cells; unset: as the smoother says.
  std::optional<double> max_distance{};
};

/// What refined() made.
struct Refined {
  Path path;                            // the refined path
  std::optional<Smoothed> smoothing{};  // how that went; its path is as it was before resampling
};

/// Lines are smoothed as points about a cell apart, however far apart or near to each other they are given.
/// Errors are those of simplification, of the smoother and of resampling; unsupported_query for a drive that is to be
/// simplified, and for a path with a fault (path_fault.hpp), even if nothing is done with it. time_limit or cancelled
/// if the deadline passes before; but smoothing only ends early then (Smoothed::stopped).
WEND_API Expected<Refined, Error> refined(const Path& path, const FreeSpace& space,
                                          const Refinement& refinement,
                                          const Deadline& deadline = {});

}  // namespace wend
