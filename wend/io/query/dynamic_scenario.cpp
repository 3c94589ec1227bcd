#include "wend/io/query/dynamic_scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/io/files.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPatches = 1'000'000;

/// Reads a file line by line and keeps the first error.
class FileParser {
 public:
  FileParser(std::string_view text, std::string file) : lines_(text), file_(std::move(file)) {}

  /// The next line that is not blank, as words; empty at the end and after an error.
  std::vector<std::string_view> words() {
    while (!error_) {
      const auto line = lines_.next();
      if (!line) break;
      if (!is_blank(*line)) return words_of(*line);
    }
    return {};
  }

  /// The next line as it is.
  std::string_view row() {
    if (error_) return {};
    const auto line = lines_.next();
    if (!line) fail("the file ends in the middle of a patch");
    return line.value_or("");
  }

  /// The value of a line "<key> <value>".
  std::string_view value_of(std::string_view key) {
    const auto line = words();
    if (!error_ && (line.size() != 2 || line[0] != key)) {
      fail(fmt::format("expected '{} ...'", key));
    }
    return error_ ? std::string_view() : line[1];
  }

  /// The same as a whole number within limits.
  int number_of(std::string_view key, int least, int most) {
    return number_in(value_of(key), key, least, most);
  }

  int number_in(std::string_view text, std::string_view name, int least, int most) {
    if (error_) return least;
    const auto value = parse_integer<int>(text);
    if (value && *value >= least && *value <= most) return *value;
    fail(fmt::format("{} {} is not a whole number from {} to {}", name, quote(text), least, most));
    return least;
  }

  void expect(std::string_view text) {
    const auto line = words();
    if (error_) return;
    const auto wanted = words_of(text);
    if (line != wanted) fail(fmt::format("expected '{}'", text));
  }

  void fail(const std::string& what) {
    if (!error_) error_ = file_error(file_, lines_.number(), what);
  }

  const std::optional<Error>& error() const { return error_; }
  std::size_t line() const { return lines_.number(); }
  std::size_t bytes_left() const { return lines_.size(); }

 private:
  LineReader lines_;
  std::string file_;
  std::optional<Error> error_;
};

bool is_passable(char letter) { return letter == '.' || letter == 'G' || letter == 'S'; }

/// A patch of the map's size at most.
Grid<CellState> read_patch(FileParser& parser, const DynamicScenario& scenario) {
  const int height = parser.number_of("height", 1, scenario.height);
  const int width = parser.number_of("width", 1, scenario.width);
  parser.expect("map");
  if (parser.error()) return {};
  // Before there is memory for them, the file must be able to have so many letters.
  if (static_cast<std::size_t>(height) * static_cast<std::size_t>(width) > parser.bytes_left()) {
    parser.fail("the file is too short for a patch of this size");
    return {};
  }
  Grid<CellState> patch(width, height, CellState::free);
  for (int y = 0; y < height && !parser.error(); ++y) {
    const std::string_view row = parser.row();
    if (!parser.error() && row.size() != static_cast<std::size_t>(width)) {
      parser.fail(fmt::format("the row has {} letters, the patch is {} wide", row.size(), width));
    }
    for (int x = 0; x < width && !parser.error(); ++x) {
      if (!is_passable(row[static_cast<std::size_t>(x)])) patch[{x, y}] = CellState::occupied;
    }
  }
  return patch;
}

std::optional<Error> read_patches(std::string_view text, const std::string& file,
                                  DynamicScenario& scenario) {
  FileParser parser(text, file);
  parser.expect("type patch");
  const int count = parser.number_of("patches", 0, static_cast<int>(kMostPatches));
  for (int i = 0; i < count && !parser.error(); ++i) {
    parser.expect(fmt::format("patch {}", i));
    scenario.patches.push_back(read_patch(parser, scenario));
  }
  return parser.error();
}

Cell cell_in(FileParser& parser, const DynamicScenario& scenario,
             const std::vector<std::string_view>& words, std::size_t at) {
  return {parser.number_in(words[at], "x", 0, scenario.width - 1),
          parser.number_in(words[at + 1], "y", 0, scenario.height - 1)};
}

int decimals_of(std::string_view number) {
  const std::size_t point = number.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(number.size() - point - 1);
}

ScenarioQuery query_of(FileParser& parser, const DynamicScenario& scenario,
                       const std::vector<std::string_view>& words) {
  ScenarioQuery query{};
  query.line = parser.line();
  query.bucket = parser.number_in(words[1], "bucket", 0, std::numeric_limits<int>::max());
  query.map_width = scenario.width;
  query.map_height = scenario.height;
  query.start = cell_in(parser, scenario, words, 2);
  query.goal = cell_in(parser, scenario, words, 4);
  query.length = parse_number(words[6]).value_or(-1);
  query.decimals = decimals_of(words[6]);
  if (!std::isfinite(query.length) || query.length < 0) {
    parser.fail(fmt::format("the length must be finite and at least 0, not {}", quote(words[6])));
  }
  return query;
}

PatchCommand patch_of(FileParser& parser, const DynamicScenario& scenario,
                      const std::vector<std::string_view>& words) {
  const int last = static_cast<int>(scenario.patches.size()) - 1;
  if (last < 0) parser.fail("the patch file has no patches");
  const auto number =
      static_cast<std::size_t>(parser.number_in(words[2], "patch", 0, std::max(last, 0)));
  const Cell corner = cell_in(parser, scenario, words, 3);
  if (parser.error()) return {};
  const Grid<CellState>& patch = scenario.patches[number];
  if (corner.x + patch.width() > scenario.width || corner.y + patch.height() > scenario.height) {
    parser.fail(fmt::format("patch {} of {} x {} cells at ({},{}) reaches over the map of {} x {}",
                            number, patch.width(), patch.height(), corner.x, corner.y,
                            scenario.width, scenario.height));
  }
  return {number, corner};
}

void read_commands(FileParser& parser, DynamicScenario& scenario) {
  for (;;) {
    const auto words = parser.words();
    if (words.empty()) return;
    if (words[0] == "Q" && words.size() == 7) {
      scenario.commands.emplace_back(query_of(parser, scenario, words));
    } else if (words[0] == "P" && words.size() == 5) {
      scenario.commands.emplace_back(patch_of(parser, scenario, words));
    } else {
      parser.fail(
          "expected 'Q bucket start-x start-y goal-x goal-y length' or 'P bucket patch x y'");
    }
  }
}

}  // namespace

bool is_dynamic_scenario(std::string_view text) {
  const auto words = words_of(LineReader(text).next().value_or(""));
  return words.size() == 2 && words[0] == "version" && words[1] == "2";
}

Expected<DynamicScenario, Error> parse_dynamic_scenario(
    std::string_view text, const std::string& file,
    const std::function<Expected<std::string, Error>(const fs::path&)>& read) {
  constexpr int kLongest = 1 << 20;
  FileParser parser(text, file);
  DynamicScenario scenario{.file = file, .patch_file = {}, .patches = {}, .commands = {}};
  parser.expect("version 2");
  scenario.height = parser.number_of("height", 1, kLongest);
  scenario.width = parser.number_of("width", 1, kLongest);
  if (static_cast<std::size_t>(scenario.height) * static_cast<std::size_t>(scenario.width) >
      kMostDynamicCells) {
    parser.fail(fmt::format("the map has more than {} cells", kMostDynamicCells));
  }
  parser.expect("cost 1 octile");
  const std::string patches(parser.value_of("patch"));
  scenario.patch_file = patches;
  if (scenario.patch_file.filename() != scenario.patch_file || patches == "." || patches == "..") {
    parser.fail(fmt::format("the patch file {} must lie in the same folder", quote(patches)));
  }
  parser.expect("commands");
  if (parser.error()) return Unexpected<Error>(*parser.error());
  const auto patch_text = read(scenario.patch_file);
  if (!patch_text) return Unexpected<Error>(patch_text.error());
  if (auto wrong = read_patches(*patch_text, patches, scenario)) return Unexpected<Error>(*wrong);
  read_commands(parser, scenario);
  if (parser.error()) return Unexpected<Error>(*parser.error());
  return scenario;
}

Expected<DynamicScenario, Error> load_dynamic_scenario(const fs::path& file) {
  const auto text = read_file(file);
  if (!text) return Unexpected<Error>(text.error());
  return parse_dynamic_scenario(*text, file.string(), [&](const fs::path& patches) {
    return read_file(file.parent_path() / patches);
  });
}

}  // namespace wend
