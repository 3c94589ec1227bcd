#include "wend/report/coverage_report.hpp"

#include <fmt/format.h>

#include <utility>

#include "wend/report/json.hpp"

namespace wend {
namespace {

std::string reason_of(const MissedPlace& place, const Units& units) {
  if (place.reachable) return "left out, as --share allows";
  if (!place.radius) return "no way leads there";
  return fmt::format("a robot with a radius up to {} gets there",
                     units.radius(*place.radius / units.frame().resolution));
}

}  // namespace

std::string coverage_text(const Coverage& coverage, std::span<const MissedPlace> missed,
                          const Units& units) {
  const double resolution = units.frame().resolution;
  const auto length = [&](double metres) { return units.length(metres / resolution); };
  std::string text = fmt::format("covered           {:.2f} % of {} that the tool can reach\n",
                                 100 * coverage.covered_share, units.area(coverage.wanted.count()));
  text += fmt::format("path              {}", length(coverage.length));
  if (coverage.lower_bound > 0) {
    text += fmt::format(", {:.2f} times the lower bound of {}",
                        coverage.length / coverage.lower_bound, length(coverage.lower_bound));
  }
  text += fmt::format("\nturns             {}\nstrokes           {}\n", coverage.turns,
                      coverage.strokes);
  for (const MissedPlace& place : missed) {
    text += fmt::format("missed            {} at {}: {}\n", units.area(place.cells),
                        units.text(place.cell), reason_of(place, units));
  }
  return text;
}

std::string coverage_json(const Coverage& coverage, std::span<const MissedPlace> missed,
                          const Frame& frame, double tool_width) {
  const double cell_area = frame.resolution * frame.resolution;
  Json places = Json::array();
  for (const MissedPlace& place : missed) {
    places.push_back({{"cell", json_of(place.cell)},
                      {"at_m", json_of_fractions(frame.to_metres(centre_of(place.cell)))},
                      {"cells", place.cells},
                      {"area_m2", static_cast<double>(place.cells) * cell_area},
                      {"reachable", place.reachable},
                      {"widest_radius_m", place.radius ? Json(*place.radius) : Json(nullptr)}});
  }
  return text_of({{"schema", kJsonSchema},
                  {"covered_share", coverage.covered_share},
                  {"length_m", coverage.length},
                  {"lower_bound_m", coverage.lower_bound},
                  {"turns", coverage.turns},
                  {"strokes", coverage.strokes},
                  {"tool_width_m", tool_width},
                  {"area_m2", static_cast<double>(coverage.wanted.count()) * cell_area},
                  {"covered_m2", static_cast<double>(coverage.covered.count()) * cell_area},
                  {"missed", std::move(places)},
                  {"waypoints", json_of(coverage.path.points())},
                  {"waypoints_m", json_of(coverage.path.points_in_metres(frame))}});
}

}  // namespace wend
