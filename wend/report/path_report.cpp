#include "wend/report/path_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "wend/geometry/angle.hpp"
#include "wend/report/json.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

std::string number(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

/// The number of decimals: enough to show a hundredth of a cell if the unit is metres.
int decimals_of(const LengthUnit& unit) { return unit.per_cell < 0.5 ? 3 : 2; }

constexpr std::string_view kRounding = "corner_rounding";  // stands in the title of another row

std::string title_of(const Metric& metric, const LengthUnit& unit, double rounding) {
  if (metric.name == "rounded_turning_radius") {
    return fmt::format("  corners rounded by {:.3g} {}", rounding * unit.per_cell, unit.name);
  }
  std::string title(metric.name);
  std::ranges::replace(title, '_', ' ');
  switch (metric.unit) {
    case MetricUnit::cells:
      return fmt::format("{}, {}", title, unit.name);
    case MetricUnit::radians:
      return title + ", degrees";
    case MetricUnit::count:
      break;
  }
  return title;
}

std::string text_of(const Metric& metric, const LengthUnit& unit) {
  switch (metric.unit) {
    case MetricUnit::cells:
      return number(metric.value * unit.per_cell, decimals_of(unit));
    case MetricUnit::radians:
      return number(degrees_from(metric.value), 0);
    case MetricUnit::count:
      break;
  }
  return number(metric.value, 0);
}

std::string line(std::string_view name, const std::string& what) {
  return fmt::format("{:<10}{}\n", name, what);
}

std::string ending_text(const Smoothed& smoothed) {
  return fmt::format("{} {}{}", smoothed.sweeps, smoothed.sweeps == 1 ? "sweep" : "sweeps",
                     smoothed.converged ? "" : ", stopped by the limit");
}

std::string held_text(const Smoothed& smoothed, bool bound) {
  if (smoothed.returned) return "all: smoothing would have lengthened the path, which is unchanged";
  if (smoothed.held == 0) return "none: no obstacle was in the way";
  return fmt::format("{:.3g} % of the inner points, by obstacles{}", 100 * smoothed.held,
                     bound ? " or the largest distance" : "");
}

/// Why some bends are tighter than asked, as far as that is known.
std::string curvature_text(const Smoothed& smoothed) {
  constexpr std::string_view kExceeds = "exceeds the bound in places: ";
  if (smoothed.returned) return fmt::format("{}wider bends would lengthen the path", kExceeds);
  if (smoothed.held > 0) return fmt::format("{}points there are held", kExceeds);
  if (!smoothed.converged) return fmt::format("{}the limit of sweeps was reached", kExceeds);
  return fmt::format("{}the path bends back beside itself, or its ends are too near", kExceeds);
}

bool is_bound(const Refinement& wanted) {
  const bool by_radius = wanted.smoother && wanted.smoother->name == "curvature";
  return wanted.max_distance.has_value() || by_radius;
}

Json json_of_smoothing(const RefinedPath& path, const Frame& frame) {
  const auto& smoothing = path.refined.smoothing;
  if (!smoothing || !path.wanted.smoother) return {};
  return {{"smoother", path.wanted.smoother->name},
          {"sweeps", smoothing->sweeps},
          {"converged", smoothing->converged},
          {"held", smoothing->held},
          {"returned", smoothing->returned},
          {"within_bound", smoothing->within_bound},
          {"largest_distance_cells", smoothing->distance},
          {"largest_distance_m", smoothing->distance * frame.resolution}};
}

}  // namespace

MeasuredPath measured(std::string title, const Path& path, const FreeSpace& space,
                      double corner_rounding) {
  MeasuredPath measured{std::move(title), path.size(), {}};
  if (auto metrics = measure(path, space, corner_rounding)) measured.metrics = *metrics;
  return measured;
}

std::string metrics_table(std::span<const MeasuredPath> paths, const LengthUnit& unit) {
  if (!paths.front().metrics) return {};
  std::vector<TextTable::Column> columns{{""}};
  for (const MeasuredPath& path : paths) {
    columns.push_back({paths.size() > 1 ? path.title : "", Align::right});
  }
  TextTable table(std::move(columns));
  std::vector<std::string> points{"points"};
  for (const MeasuredPath& path : paths) points.push_back(std::to_string(path.points));
  table.add(std::move(points));
  const std::vector<Metric> listed = metrics_of(*paths.front().metrics);
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (listed[i].name == kRounding) continue;
    std::vector<std::string> fields{
        title_of(listed[i], unit, paths.front().metrics->corner_rounding)};
    for (const MeasuredPath& path : paths) {
      fields.push_back(path.metrics ? text_of(metrics_of(*path.metrics)[i], unit) : "-");
    }
    table.add(std::move(fields));
  }
  const std::string text = table.text();
  return paths.size() > 1 ? text : text.substr(text.find('\n') + 1);  // no titles
}

std::string_view to_string(CollisionKind kind) {
  constexpr std::array<Choice<CollisionKind>, 5> kNames{{{"outside", CollisionKind::outside},
                                                         {"obstacle", CollisionKind::obstacle},
                                                         {"too_close", CollisionKind::too_close},
                                                         {"squeezed", CollisionKind::squeezed},
                                                         {"overlaps", CollisionKind::overlaps}}};
  return choice_name(kind, kNames);
}

Json json_of(const MeasuredPath& path, const Frame& frame) {
  if (!path.metrics) return {};
  Json json{{"points", path.points}};
  for (const Metric& metric : metrics_of(*path.metrics)) put(json, metric, frame);
  return json;
}

void put_paths(Json& json, const RefinedPath& path, const Frame& frame) {
  if (path.before.leads_over_cells()) {
    json["path"] = json_of(path.before.passed_cells());
    json["path_m"] = json_of(path.before.points_in_metres(frame));
  }
  put_refined(json, path, frame);
}

void put_refined(Json& json, const RefinedPath& path, const Frame& frame) {
  json["path_smoothed"] = json_of(path.refined.path.points());
  json["path_smoothed_m"] = json_of(path.refined.path.points_in_metres(frame));
  if (path.refined.path.driven()) put_driven(json, path.refined.path, frame);
  json["smoothing"] = json_of_smoothing(path, frame);
  json["path_metrics"] = json_of(path.measured_before, frame);
  json["path_smoothed_metrics"] = json_of(path.measured_after, frame);
}

std::string check_json(const MeasuredPath& path, const std::optional<PathCollision>& collision,
                       const Frame& frame, double lead_cells) {
  Json json{{"free", !collision.has_value()}, {"collision", Json()}};
  if (collision) {
    json["collision"] = {
        {"kind", to_string(collision->kind)},
        {"along_cells", collision->along},
        {"along_m", collision->along * frame.resolution},
        {"point", json_of(collision->point)},
        {"point_m", json_of_fractions(frame.to_metres(collision->point))},
        {"obstacle", collision->obstacle ? json_of(*collision->obstacle) : Json()}};
  }
  if (lead_cells > 0) {
    json["lead_out"] = {{"length_cells", lead_cells}, {"length_m", lead_cells * frame.resolution}};
  }
  json["metrics"] = json_of(path, frame);
  return text_of(json);
}

RefinedPath refined_path(Path before, const Refinement& wanted, Refined refined,
                         const FreeSpace& space, double corner_rounding) {
  RefinedPath path{std::move(before), wanted, std::move(refined), {}, {}};
  if (wanted.smoother) path.wanted.smoother = smoother_for(path.before, *wanted.smoother);
  path.measured_before = measured("planned", path.before, space, corner_rounding);
  path.measured_after = measured(path.wanted.smoother ? "smoothed" : "simplified",
                                 path.refined.path, space, corner_rounding);
  return path;
}

std::string smoothing_text(const RefinedPath& path, const LengthUnit& unit) {
  const auto& smoothing = path.refined.smoothing;
  if (!smoothing) return {};
  std::string text =
      line("smoother", path.wanted.smoother ? path.wanted.smoother->name : "") +
      line("smoothed", ending_text(*smoothing)) +
      line("held", held_text(*smoothing, is_bound(path.wanted))) +
      line("moved",
           fmt::format("at most {} {} from the given path",
                       number(smoothing->distance * unit.per_cell, decimals_of(unit)), unit.name));
  if (!smoothing->within_bound) text += line("curvature", curvature_text(*smoothing));
  return text;
}

std::string smoothing_json(const RefinedPath& path, const Frame& frame,
                           const std::optional<SampledTrajectory>& trajectory) {
  Json json;
  put_paths(json, path, frame);
  if (trajectory) json["trajectory"] = json_of(*trajectory);
  return text_of(json);
}

std::string failed_plan_json(const FailedPlan& plan) {
  return text_of({{"status", plan.status},
                  {"reason", plan.reason},
                  {"path", Json::array()},
                  {"path_m", Json::array()}});
}

}  // namespace wend
