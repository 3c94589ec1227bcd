#include "text_blocks.hpp"

#include <algorithm>

namespace wend::cli {
namespace {

constexpr int kGap = 3;
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

int columns_of_all(const std::vector<std::string>& lines) {
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

}  // namespace

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

std::string side_by_side(const std::vector<std::string>& blocks, int columns) {
  std::vector<std::string> lines;
  std::vector<std::string> band;
  int used = 0;
  for (const std::string& text : blocks) {
    const std::vector<std::string> block = lines_of(text);
    const int width = columns_of_all(block);
    if (used > 0 && used + kGap + width > columns) {
      lines.insert(lines.end(), band.begin(), band.end());
      band.clear();
      used = 0;
    }
    const int column = used == 0 ? 0 : used + kGap;
    add_beside(band, block, column);
    used = column + width;
  }
  lines.insert(lines.end(), band.begin(), band.end());
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace wend::cli
