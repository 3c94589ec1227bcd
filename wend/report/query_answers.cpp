#include "wend/report/query_answers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <map>

#include "wend/base/parse.hpp"
#include "wend/report/json.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

double microseconds(const QueryAnswer& answer) { return std::round(answer.seconds * 1e9) / 1000; }

/// "3 found, 1 unreachable"
std::string counts_of(std::span<const QueryAnswer> answers) {
  std::map<std::string, std::size_t> counts;
  for (const QueryAnswer& answer : answers) ++counts[answer.status];
  std::string text;
  for (const auto& [status, count] : counts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, status);
  }
  return text;
}

}  // namespace

std::string query_answers_csv(std::span<const QueryAnswer> answers, const Frame& frame) {
  std::string text =
      "line,start,goal,status,reason,cost,length_cells,length_m,expanded,search_us,start_shift_m,"
      "goal_shift_m\n";
  for (const QueryAnswer& answer : answers) {
    std::string numbers = ",,";
    std::string shifts = ",";
    if (answer.found()) {
      const double length = answer.plan.path.length();
      numbers = fmt::format("{},{},{}", format_number(answer.plan.cost), format_number(length),
                            format_number(length * frame.resolution));
      shifts = fmt::format(
          "{},{}", format_number(answer.plan.start_snapping_error.distance * frame.resolution),
          format_number(answer.plan.goal_snapping_error.distance * frame.resolution));
    }
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n", answer.line,
                   csv_field(answer.start), csv_field(answer.goal), answer.status,
                   csv_field(answer.reason), numbers, answer.plan.metrics.expanded,
                   format_number(microseconds(answer)), shifts);
  }
  return text;
}

std::string query_answers_json(std::string_view planner, std::span<const QueryAnswer> answers,
                               const Frame& frame, const Capabilities& capabilities) {
  Json rows = Json::array();
  for (const QueryAnswer& answer : answers) {
    Json row{{"line", answer.line},
             {"start", answer.start},
             {"goal", answer.goal},
             {"status", answer.status},
             {"reason", answer.reason}};
    put_path(row, answer.plan, frame, capabilities);
    put_shifts(row, answer.plan, frame);
    put_eased(row, answer.lead_out, answer.remaining, frame);
    row["metrics"] = json_of(answer.plan.metrics);
    row["search_us"] = in_microseconds(answer.seconds);
    rows.push_back(std::move(row));
  }
  return text_of({{"planner", planner}, {"answers", std::move(rows)}});
}

std::string query_answers_text(std::span<const QueryAnswer> answers, const Frame& frame) {
  TextTable table({{"line", Align::right},
                   {"start"},
                   {"goal"},
                   {"status"},
                   {"cost", Align::right},
                   {frame.metric ? "length m" : "length", Align::right},
                   {"expanded", Align::right},
                   {"search us", Align::right}});
  const double unit = frame.metric ? frame.resolution : 1;
  for (const QueryAnswer& answer : answers) {
    const bool found = answer.found();
    table.add({std::to_string(answer.line), answer.start, answer.goal, answer.status,
               found ? fmt::format("{:.6g}", answer.plan.cost) : "",
               found ? fmt::format("{:.6g}", answer.plan.path.length() * unit) : "",
               std::to_string(answer.plan.metrics.expanded),
               fmt::format("{:.1f}", microseconds(answer))});
  }
  if (answers.empty()) return "0 queries\n";
  return table.text() + fmt::format("{} {}: {}\n", answers.size(),
                                    answers.size() == 1 ? "query" : "queries", counts_of(answers));
}

}  // namespace wend
