#pragma once

// How a path is refined: --simplify, --smooth, --smoother, --unsafe,
// --turning-radius and --resample; and --corner-rounding, with which it is measured.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/parser.hpp"
#include "wend/path/refinement.hpp"
#include "wend/planner/planners.hpp"
#include "wend/render/scene.hpp"
#include "wend/report/path_report.hpp"

namespace wend::cli {

struct RefineArguments {
  std::optional<std::string> simplify;  // as typed; empty: as by default
  std::optional<std::string> smooth;    // the same: ALPHA,BETA
  std::string smoother;                 // its name, options may follow; empty: none
  bool unsafe = false;
  // In the user's units.
  std::optional<double> turning_radius;
  std::optional<double> resample;
  std::optional<double> max_distance;
  std::optional<double> corner_rounding;

  /// All of them, for paths that are planned.
  void add_to(Parser& app);

  /// --simplify, --resample and --corner-rounding.
  void add_points_to(Parser& app);

  bool any() const { return simplify || smooth || !smoother.empty() || unsafe || resample; }

  /// --turning-radius as an option of the planner, if it has one. Throws InputError if neither it nor
  /// the smoother has it.
  void steer(PlannerSpec& planner, const Coordinates& coordinates) const;

  /// For a planner that does not cut corners; who knows the planner sets the adjacency. Throws InputError
  /// for invalid text.
  Refinement refinement(const Coordinates& coordinates) const;

  /// What paths are measured with, in cells.
  double rounding(const Coordinates& coordinates) const;

 private:
  std::optional<SmootherChoice> smoother_choice(const Coordinates& coordinates) const;
};

/// --max-distance.
void add_max_distance(Parser& app, std::optional<double>& distance);

/// --corner-rounding, and what it is in cells.
void add_corner_rounding(Parser& app, std::optional<double>& rounding);
double corner_rounding_in_cells(const std::optional<double>& rounding,
                                const Coordinates& coordinates);

/// A smoother by name, options may follow: "curvature:turning_radius=0.4". Throws InputError if it does
/// not exist.
SmootherChoice parse_smoother(std::string_view text);

/// Simplifies, smooths and resamples a path. Throws InputError where it cannot be done.
RefinedPath refine(const Path& path, const FreeSpace& space, const Refinement& refinement,
                   double corner_rounding);

/// The same with a way out before both paths.
RefinedPath with_lead(const Path& lead, RefinedPath path, const FreeSpace& space,
                      double corner_rounding);

/// What is drawn: the path before and after.
std::vector<SceneLine> lines_of(const RefinedPath& path);

/// The metrics of the path before and after, and the result of smoothing, as lines of text.
std::string refined_text(const RefinedPath& path, const Coordinates& coordinates);

}  // namespace wend::cli
