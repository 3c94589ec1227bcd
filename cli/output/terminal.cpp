#include "cli/output/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>
#include <algorithm>
#include <string>

namespace wend::cli {
namespace {

constexpr char kEscape = '\x1b';
constexpr char kEndOfColours = 'm';

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

int columns_of_lines(const std::vector<std::string>& lines) {
  int columns = 0;
  for (const std::string& line : lines) columns = std::max(columns, columns_of(line));
  return columns;
}

void add_beside(std::vector<std::string>& band, const std::vector<std::string>& block, int column) {
  band.resize(std::max(band.size(), block.size()));
  for (std::size_t i = 0; i < block.size(); ++i) {
    band[i].append(static_cast<std::size_t>(column - columns_of(band[i])), ' ');
    band[i] += block[i];
  }
}

/// The characters in columns [begin, end) of a line without colours.
std::string columns_between(std::string_view line, int begin, int end) {
  std::string text;
  int column = -1;
  for (const char letter : line) {
    const bool continues = (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U;
    if (!continues) ++column;
    if (column >= begin && column < end) text += letter;
  }
  return text;
}

}  // namespace

Screen detect_screen() {
  Screen screen;
  screen.is_terminal = isatty(STDOUT_FILENO) != 0;
  if (!screen.is_terminal) return screen;
  screen.terminal = detect_terminal(environ);
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) {
    return screen;
  }
  screen.columns = size.ws_col;
  screen.rows = size.ws_row;
  if (size.ws_xpixel > 0 && size.ws_ypixel > 0) {
    screen.terminal.cell_width = size.ws_xpixel / size.ws_col;
    screen.terminal.cell_height = size.ws_ypixel / size.ws_row;
  }
  return screen;
}

bool has_pixels(const Terminal& terminal) {
  return terminal.graphics == TerminalGraphics::kitty ||
         terminal.graphics == TerminalGraphics::sixel;
}

std::size_t table_width(const Screen& screen) {
  return static_cast<std::size_t>(std::max(screen.columns, kUsualColumns));
}

bool progress_is_seen() { return isatty(STDERR_FILENO) != 0; }

int columns_of(std::string_view line) {
  int columns = 0;
  bool colour = false;
  for (const char letter : line) {
    const bool continues = (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U;
    if (letter == kEscape) colour = true;
    if (!colour && !continues) ++columns;
    if (letter == kEndOfColours) colour = false;
  }
  return columns;
}

std::string folded(std::string_view text, int columns, int indent) {
  std::string result;
  int used = 0;
  for (bool first = true; !text.empty(); first = false) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const int width = columns_of(word);
    if (used > indent && used + 1 + width > columns) {
      result += "\n" + std::string(static_cast<std::size_t>(indent), ' ');
      used = indent;
    } else if (!first) {
      result += ' ';
      ++used;
    }
    result += word;
    used += width;
  }
  return result;
}

std::string folded_grid(std::string_view grid, int columns_a_cell, int columns) {
  const std::vector<std::string> lines = lines_of(grid);
  const int width = columns_of_lines(lines);
  if (width <= columns) return std::string(grid);
  const int cells = (width + 1) / columns_a_cell;  // the first has no blank before it
  const int cells_a_band = std::max(1, (columns + 1) / columns_a_cell);
  std::string text;
  for (int first = 0; first < cells; first += cells_a_band) {
    const int last = std::min(first + cells_a_band, cells) - 1;
    text += "x from " + std::to_string(first) + " to " + std::to_string(last) + "\n";
    for (const std::string& line : lines) {
      text += columns_between(line, first * columns_a_cell, (last + 1) * columns_a_cell - 1) + "\n";
    }
  }
  return text;
}

int rows_on_screen(std::string_view text, int columns) {
  int rows = 0;
  for (const std::string& line : lines_of(text)) {
    rows += std::max(1, (columns_of(line) + columns - 1) / columns);
  }
  return rows;
}

int columns_of_all(std::string_view text) { return columns_of_lines(lines_of(text)); }

std::string side_by_side(const std::vector<std::string>& blocks, int columns) {
  std::vector<std::string> lines;
  std::vector<std::string> band;
  int used = 0;
  for (const std::string& text : blocks) {
    const std::vector<std::string> block = lines_of(text);
    const int width = columns_of_lines(block);
    if (used > 0 && used + kGapBetweenBlocks + width > columns) {
      lines.insert(lines.end(), band.begin(), band.end());
      band.clear();
      used = 0;
    }
    const int column = used == 0 ? 0 : used + kGapBetweenBlocks;
    add_beside(band, block, column);
    used = column + width;
  }
  lines.insert(lines.end(), band.begin(), band.end());
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace wend::cli
