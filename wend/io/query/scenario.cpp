#include "wend/io/query/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "wend/base/parse.hpp"
#include "wend/io/files.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kColumns = 9;

/// The fields between tabs, or between blanks in a line without tabs.
std::vector<std::string_view> columns_of(std::string_view line) {
  if (line.find('\t') == std::string_view::npos) return words_of(line);
  auto columns = fields_of(line, '\t');
  std::ranges::transform(columns, columns.begin(), trimmed);
  return columns;
}

/// Reads the columns of one line and keeps the first error.
class LineParser {
 public:
  explicit LineParser(std::string_view line) : columns_(columns_of(trimmed(line))) {
    if (columns_.size() != kColumns) {
      wrong_ = fmt::format("{} columns, expected {}", columns_.size(), kColumns);
    }
  }

  ScenarioQuery read(std::size_t line) {
    ScenarioQuery query{};
    query.line = line;
    query.bucket = integer("bucket");
    query.map = next();
    query.map_width = integer("map width");
    query.map_height = integer("map height");
    query.start = {integer("start x"), integer("start y")};
    query.goal = {integer("goal x"), integer("goal y")};
    const std::string_view length = next();
    query.length = parse_number(length).value_or(-1);
    query.decimals = decimals_of(length);
    check(query, length);
    return query;
  }

  const std::string& wrong() const { return wrong_; }

 private:
  std::string_view next() { return wrong_.empty() ? columns_[at_++] : ""; }

  int integer(std::string_view name) {
    const std::string_view text = next();
    const auto value = parse_integer<int>(text);
    if (!value) complain(fmt::format("{} {} is not a whole number in range", name, quote(text)));
    return value.value_or(0);
  }

  void check(const ScenarioQuery& query, std::string_view length) {
    if (query.map_width <= 0 || query.map_height <= 0) complain("the map size must be positive");
    check_inside("start", query.start, query);
    check_inside("goal", query.goal, query);
    if (!std::isfinite(query.length) || query.length < 0) {
      complain(fmt::format("the length must be finite and at least 0, not {}", quote(length)));
    }
  }

  void check_inside(std::string_view name, Cell cell, const ScenarioQuery& query) {
    if (cell.x < 0 || cell.y < 0 || cell.x >= query.map_width || cell.y >= query.map_height) {
      complain(fmt::format("{} ({},{}) is outside the {}x{} map", name, cell.x, cell.y,
                           query.map_width, query.map_height));
    }
  }

  void complain(std::string what) {
    if (wrong_.empty()) wrong_ = std::move(what);
  }

  std::vector<std::string_view> columns_;
  std::size_t at_ = 0;
  std::string wrong_;
};

/// The error in the first line, empty if it is valid.
std::string wrong_version(std::string_view line) {
  const auto words = words_of(line);
  if (words.size() != 2 || words[0] != "version") {
    return fmt::format("the first line must be 'version 1', not {}", quote(line));
  }
  const auto version = parse_number(words[1]);
  if (!version) return fmt::format("version {} is not a number", quote(words[1]));
  if (*version != 1) return fmt::format("version {} is not supported, only 1 is", words[1]);
  return {};
}

bool is_file(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

/// The last part of the map column, if it is the same in all lines and is a file name.
std::optional<std::string> common_map_name(const Scenario& scenario) {
  std::optional<std::string> common;
  for (const ScenarioQuery& query : scenario.queries) {
    const std::string name = query.map.substr(query.map.find_last_of("/\\") + 1);
    if (common && name != *common) return std::nullopt;
    common = name;
  }
  if (common && (common->empty() || *common == "." || *common == "..")) return std::nullopt;
  return common;
}

}  // namespace

int decimals_of(std::string_view number) {
  const std::size_t point = number.find('.');
  if (point == std::string_view::npos) return 0;
  const std::size_t end = number.find_first_not_of("0123456789", point + 1);
  return static_cast<int>(std::min(end, number.size()) - point - 1);
}

Expected<Scenario, Error> parse_scenario(std::string_view text, const std::string& file) {
  LineReader lines(text);
  const std::string wrong = wrong_version(lines.next().value_or(""));
  if (!wrong.empty()) return file_failure(file, 1, wrong);
  Scenario scenario{file, {}};
  while (const auto line = lines.next()) {
    if (is_blank(*line)) continue;
    LineParser parser(*line);
    ScenarioQuery query = parser.read(lines.number());
    if (!parser.wrong().empty()) return file_failure(file, lines.number(), parser.wrong());
    scenario.queries.push_back(std::move(query));
  }
  return scenario;
}

Expected<Scenario, Error> load_scenario(const fs::path& file) {
  const auto text = read_file(file);
  if (!text) return Unexpected<Error>(text.error());
  return parse_scenario(*text, file.string());
}

std::string format_scenario(const std::vector<ScenarioQuery>& queries) {
  std::string text = "version 1\n";
  for (const ScenarioQuery& query : queries) {
    text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{:.{}f}\n", query.bucket, query.map,
                        query.map_width, query.map_height, query.start.x, query.start.y,
                        query.goal.x, query.goal.y, query.length, query.decimals);
  }
  return text;
}

Expected<std::vector<fs::path>, Error> scenarios_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".scen") files.push_back(entry.path());
  }
  if (error) return file_failure(folder.string(), 0, error.message());
  if (files.empty()) return file_failure(folder.string(), 0, "the folder contains no .scen file");
  std::sort(files.begin(), files.end());
  return files;
}

Expected<void, Error> check_map_size(const Scenario& scenario, int width, int height) {
  for (const ScenarioQuery& query : scenario.queries) {
    if (query.map_width == width && query.map_height == height) continue;
    return file_failure(scenario.file, query.line,
                        fmt::format("the query is for a {}x{} map, the map is {}x{}; maps are not "
                                    "scaled",
                                    query.map_width, query.map_height, width, height));
  }
  return {};
}

Expected<fs::path, Error> scenario_map_path(const Scenario& scenario) {
  const fs::path file = scenario.file;
  fs::path twin = file.parent_path() / file.stem();
  if (file.extension() == ".scen" && twin.has_extension() && is_file(twin)) return twin;
  const auto name = common_map_name(scenario);
  if (!name) return file_failure(scenario.file, 0, "expected one map name in all lines");
  fs::path named = file.parent_path() / *name;
  if (is_file(named)) return named;
  return file_failure(scenario.file, 0,
                      fmt::format("its map {} is not in the same folder", quote(*name)));
}

std::vector<ScenarioQuery> evenly_sampled(const std::vector<ScenarioQuery>& queries,
                                          std::size_t count) {
  if (queries.size() <= count) return queries;
  std::vector<ScenarioQuery> sample;
  sample.reserve(count);
  for (std::size_t i = 0; i < count; ++i) sample.push_back(queries[i * queries.size() / count]);
  return sample;
}

bool length_matches(const ScenarioQuery& query, double found) {
  const bool fixed = query.decimals == 2 || query.decimals == 8;
  const double half_unit = fixed ? 0.5 * std::pow(10, -query.decimals) : 0;
  return std::abs(found - query.length) <= std::max(1e-5 * query.length, half_unit);
}

}  // namespace wend
