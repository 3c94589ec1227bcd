#include "wend/io/map/moving_ai_map.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/io/lower_case.hpp"
#include "wend/io/map/drawn_row.hpp"
#include "wend/io/quote.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {
namespace {

constexpr std::string_view kFree = ".GSE";
constexpr std::string_view kOccupiedLetters = "@OTW";

struct Letter {
  bool known = false;
  CellState state = CellState::free;
};

constexpr std::size_t index_of(char letter) { return static_cast<unsigned char>(letter); }

constexpr std::array<Letter, 256> make_letters() {
  std::array<Letter, 256> letters{};
  for (const char letter : kFree) {
    letters[index_of(letter)] = letters[index_of(lower_case(letter))] = {true, CellState::free};
  }
  for (const char letter : kOccupiedLetters) {
    letters[index_of(letter)] = letters[index_of(lower_case(letter))] = {true, CellState::occupied};
  }
  return letters;
}

constexpr std::array<Letter, 256> kLetters = make_letters();

struct Size {
  int height = 0;
  int width = 0;
};

class MovingAiParser {
 public:
  MovingAiParser(LineReader lines, const std::string& file)
      : lines_(std::move(lines)), file_(file) {}

  Expected<LoadedMap, IoError> parse() {
    if (auto good = read_type(); !good) return Unexpected<IoError>(good.error());
    const auto size = read_size();
    if (!size) return Unexpected<IoError>(size.error());
    auto map = read_cells(*size);
    if (!map) return Unexpected<IoError>(map.error());
    return LoadedMap{*std::move(map), MapFormat::moving_ai, notes()};
  }

 private:
  Unexpected<IoError> failure(std::string what) const {
    return io_failure(file_, lines_.number(), std::move(what));
  }

  Expected<void, IoError> read_type() {
    const std::string_view line = lines_.next().value_or("");
    const auto words = words_of(line);
    if (words.size() != 2 || words[0] != "type") {
      return failure(fmt::format("the first line must be 'type octile', not {}", quote(line)));
    }
    if (words[1] != "octile") {
      return failure(
          fmt::format("map type {} is not supported, only 'octile' is", quote(words[1])));
    }
    return {};
  }

  /// Reads up to the line `map`.
  Expected<Size, IoError> read_size() {
    std::optional<int> height;
    std::optional<int> width;
    while (const auto line = lines_.next()) {
      const auto words = words_of(*line);
      if (words.size() == 1 && words[0] == "map") {
        if (!height || !width) return missing(height);
        if (static_cast<std::size_t>(*height) * static_cast<std::size_t>(*width) >
            GridMap::kMaxCells) {
          return failure(fmt::format("{} x {} cells are too many", *width, *height));
        }
        return Size{*height, *width};
      }
      if (words.size() != 2 || (words[0] != "height" && words[0] != "width")) {
        return failure(fmt::format(
            "unexpected header line {}: 'height', 'width' or 'map' belongs here", quote(*line)));
      }
      std::optional<int>& value = words[0] == "height" ? height : width;
      if (value) return failure(fmt::format("duplicate '{}'", words[0]));
      const auto number = read_extent(words[0], words[1]);
      if (!number) return Unexpected<IoError>(number.error());
      value = *number;
    }
    if (height && width) return failure("the header has no line 'map'");
    return missing(height);
  }

  Unexpected<IoError> missing(std::optional<int> height) const {
    return failure(fmt::format("'{}' is missing in the header", height ? "width" : "height"));
  }

  Expected<int, IoError> read_extent(std::string_view name, std::string_view text) const {
    const bool digits = text.find_first_not_of("0123456789") == std::string_view::npos;
    const auto value = parse_integer<int>(text);
    if (digits && !value) return failure(fmt::format("{} {} is out of range", name, quote(text)));
    if (!value) return failure(fmt::format("{} {} is not a whole number", name, quote(text)));
    if (*value <= 0) return failure(fmt::format("{} must be positive, not {}", name, *value));
    return *value;
  }

  Expected<GridMap, IoError> read_cells(Size size) {
    GridMapBuilder rows(size.width);
    const auto cells = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    if (cells <= lines_.size()) rows.reserve(size.height);
    std::vector<CellState> states(static_cast<std::size_t>(size.width));
    for (int y = 0; y < size.height; ++y) {
      const auto row = lines_.next();
      if (!row) return failure(fmt::format("{} rows, the header says {}", y, size.height));
      const std::string wrong = read_row(*row, y, states);
      if (!wrong.empty()) return failure(wrong);
      rows.append(states);
    }
    while (const auto line = lines_.next()) {
      if (!is_blank(*line)) {
        return failure(fmt::format("a row too many, the header says {}", size.height));
      }
    }
    return std::move(rows).finish();
  }

  /// What is wrong with the row, empty if nothing is.
  std::string read_row(std::string_view letters, int y, std::vector<CellState>& states) {
    if (letters.size() != states.size()) {
      return fmt::format("row {} has {} columns, the header says {}", y, letters.size(),
                         states.size());
    }
    for (std::size_t x = 0; x < letters.size(); ++x) {
      const Letter letter = kLetters[index_of(letters[x])];
      if (!letter.known) {
        return fmt::format("unknown terrain letter {} at row {} column {}", quote(letters[x]), y,
                           x);
      }
      states[x] = letter.state;
      seen_[index_of(letters[x])] = true;
    }
    return {};
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    if (seen_[index_of('E')] || seen_[index_of('e')]) {
      notes.emplace_back("terrain E (emitter) is read as free");
    }
    for (char letter = 'a'; letter <= 'z'; ++letter) {
      if (seen_[index_of(letter)]) {
        notes.emplace_back("lower-case letters are read as upper-case ones");
        break;
      }
    }
    return notes;
  }

  LineReader lines_;
  const std::string& file_;
  std::array<bool, 256> seen_{};
};

}  // namespace

Expected<LoadedMap, IoError> parse_moving_ai_map(LineReader lines, const std::string& file) {
  return MovingAiParser(std::move(lines), file).parse();
}

Expected<std::string, std::string> format_moving_ai_map(const GridMap& map) {
  if (const std::size_t unknown = map.unknown().count(); unknown > 0) {
    return Unexpected<std::string>(
        fmt::format("a MovingAI map cannot hold {} unknown cells", unknown));
  }
  if (!map.uniform_terrain()) {
    return Unexpected<std::string>("a MovingAI map cannot hold terrain");
  }
  std::string text =
      fmt::format("type octile\nheight {}\nwidth {}\nmap\n", map.height(), map.width());
  text.reserve(text.size() + map.size() + static_cast<std::size_t>(map.height()));
  for (int from_top = 0; from_top < map.height(); ++from_top) {
    const int y = drawn_row(from_top, map.height(), map.frame().y_up);
    for (int x = 0; x < map.width(); ++x) text += map.occupied()[{x, y}] ? '@' : '.';
    text += '\n';
  }
  return text;
}

}  // namespace wend
