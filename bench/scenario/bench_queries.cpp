#include "bench/scenario/bench_queries.hpp"

#include <fmt/format.h>

#include "wend/base/parse.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

std::string microseconds(double seconds) {
  constexpr double kMicroseconds = 1e6;
  return format_number(kMicroseconds * seconds);
}

std::string line_of(const BenchedMap& map, const BenchAnswer& answer, bool fresh) {
  const bool first = answer.first.has_value();
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(map.scen), answer.line,
                     csv_field(map.planner), to_string(answer.status), format_number(answer.length),
                     answer.expanded, answer.wrong ? 1 : 0,
                     first ? microseconds(answer.first->prepare_s) : "",
                     first ? microseconds(answer.first->seconds) : "",
                     fresh ? "" : microseconds(answer.fastest()), answer.seconds.size());
}

}  // namespace

const std::string_view kBenchQueriesHeader =
    "scen,line,planner,status,length,expanded,wrong,prepare_us,first_us,later_us,passes\n";

std::string bench_queries_csv(std::span<const BenchedMap> maps, bool fresh) {
  std::string csv(kBenchQueriesHeader);
  for (const BenchedMap& map : maps) {
    for (const BenchAnswer& answer : map.answers) csv += line_of(map, answer, fresh);
  }
  return csv;
}

}  // namespace wend
