#pragma once

// What is to become of a path: --simplify, --smooth, --smoother, --unsafe and --resample.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coordinates.hpp"
#include "parser.hpp"
#include "wend/path/refinement.hpp"
#include "wend/render/scene.hpp"
#include "wend/report/path_report.hpp"

namespace wend::cli {

struct RefineArguments {
  std::optional<std::string> simplify;  // as typed; empty: as by default
  std::optional<std::string> smooth;    // the same: ALPHA,BETA
  std::string smoother;                 // its name, options may follow; empty: none is named
  bool unsafe = false;
  std::optional<double> resample;  // in the user's units

  /// All of them, for paths that are planned.
  void add_to(Parser& app);

  /// --simplify and --resample.
  void add_points_to(Parser& app);

  bool any() const { return simplify || smooth || !smoother.empty() || unsafe || resample; }

  /// Throws InputError for text that means nothing.
  Refinement refinement(const Coordinates& coordinates, Adjacency adjacency) const;

 private:
  std::optional<SmootherChoice> smoother_choice() const;
};

/// A smoother by name, options may follow: "curvature:radius=6". Throws InputError for one that there
/// is not.
SmootherChoice parse_smoother(std::string_view text);

/// Simplifies, smooths and resamples a path. Throws InputError where that cannot be done.
RefinedPath refine(const Path& path, const FreeSpace& space, const Refinement& refinement);

/// What there is to draw of it: as it was, and what became of it.
std::vector<SceneLine> lines_of(const RefinedPath& path);

/// How the path was before and is now, and what smoothing did: lines.
std::string refined_text(const RefinedPath& path, const Coordinates& coordinates);

}  // namespace wend::cli
