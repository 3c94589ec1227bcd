#include "bench/measure/speed_baseline.hpp"

#include <fmt/format.h>

#include <array>

#include "wend/io/file_error.hpp"
#include "wend/io/files.hpp"
#include "wend/report/json.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

constexpr int kBaselineSchema = 1;

SpeedBaseline baseline_of(const Json& json) {
  SpeedBaseline baseline{.machine = json.at("machine"),
                         .commit = json.at("commit"),
                         .tolerance = json.at("tolerance"),
                         .sample = json.at("sample"),
                         .rows = {}};
  for (const Json& row : json.at("planners")) {
    baseline.rows.push_back(
        {row.at("planner"), {row.at("later"), row.at("first"), row.at("prepare")}});
  }
  return baseline;
}

/// What is compared, with its name in the table.
struct Measure {
  const char* name;
  double SpeedRatios::* ratio;
};

constexpr std::array kMeasures{Measure{"later queries", &SpeedRatios::later},
                               Measure{"first query", &SpeedRatios::first},
                               Measure{"preparation", &SpeedRatios::prepare}};

/// Three digits for small ratios.
std::string digits(double ratio) {
  return ratio < 10 ? fmt::format("{:.3g}", ratio) : fmt::format("{:.1f}", ratio);
}

/// "+12 %" if faster, "-12 %" if slower.
std::string change(double now, double before) {
  return fmt::format("{:+.0f} %", 100 * (now / before - 1));
}

}  // namespace

Expected<SpeedBaseline, Error> read_baseline(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return Unexpected<Error>(text.error());
  try {
    const Json json = Json::parse(*text);
    if (json.at("schema") != kBaselineSchema) {
      return file_failure(file.string(), 0,
                          fmt::format("schema {} is not supported, only {} is",
                                      json.at("schema").dump(), kBaselineSchema));
    }
    return baseline_of(json);
  } catch (const Json::exception& error) {
    return file_failure(file.string(), 0, fmt::format("not a baseline: {}", error.what()));
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
    json["planners"].push_back({{"planner", row.planner},
                                {"later", row.ratios.later},
                                {"first", row.ratios.first},
                                {"prepare", row.ratios.prepare}});
  }
  return json.dump(2) + "\n";
}

BaselineVerdict compared(const SpeedBaseline& baseline, const std::vector<BaselineRow>& now) {
  TextTable table({{"planner"},
                   {"measure"},
                   {"now", Align::right},
                   {"baseline", Align::right},
                   {"change", Align::right},
                   {""}});
  BaselineVerdict verdict;
  for (std::size_t i = 0; i < now.size(); ++i) {
    for (const Measure& measure : kMeasures) {
      const double ratio = now[i].ratios.*measure.ratio;
      const double before = baseline.rows[i].ratios.*measure.ratio;
      const bool slower = ratio < (1 - baseline.tolerance) * before;
      verdict.slower = verdict.slower || slower;
      table.add({&measure == &kMeasures.front() ? now[i].planner : "", measure.name, digits(ratio),
                 digits(before), change(ratio, before), slower ? "SLOWER" : ""});
    }
  }
  verdict.table = table.text();
  return verdict;
}

}  // namespace wend
