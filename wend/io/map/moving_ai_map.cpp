// MovingAI `.map` files, the format of the usual grid benchmarks.
//
//   type octile
//   height 2
//   width 3
//   map
//   ..@
//   .GT
//
// Row 0 is the top row, one letter a cell, LF or CRLF line ends. `. G S` are free, `@ O T W`
// occupied; every cell costs the same. `E` (an emitter on the warehouse maps of the League of
// Robot Runners) is free, and lower-case letters are read as upper-case ones; both get a note.
// The header's two sizes may come in either order. Other types (`tile`, `patch`, `octile-corner`)
// are other formats and are rejected by name.

#include <fmt/format.h>
#include <cassert>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "wend/base/parse.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/map/byte_bits.hpp"

namespace wend {
namespace {

// What a letter says: a CellState, or kUnknownLetter, and whether it gets a note.
using LetterMeaning = unsigned char;
constexpr LetterMeaning kStateMask = 3;
constexpr LetterMeaning kUnknownLetter = 4;
constexpr LetterMeaning kEmitter = 8;
constexpr LetterMeaning kLowerCase = 16;

constexpr std::size_t index_of(char letter) { return static_cast<unsigned char>(letter); }

constexpr std::array<LetterMeaning, 256> make_letters() {
  std::array<LetterMeaning, 256> letters{};
  letters.fill(kUnknownLetter);
  for (const char letter : std::string_view(".GSE@OTW")) {
    const bool free = std::string_view(".GSE").find(letter) != std::string_view::npos;
    const CellState state = free ? CellState::free : CellState::occupied;
    auto meaning = static_cast<LetterMeaning>(state);
    if (letter == 'E') meaning |= kEmitter;
    letters[index_of(letter)] = meaning;
    if (lower_case(letter) == letter) continue;
    letters[index_of(lower_case(letter))] = static_cast<LetterMeaning>(meaning | kLowerCase);
  }
  return letters;
}

constexpr std::array<LetterMeaning, 256> kLetters = make_letters();

Answers is_free_letter(Bytes letters) {
  return (letters == '.') | (letters == 'G') | (letters == 'S');
}
Answers is_occupied_letter(Bytes letters) {
  return (letters == '@') | (letters == 'T') | (letters == 'O') | (letters == 'W');
}

class MovingAiReader {
 public:
  MovingAiReader(LineReader lines, const std::string& file)
      : lines_(std::move(lines)), file_(file) {}

  Expected<LoadedMap, Error> read() {
    for (const auto step : {&MovingAiReader::read_type, &MovingAiReader::read_sizes,
                            &MovingAiReader::check_sizes, &MovingAiReader::read_rows}) {
      if (const std::string wrong = (this->*step)(); !wrong.empty()) {
        return file_failure(file_, lines_.number(), wrong);
      }
    }
    assert(rows_);
    return LoadedMap{*std::move(*rows_).finish(), MapFormat::moving_ai_map, notes()};
  }

 private:
  // Each step returns an error text, empty on success.

  std::string read_type() {
    const std::string_view line = lines_.next().value_or("");
    const auto words = words_of(line);
    if (words.size() != 2 || words[0] != "type") {
      return fmt::format("the first line must be 'type octile', not {}", quote(line));
    }
    if (words[1] == "octile") return {};
    return fmt::format("map type {} is not supported, only 'octile' is", quote(words[1]));
  }

  /// Reads up to the line `map`.
  std::string read_sizes() {
    while (const auto line = lines_.next()) {
      const auto words = words_of(*line);
      if (words.size() == 1 && words[0] == "map") return {};
      if (words.size() != 2 || (words[0] != "height" && words[0] != "width")) {
        return fmt::format("unexpected header line {}: expected 'height', 'width' or 'map'",
                           quote(*line));
      }
      int& size = words[0] == "height" ? height_ : width_;
      if (size != 0) return fmt::format("duplicate '{}'", words[0]);
      if (std::string wrong = read_size(words[0], words[1], size); !wrong.empty()) return wrong;
    }
    const std::string wrong = check_sizes();
    return wrong.empty() ? "the header has no line 'map'" : wrong;
  }

  static std::string read_size(std::string_view name, std::string_view text, int& size) {
    const bool digits = text.find_first_not_of("0123456789") == std::string_view::npos;
    const auto value = parse_integer<int>(text);
    if (digits && !value) return fmt::format("{} {} is out of range", name, quote(text));
    if (!value) return fmt::format("{} {} is not a whole number", name, quote(text));
    if (*value <= 0) return fmt::format("{} must be positive, not {}", name, *value);
    size = *value;
    return {};
  }

  std::string check_sizes() {
    if (height_ == 0 || width_ == 0) {
      return fmt::format("the header has no line '{}'", height_ == 0 ? "height" : "width");
    }
    if (cells() <= GridMap::kMaxCells) return {};
    return fmt::format("{} x {} cells are too many, the limit is {}", width_, height_,
                       GridMap::kMaxCells);
  }

  std::size_t cells() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }

  std::string declared_rows() const {
    return fmt::format("the {} row{} that the header declares", height_, height_ == 1 ? "" : "s");
  }

  std::string read_rows() {
    GridMapBuilder& rows = rows_.emplace(width_);
    if (cells() <= lines_.size()) rows.reserve(height_);
    for (int y = 0; y < height_; ++y) {
      const auto row = lines_.next();
      if (!row) return fmt::format("only {} of {}", y, declared_rows());
      if (std::string wrong = read_row(*row, y, rows.append_free()); !wrong.empty()) return wrong;
    }
    while (const auto line = lines_.next()) {
      if (is_blank(*line)) continue;
      return fmt::format("extra row after {}", declared_rows());
    }
    return {};
  }

  std::string read_row(std::string_view letters, int y, std::span<std::uint64_t> words) {
    if (letters.size() != static_cast<std::size_t>(width_)) {
      return fmt::format("row {} has {} columns, the header declares {}", y, letters.size(),
                         width_);
    }
    std::string wrong;
    const auto read_block = [&](std::size_t x, const unsigned char* block) {
      std::uint64_t occupied = bits_of(block, is_occupied_letter);
      const std::uint64_t others = ~(occupied | bits_of(block, is_free_letter));
      for (std::uint64_t rest = others; rest != 0 && wrong.empty(); rest &= rest - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        const LetterMeaning meaning = kLetters[block[i]];
        seen_ |= meaning;
        occupied |= static_cast<std::uint64_t>(meaning & kStateMask) << i;
        if ((meaning & kUnknownLetter) == 0) continue;
        wrong = fmt::format("unknown terrain letter {} at row {} column {}", quote(letters[x + i]),
                            y, x + i);
      }
      set_block(words, x, occupied);
    };
    for_each_block({reinterpret_cast<const unsigned char*>(letters.data()), letters.size()}, '.',
                   read_block);
    return wrong;
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    if ((seen_ & kEmitter) != 0) {
      notes.emplace_back("terrain E (emitter) is read as free");
    }
    if ((seen_ & kLowerCase) != 0) {
      notes.emplace_back("lower-case letters are read as upper-case ones");
    }
    return notes;
  }

  LineReader lines_;
  const std::string& file_;
  int height_ = 0;  // 0: not read yet
  int width_ = 0;
  std::optional<GridMapBuilder> rows_;
  LetterMeaning seen_ = 0;  // in the letters so far
};

/// Takes linear time and the memory of the map.
Expected<LoadedMap, Error> load_moving_ai_map(LineReader lines, const std::string& file) {
  return MovingAiReader(std::move(lines), file).read();
}

Expected<MapFiles, Error> save_moving_ai_map(const GridMap& map, const std::filesystem::path&) {
  std::string text =
      fmt::format("type octile\nheight {}\nwidth {}\nmap\n", map.height(), map.width());
  text.reserve(text.size() + map.size() + static_cast<std::size_t>(map.height()));
  for (const int y : rows_from_top(map)) {
    for (int x = 0; x < map.width(); ++x) text += map.occupied()[{x, y}] ? '@' : '.';
    text += '\n';
  }
  return MapFiles{std::move(text)};
}

}  // namespace

MapFormatInfo moving_ai_map_format() {
  return {.format = MapFormat::moving_ai_map,
          .name = "MovingAI",
          .noun = "a MovingAI map",
          .extensions = {".map"},
          .saved_extensions = {".map"},
          .holds_unknown_cells = false,
          .recognises = [](std::string_view bytes) { return bytes.starts_with("type "); },
          .load_lines = load_moving_ai_map,
          .save = save_moving_ai_map};
}

}  // namespace wend
