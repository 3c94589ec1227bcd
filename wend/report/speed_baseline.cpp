#include "wend/report/speed_baseline.hpp"

#include <fmt/format.h>

#include "wend/io/read_file.hpp"
#include "wend/report/json.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

using Error = Unexpected<std::string>;

constexpr int kBaselineSchema = 1;

SpeedBaseline baseline_of(const Json& json) {
  SpeedBaseline baseline{.machine = json.at("machine"),
                         .commit = json.at("commit"),
                         .tolerance = json.at("tolerance"),
                         .sample = json.at("sample"),
                         .rows = {}};
  for (const Json& row : json.at("planners")) {
    baseline.rows.push_back({row.at("planner"), {row.at("later"), row.at("fresh")}});
  }
  return baseline;
}

/// "+12 %" of what is faster, "-12 %" of what is slower.
std::string change(double now, double before) {
  return fmt::format("{:+.0f} %", 100 * (now / before - 1));
}

}  // namespace

Expected<SpeedBaseline, std::string> read_baseline(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return Error(text.error().message());
  try {
    const Json json = Json::parse(*text);
    if (json.at("schema") != kBaselineSchema) {
      return Error(fmt::format("{}: schema {} is not supported, only {} is", file.string(),
                               json.at("schema").dump(), kBaselineSchema));
    }
    return baseline_of(json);
  } catch (const Json::exception& error) {
    return Error(fmt::format("{}: not a baseline: {}", file.string(), error.what()));
  }
}

std::string baseline_json(const SpeedBaseline& baseline) {
  Json json{{"schema", kBaselineSchema},
            {"machine", baseline.machine},
            {"commit", baseline.commit},
            {"times", "times as fast as Boost.Graph's A*, CPU time, geometric mean over the maps"},
            {"tolerance", baseline.tolerance},
            {"sample", baseline.sample},
            {"planners", Json::array()}};
  for (const BaselineRow& row : baseline.rows) {
    json["planners"].push_back(
        {{"planner", row.planner}, {"later", row.ratios.later}, {"fresh", row.ratios.fresh}});
  }
  return json.dump(2) + "\n";
}

BaselineVerdict compared(const SpeedBaseline& baseline, const std::vector<BaselineRow>& now) {
  TextTable table({{"planner"},
                   {"later\nnow", Align::right},
                   {"later\nbaseline", Align::right},
                   {"\nchange", Align::right},
                   {"fresh\nnow", Align::right},
                   {"fresh\nbaseline", Align::right},
                   {"\nchange", Align::right},
                   {""}});
  BaselineVerdict verdict;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const SpeedRatios& ratios = now[i].ratios;
    const SpeedRatios& before = baseline.rows[i].ratios;
    const double least = 1 - baseline.tolerance;
    const bool slower = ratios.later < least * before.later || ratios.fresh < least * before.fresh;
    verdict.slower = verdict.slower || slower;
    table.add({now[i].planner, fmt::format("{:.1f}", ratios.later),
               fmt::format("{:.1f}", before.later), change(ratios.later, before.later),
               fmt::format("{:.1f}", ratios.fresh), fmt::format("{:.1f}", before.fresh),
               change(ratios.fresh, before.fresh), slower ? "SLOWER" : ""});
  }
  verdict.table = table.text();
  return verdict;
}

}  // namespace wend
