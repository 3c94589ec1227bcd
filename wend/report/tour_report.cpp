#include "wend/report/tour_report.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <iterator>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/report/json.hpp"

namespace wend {
namespace {

/// The rows of a tour's order that are stops of the file.
std::vector<int> rows_of_stops(const TourReport& report) {
  std::vector<int> rows;
  for (const int row : report.tour.order) {
    if (static_cast<std::size_t>(row) < report.stops) rows.push_back(row);
  }
  return rows;
}

Json row_of(const TourReport& report, int row) {
  return static_cast<std::size_t>(row) < report.stops ? Json(row) : Json();
}

Json json_of(const TourReport& report, const TourLeg& leg) {
  return {{"from", row_of(report, leg.from)},
          {"to", row_of(report, leg.to)},
          {"cost", leg.cost},
          {"first", leg.first},
          {"last", leg.last}};
}

}  // namespace

std::string cost_matrix_csv(const CostMatrix& costs) {
  std::string text;
  for (int from = 0; from < costs.size(); ++from) {
    for (int to = 0; to < costs.size(); ++to) {
      if (to > 0) text += ',';
      text += format_number(costs(from, to));
    }
    text += '\n';
  }
  return text;
}

std::string cost_matrix_npy(const CostMatrix& costs) {
  constexpr std::size_t kAlignment = 64;
  constexpr std::size_t kPreamble = 10;  // magic, version, length of the header
  std::string header = fmt::format(
      "{{'descr': '<f8', 'fortran_order': False, 'shape': ({0}, {0}), }}", costs.size());
  header.append(kAlignment - (kPreamble + header.size() + 1) % kAlignment, ' ');
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += '\x01';
  bytes += '\0';
  bytes += static_cast<char>(header.size() & 0xffU);
  bytes += static_cast<char>(header.size() >> 8U);
  bytes += header;
  for (const double cost : costs.values()) {
    const auto bits = std::bit_cast<std::uint64_t>(cost);
    for (unsigned shift = 0; shift < 64; shift += 8) {
      bytes += static_cast<char>((bits >> shift) & 0xffU);
    }
  }
  return bytes;
}

std::string cost_matrix_json(std::string_view planner, const StopCosts& costs,
                             const WorkTimes& times) {
  Json json{{"planner", planner}, {"stops", costs.costs.size()}};
  Json& rows = json["costs"] = Json::array();
  for (int from = 0; from < costs.costs.size(); ++from) rows.push_back(costs.costs.row(from));
  json["cut_off"] = costs.cut_off;
  json["times"] = json_of(times);
  return text_of(json);
}

std::string tour_json(const TourReport& report, const Frame& frame) {
  Json json{{"planner", report.planner}, {"status", to_string(report.tour.status)},
            {"closed", report.closed},   {"order", rows_of_stops(report)},
            {"cost", report.tour.cost},  {"bound", report.tour.bound},
            {"kicks", report.tour.kicks}};
  Json& legs = json["legs"] = Json::array();
  for (const TourLeg& leg : report.way.legs) legs.push_back(json_of(report, leg));
  Plan plan;
  plan.path = report.way.path;
  plan.cost = report.tour.cost;
  put_path(json, plan, frame, report.capabilities);
  json["times"] = json_of(report.times);
  return text_of(json);
}

std::string tour_text(const TourReport& report) {
  const Tour& tour = report.tour;
  std::string text = "order     ";
  const auto rows = rows_of_stops(report);
  for (std::size_t i = 0; i < rows.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ",", rows[i]);
  text += fmt::format("\ncost      {:.6g}\nbound     {:.6g}", tour.cost, tour.bound);
  if (tour.bound > 0) {
    text += fmt::format("; the best order is at most {:.2f} % cheaper",
                        100 * (1 - tour.bound / tour.cost));
  }
  text += fmt::format("\nlength    {:.6g} cells\n", report.way.path.length());
  if (tour.status != Status::found) {
    text += fmt::format("ended     early: {}\n", to_string(tour.status));
  }
  return text;
}

}  // namespace wend
