#include "wend/report/exploration_report.hpp"

#include <fmt/format.h>

#include <numbers>

#include "wend/report/json.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

/// In cells.
double length_of(const std::vector<Cell>& driven) {
  double length = 0;
  for (std::size_t i = 1; i < driven.size(); ++i) {
    const bool diagonal = driven[i].x != driven[i - 1].x && driven[i].y != driven[i - 1].y;
    length += diagonal ? std::numbers::sqrt2 : 1;
  }
  return length;
}

std::string milliseconds(double seconds) { return fmt::format("{:.3f}", seconds * 1e3); }

}  // namespace

std::string exploration_table(const ExplorationReport& report, const Frame& frame, bool metric,
                              std::size_t width) {
  TextTable table({{"planner"},
                   {"outcome"},
                   {metric ? "driven\nm" : "driven\ncells", Align::right},
                   {"cost", Align::right},
                   {"plans", Align::right},
                   {"expanded", Align::right},
                   {"first\nms", Align::right},
                   {"all plans\nms", Align::right},
                   {"worst\nms", Align::right}});
  for (const ExplorationRow& row : report.rows) {
    const double length = length_of(row.driven) * (metric ? frame.resolution : 1);
    table.add({row.planner,
               row.status == Status::found ? "arrived" : std::string(to_string(row.status)),
               fmt::format("{:.2f}", length), fmt::format("{:.2f}", row.cost),
               fmt::format("{}", row.totals.replans), fmt::format("{}", row.totals.expanded),
               milliseconds(row.totals.first_seconds), milliseconds(row.totals.planning_seconds),
               milliseconds(row.totals.worst_seconds)});
  }
  return table.text(width);
}

std::string exploration_json(const ExplorationReport& report, const Frame& frame) {
  Json drives = Json::array();
  for (const ExplorationRow& row : report.rows) {
    const double length = length_of(row.driven);
    drives.push_back({{"planner", row.planner},
                      {"status", to_string(row.status)},
                      {"reason", row.reason},
                      {"driven_cells", length},
                      {"driven_m", length * frame.resolution},
                      {"cost", row.cost},
                      {"replans", row.totals.replans},
                      {"cells_seen", row.totals.seen},
                      {"expanded", row.totals.expanded},
                      {"first_us", in_microseconds(row.totals.first_seconds)},
                      {"planning_us", in_microseconds(row.totals.planning_seconds)},
                      {"worst_us", in_microseconds(row.totals.worst_seconds)},
                      {"path", json_of(std::span<const Cell>(row.driven))}});
  }
  return text_of({{"schema", kJsonSchema},
                  {"start", json_of(report.start)},
                  {"goal", json_of(report.goal)},
                  {"sensor_range_cells", report.sensor_range},
                  {"drives", std::move(drives)}});
}

std::string exploration_csv(const ExplorationReport& report, const Frame& frame) {
  std::string text =
      "planner,status,reason,driven_cells,driven_m,cost,replans,cells_seen,expanded,first_us,"
      "planning_us,worst_us\n";
  for (const ExplorationRow& row : report.rows) {
    const double length = length_of(row.driven);
    text += fmt::format("{},{},{},{},{},{},{},{},{},{:.3f},{:.3f},{:.3f}\n", csv_field(row.planner),
                        to_string(row.status), csv_field(row.reason), length,
                        length * frame.resolution, row.cost, row.totals.replans, row.totals.seen,
                        row.totals.expanded, row.totals.first_seconds * 1e6,
                        row.totals.planning_seconds * 1e6, row.totals.worst_seconds * 1e6);
  }
  return text;
}

}  // namespace wend
