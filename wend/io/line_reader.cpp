#include "wend/io/line_reader.hpp"

namespace wend {
namespace {

constexpr std::string_view kBlanks = " \t";

}  // namespace

std::optional<std::string_view> LineReader::next() {
  if (rest_.empty() && pieces_) rest_ = pieces_();
  if (rest_.empty()) return std::nullopt;
  ++number_;
  std::string_view line = rest_of_line();
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Up to the next line end, which may lie in a later piece.
std::string_view LineReader::rest_of_line() {
  std::size_t end = rest_.find('\n');
  const auto take = [this, &end] {
    const std::string_view taken = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    return taken;
  };
  if (end != std::string_view::npos || !pieces_) return take();
  joined_.clear();
  while (end == std::string_view::npos && !rest_.empty()) {
    joined_ += rest_;
    rest_ = pieces_();
    end = rest_.find('\n');
  }
  joined_ += take();
  return joined_;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(kBlanks) == std::string_view::npos;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = line.find_first_of(kBlanks, begin);
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

}  // namespace wend
