#include "loaders.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "checks.hpp"
#include "forged_index.hpp"
#include "fuzzed_bench_database.hpp"
#include "fuzzed_c_interface.hpp"
#include "fuzzed_follow.hpp"
#include "fuzzed_map_updates.hpp"
#include "fuzzed_map_yaml.hpp"
#include "fuzzed_mask.hpp"
#include "fuzzed_nav2.hpp"
#include "fuzzed_path.hpp"
#include "fuzzed_path_messages.hpp"
#include "fuzzed_session.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/io/path/path_csv.hpp"
#include "wend/io/primitives/load_primitives.hpp"
#include "wend/io/query/dynamic_scenario.hpp"
#include "wend/io/query/query_csv.hpp"
#include "wend/io/query/scenario.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/footprint.hpp"

namespace wend::test {
namespace {

std::string fuzz_png(std::string_view bytes) {
  const auto image = whole_image(bytes, decode_png);
  if (image && !looks_like_png(bytes)) return "a PNG without its signature";
  return check_image(image);
}

std::string fuzz_pnm(std::string_view bytes) {
  return looks_like_pnm(bytes) ? check_image(whole_image(bytes, decode_pnm)) : "";
}

std::string fuzz_bmp(std::string_view bytes) {
  return looks_like_bmp(bytes) ? check_image(whole_image(bytes, decode_bmp)) : "";
}

std::string fuzz_jpeg(std::string_view bytes) {
  return looks_like_jpeg(bytes) ? check_image(whole_image(bytes, decode_jpeg)) : "";
}

std::string fuzz_moving_ai_map(std::string_view bytes) {
  return check_map(load_as(MapFormat::moving_ai_map, bytes));
}

std::string fuzz_text_grid(std::string_view bytes) {
  return check_map(load_as(MapFormat::text_grid, bytes));
}

std::string fuzz_scenario(std::string_view bytes) {
  const auto scenario = parse_scenario(bytes, kFuzzedFile);
  if (!scenario) return check_error(scenario.error());
  for (const ScenarioQuery& query : scenario->queries) {
    const bool inside = query.start.x >= 0 && query.start.y >= 0 && query.goal.x >= 0 &&
                        query.goal.y >= 0 && query.start.x < query.map_width &&
                        query.goal.x < query.map_width && query.start.y < query.map_height &&
                        query.goal.y < query.map_height;
    if (!inside) return "a query that is not on its map";
    if (!length_matches(query, query.length)) return "a length that does not match itself";
  }
  const auto map = scenario_map_path(*scenario);
  return map ? "a map in a folder that has none" : check_error(map.error());
}

/// The scenario, a line with only '%', and its patches.
std::string fuzz_dynamic_scenario(std::string_view bytes) {
  const std::size_t end = bytes.find("\n%\n");
  const std::string_view text = bytes.substr(0, end);
  const auto scenario =
      parse_dynamic_scenario(text, kFuzzedFile, [&](const std::filesystem::path&) {
        const bool any = end != std::string_view::npos;
        return Expected<std::string, Error>(any ? std::string(bytes.substr(end + 3)) : "");
      });
  if (!scenario) {
    return scenario.error().message.empty() ? "an error without a message" : "";
  }
  const CellBox map{{0, 0}, {scenario->width, scenario->height}};
  for (const auto& command : scenario->commands) {
    if (const auto* patch = std::get_if<PatchCommand>(&command)) {
      if (patch->patch >= scenario->patches.size()) return "a patch that is not there";
      const CellBox box = scenario->edit_of(*patch).box();
      if (box.empty() || box.common_with(map) != box) return "a patch over the map's edge";
    } else {
      const auto& query = std::get<ScenarioQuery>(command);
      if (!map.contains(query.start) || !map.contains(query.goal)) return "a query off the map";
    }
  }
  return {};
}

/// A path that was read comes back from the CSV that wend writes of it.
std::string check_path(const Expected<Path, Error>& path) {
  if (!path) return check_error(path.error());
  if (path->empty()) return "a path of nothing";
  const auto again = parse_path_csv(path_csv(*path, {}), kFuzzedFile, {});
  return again && *again == *path ? "" : "another path comes back";
}

std::string fuzz_path_csv(std::string_view bytes) {
  return check_path(parse_path_csv(bytes, kFuzzedFile, {}));
}

std::string fuzz_path_json(std::string_view bytes) {
  const std::string wrong = check_path(parse_path_json(bytes, kFuzzedFile, {}));
  if (!wrong.empty()) return wrong;
  return check_path(parse_path_json(bytes, kFuzzedFile, {}, PathStage::smoothed));
}

/// Rows that were read say the same again in the form of one column for each end.
std::string fuzz_query_csv(std::string_view bytes) {
  const auto rows = parse_query_csv(bytes, kFuzzedFile);
  if (!rows) return check_error(rows.error());
  std::size_t line = 1;
  for (const QueryRow& row : *rows) {
    if (row.line <= line) return "rows that do not follow each other";
    line = row.line;
    if (!row.wrong.empty()) {
      if (!row.start.empty() || !row.goal.empty()) return "a bad row with ends";
      continue;
    }
    const auto quoted = [](const std::string& text) {
      std::string field = "\"";
      for (const char letter : text) field += letter == '"' ? "\"\"" : std::string(1, letter);
      return field + "\"";
    };
    const auto again = parse_query_csv(
        "start,goal\n" + quoted(row.start) + "," + quoted(row.goal) + "\n", kFuzzedFile);
    if (!again || again->size() != 1 || again->front().start != row.start ||
        again->front().goal != row.goal) {
      return "another query comes back";
    }
  }
  return "";
}

std::string fuzz_planner_specs(std::string_view bytes) {
  const auto specs = parse_planner_specs(bytes);
  if (!specs) return specs.error().message.empty() ? "the error says nothing" : "";
  if (specs->empty()) return "no planner, and no error";
  std::string text;
  for (const PlannerSpec& spec : *specs) text += (text.empty() ? "" : ",") + spec.text;
  const auto again = parse_planner_specs(text);
  return again && again->size() == specs->size() ? "" : "other planners come back";
}

/// A footprint that was read comes back from its text.
std::string fuzz_footprint(std::string_view bytes) {
  const auto footprint = parse_footprint(bytes);
  if (!footprint) return check_text(footprint.error().message);
  if (!footprint->valid()) return "an invalid footprint";
  if (footprint->inscribed_radius() > footprint->circumscribed_radius()) return "radii swapped";
  const InnerDisc& inner = footprint->inner_disc();
  if (!(inner.radius >= 0 && std::isfinite(inner.centre.x) && std::isfinite(inner.centre.y))) {
    return "an inner disc that is none";
  }
  const auto again = parse_footprint(text_of(*footprint));
  return again && *again == *footprint ? "" : "another footprint comes back";
}

/// What was read is a set that could be searched with: it comes back from its own parts.
std::string fuzz_primitives(std::string_view bytes) {
  const auto primitives = parse_primitives(bytes, kFuzzedFile);
  if (!primitives) return check_error(primitives.error());
  std::vector<double> headings(primitives->headings().begin(), primitives->headings().end());
  std::vector<MotionPrimitive> all(primitives->all().begin(), primitives->all().end());
  std::size_t leaving = 0;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    leaving += primitives->leaving(static_cast<int>(i)).size();
    if (primitives->nearest_heading(headings[i]) != static_cast<int>(i)) return "another heading";
  }
  if (leaving != all.size()) return "primitives that leave nowhere";
  const auto again =
      MotionPrimitives::make({primitives->resolution(), std::move(headings), std::move(all)});
  if (!again) return "an invalid set: " + again.error().message;
  return again->all().size() == primitives->all().size() ? "" : "another set comes back";
}

/// The bytes as a file, and as changes to whole files.
std::string fuzz_index(std::string_view bytes) {
  const auto header = read_index_header(std::as_bytes(std::span(bytes)));
  const std::string wrong = header ? "" : check_text(header.error().message);
  return wrong.empty() ? use_forged_indexes(bytes) : wrong;
}

constexpr std::array kLoaders{
    Loader{"map_yaml", fuzz_map_yaml},
    Loader{"mask", fuzz_mask},
    Loader{"mask_spec", fuzz_mask_spec},
    Loader{"png", fuzz_png},
    Loader{"pnm", fuzz_pnm},
    Loader{"bmp", fuzz_bmp},
    Loader{"jpeg", fuzz_jpeg},
    Loader{"moving_ai_map", fuzz_moving_ai_map},
    Loader{"text_grid", fuzz_text_grid},
    Loader{"scenario", fuzz_scenario},
    Loader{"dynamic_scenario", fuzz_dynamic_scenario},
    Loader{"path_csv", fuzz_path_csv},
    Loader{"path_json", fuzz_path_json},
    Loader{"query_csv", fuzz_query_csv},
    Loader{"planner_specs", fuzz_planner_specs},
    Loader{"footprint", fuzz_footprint},
    Loader{"primitives", fuzz_primitives},
    Loader{"index", fuzz_index},
    Loader{"bench_database", fuzz_bench_database},
    Loader{"c_interface", fuzz_c_interface},
    Loader{"session", fuzz_session},
    Loader{"map_updates", fuzz_map_updates},
    Loader{"path_messages", fuzz_path_messages},
    Loader{"nav2", fuzz_nav2},
    Loader{"check", fuzz_check},
    Loader{"measure", fuzz_measure},
    Loader{"simplify", fuzz_simplify},
    Loader{"resample", fuzz_resample},
    Loader{"smooth", fuzz_smooth},
    Loader{"trajectory", fuzz_trajectory},
    Loader{"follow", fuzz_follow},
};

}  // namespace

std::span<const Loader> fuzzed_loaders() { return kLoaders; }

int fuzz_or_abort(std::string_view loader, const std::uint8_t* data, std::size_t size) {
  const auto found = std::ranges::find(kLoaders, loader, &Loader::name);
  if (found == kLoaders.end()) {
    std::fprintf(stderr, "wend: no loader has this fuzzer's name\n");
    std::abort();
  }
  const std::string wrong = found->fuzz({reinterpret_cast<const char*>(data), size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "wend: %s\n", wrong.c_str());
  std::abort();
}

}  // namespace wend::test
