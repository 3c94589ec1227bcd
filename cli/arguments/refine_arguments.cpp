#include "cli/arguments/refine_arguments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/exit_code.hpp"
#include "wend/base/options.hpp"
#include "wend/base/parse.hpp"
#include "wend/io/text.hpp"
#include "wend/path/polyline.hpp"

namespace wend::cli {
namespace {

constexpr NumberRange kSpacings{1e-6, 1e9, kMapUnit};
constexpr NumberRange kRadii{1e-6, 1e6, kMapUnit};
constexpr NumberRange kRoundings{0, 1e6, kMapUnit};
constexpr std::string_view kTurningRadius = "turning_radius";

Argument add_optional_text(Parser& app, const std::string& flag, std::optional<std::string>& value,
                           const std::string& help) {
  const auto assign = [&value](const std::string& text) { value = text; };
  return app.add_option(flag, assign, wrapped(help)).optional_value();
}

Simplification simplification_of(const std::string& typed, const Coordinates& coordinates) {
  if (typed.empty()) return {};
  for (const auto& choice : choice_names(SimplifyBy{})) {
    if (choice.name == typed && choice.value != SimplifyBy::tolerance) return {choice.value};
  }
  const auto tolerance = parse_number(typed);
  if (tolerance && std::isfinite(*tolerance) && *tolerance >= 0) {
    return {SimplifyBy::tolerance, coordinates.in_cells(*tolerance)};
  }
  throw InputError(fmt::format(
      "--simplify: {} is not collinear, sight, or a tolerance of at least 0", quote(typed)));
}

/// alpha and beta as smoothers' options.
OptionValues weights_of(const std::string& typed) {
  if (typed.empty()) return {};
  const std::size_t comma = typed.find(',');
  const std::string alpha = typed.substr(0, comma);
  const std::string beta = comma == std::string::npos ? "" : typed.substr(comma + 1);
  if (!parse_number(alpha) || !parse_number(beta)) {
    throw InputError(fmt::format("--smooth: {} is not ALPHA,BETA, two numbers, for example 0.1,0.3",
                                 quote(typed)));
  }
  return {{"alpha", alpha}, {"beta", beta}};
}

}  // namespace

void RefineArguments::add_to(Parser& app) {
  add_points_to(app);
  add_optional_text(
      app, "--smooth", smooth,
      "Smooth the path, clear of obstacles. ALPHA holds each point at its original "
      "position, BETA pulls neighbouring points together (default 0.1,0.3). Of a path of "
      "poses: its arcs become wider, ALPHA weighs changes of curvature, BETA curvature")
      .type_name("[ALPHA,BETA]");
  app.add_option(
         "--smoother", smoother,
         wrapped("Smoother (default gradient; of a path of poses drive); options may follow, as in "
                 "curvature:turning_radius=0.4. `wend smooth --help` lists them"))
      .type_name(kSmootherType);
  add_number(
      app, "--turning-radius", turning_radius, kRadii,
      "Lower limit on the turning radius (units as --robot-radius), for --planner "
      "hybrid_astar, --planner lattice, --planner car, where it is rounded up to whole cells, or "
      "--smoother curvature");
  add_max_distance(app, max_distance);
  app.add_flag("--unsafe", unsafe, wrapped("Smooth without a collision check"));
  app.further({"--simplify", "--resample", "--smoother", "--max-distance", "--unsafe"});
}

void add_max_distance(Parser& app, std::optional<double>& distance) {
  add_number(app, "--max-distance", distance, kRoundings,
             "How far smoothing may lead from the given path (units as --robot-radius; default any "
             "distance; --smoother curvature: twice the turning radius)");
}

void RefineArguments::add_points_to(Parser& app) {
  add_optional_text(
      app, "--simplify", simplify,
      "Remove points before the path is smoothed: collinear points, all points that are not needed "
      "for line of sight (sight, the default), or points within a tolerance, a length")
      .type_name("[collinear|sight|TOLERANCE]");
  add_number(app, "--resample", resample, kSpacings,
             "After smoothing, place points at equal distances of about this length along the path "
             "(metres on maps with a resolution, cells on others and with --cells)");
  add_corner_rounding(app, corner_rounding);
}

void RefineArguments::steer(PlannerSpec& planner, const Coordinates& coordinates) const {
  if (!turning_radius) return;
  if (has_option(info_of(planner).options, kTurningRadius)) {
    planner.options.emplace_back(kTurningRadius,
                                 format_number(coordinates.in_metres(*turning_radius)));
    return;
  }
  const auto choice = smoother_choice(coordinates);
  if (choice && has_option(smoothers().find(choice->name)->options, kTurningRadius)) return;
  throw InputError(
      fmt::format("--turning-radius: neither the planner {} nor the smoother has a turning radius; "
                  "add --planner hybrid_astar, --planner lattice, --planner car or --smoother "
                  "curvature",
                  planner.name));
}

std::optional<SmootherChoice> RefineArguments::smoother_choice(
    const Coordinates& coordinates) const {
  if (!smooth && smoother.empty()) {
    if (unsafe) throw InputError("--unsafe needs --smooth");
    if (max_distance) throw InputError("--max-distance needs --smooth");
    return std::nullopt;
  }
  SmootherChoice choice = smoother.empty() ? SmootherChoice{} : parse_smoother(smoother);
  const OptionValues weights = weights_of(smooth.value_or(""));
  choice.options.insert(choice.options.end(), weights.begin(), weights.end());
  if (unsafe) choice.options.emplace_back("unsafe", option_text::format(true));
  if (turning_radius) {
    choice.options.emplace_back(kTurningRadius,
                                format_number(coordinates.in_metres(*turning_radius)));
  }
  return choice;
}

Refinement RefineArguments::refinement(const Coordinates& coordinates) const {
  Refinement refinement;
  if (simplify) refinement.simplify = simplification_of(*simplify, coordinates);
  refinement.smoother = smoother_choice(coordinates);
  if (max_distance) refinement.max_distance = coordinates.in_cells(*max_distance);
  if (resample) refinement.spacing = coordinates.in_cells(*resample);
  return refinement;
}

SmootherChoice parse_smoother(std::string_view text) {
  auto specs = parse_option_specs(text, "smoother", smoothers().names());
  if (!specs) throw InputError(specs.error().message);
  if (specs->size() > 1)
    throw InputError(fmt::format("--smoother {}: --smoother takes exactly one smoother", text));
  return {specs->front().name, specs->front().options};
}

void add_corner_rounding(Parser& app, std::optional<double>& rounding) {
  add_number(
      app, "--corner-rounding", rounding, kRoundings,
      "Measure turning radii also with the path's corners rounded; limit on the distance between "
      "the rounded path and the corner (units as --robot-radius; default a tenth of a cell)");
  app.further({"--corner-rounding"});
}

double corner_rounding_in_cells(const std::optional<double>& rounding,
                                const Coordinates& coordinates) {
  return rounding ? coordinates.in_cells(*rounding) : kCornerRounding;
}

double RefineArguments::rounding(const Coordinates& coordinates) const {
  return corner_rounding_in_cells(corner_rounding, coordinates);
}

RefinedPath refine(const Path& path, const FreeSpace& space, const Refinement& refinement,
                   double corner_rounding) {
  auto refined = wend::refined(path, space, refinement);
  if (!refined) throw InputError(refined.error().message);
  return refined_path(path, refinement, *std::move(refined), space, corner_rounding);
}

RefinedPath with_lead(const Path& lead, RefinedPath path, const FreeSpace& space,
                      double corner_rounding) {
  path.refined.path = joined(lead, path.refined.path);
  return refined_path(joined(lead, path.before), path.wanted, std::move(path.refined), space,
                      corner_rounding);
}

std::vector<SceneLine> lines_of(const RefinedPath& path) {
  const auto points_of = [](const Path& each) {
    const auto points = polyline_of(each);
    return std::vector<Point>(points.points().begin(), points.points().end());
  };
  return {{LineRole::planned, points_of(path.before)},
          {LineRole::smoothed, points_of(path.refined.path)}};
}

std::string refined_text(const RefinedPath& path, const Coordinates& coordinates) {
  const std::vector<MeasuredPath> paths{path.measured_before, path.measured_after};
  return metrics_table(paths, coordinates.unit()) + smoothing_text(path, coordinates.unit());
}

}  // namespace wend::cli
