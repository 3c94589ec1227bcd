#include "bench/measure/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "wend/io/file_error.hpp"
#include "wend/io/files.hpp"
#include "wend/report/json.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

constexpr int kBaselineSchema = 2;

Baseline baseline_of(const Json& json) {
  Baseline baseline{.machine = json.at("machine"),
                    .commit = json.at("commit"),
                    .times = json.at("times"),
                    .tolerance = json.at("tolerance"),
                    .sample = json.at("sample"),
                    .rows = {}};
  for (const Json& row : json.at("rows")) {
    baseline.rows.push_back({row.at("subject"), row.at("measure"), row.at("ratio")});
  }
  return baseline;
}

/// Three digits for small ratios.
std::string digits(double ratio) {
  return ratio < 10 ? fmt::format("{:.3g}", ratio) : fmt::format("{:.1f}", ratio);
}

/// "+12 %" if faster, "-12 %" if slower.
std::string change(double now, double before) {
  return fmt::format("{:+.0f} %", 100 * (now / before - 1));
}

const BaselineRow* row_like(const std::vector<BaselineRow>& rows, const BaselineRow& row) {
  const auto found = std::ranges::find_if(rows, [&](const BaselineRow& each) {
    return each.subject == row.subject && each.measure == row.measure;
  });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

Expected<Baseline, Error> read_baseline(const std::filesystem::path& file) {
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

std::string baseline_json(const Baseline& baseline) {
  Json json{
      {"schema", kBaselineSchema}, {"machine", baseline.machine},     {"commit", baseline.commit},
      {"times", baseline.times},   {"tolerance", baseline.tolerance}, {"sample", baseline.sample},
      {"rows", Json::array()}};
  for (const auto& [subject, measure, ratio] : baseline.rows) {
    json["rows"].push_back({{"subject", subject}, {"measure", measure}, {"ratio", ratio}});
  }
  return json.dump(2) + "\n";
}

BaselineVerdict compared(const Baseline& baseline, const std::vector<BaselineRow>& now) {
  TextTable table({{"subject"},
                   {"measure"},
                   {"now", Align::right},
                   {"baseline", Align::right},
                   {"change", Align::right},
                   {""}});
  BaselineVerdict verdict;
  std::string last;
  for (const BaselineRow& row : now) {
    const std::string subject = row.subject == last ? "" : row.subject;
    last = row.subject;
    const BaselineRow* const before = row_like(baseline.rows, row);
    if (before == nullptr) {
      table.add({subject, row.measure, digits(row.ratio), "", "", "new"});
      continue;
    }
    const bool slower = row.ratio < (1 - baseline.tolerance) * before->ratio;
    verdict.slower = verdict.slower || slower;
    table.add({subject, row.measure, digits(row.ratio), digits(before->ratio),
               change(row.ratio, before->ratio), slower ? "SLOWER" : ""});
  }
  for (const BaselineRow& row : baseline.rows) {
    if (row_like(now, row) != nullptr) continue;
    verdict.slower = true;
    table.add({row.subject, row.measure, "", digits(row.ratio), "", "NOT MEASURED"});
  }
  verdict.table = table.text();
  return verdict;
}

}  // namespace wend
