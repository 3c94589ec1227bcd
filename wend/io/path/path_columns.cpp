#include "wend/io/path/path_columns.hpp"

#include <fmt/format.h>

#include <cmath>

#include "wend/base/parse.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

constexpr std::size_t kLongestHeader = 60;  // in an error
constexpr std::size_t kLongestColumnName = 20;

}  // namespace

PathColumns::PathColumns(std::string_view header, char separator, bool trims)
    : header_(printable(header, kLongestHeader)), separator_(separator), trims_(trims) {
  split(header, names_);
}

Expected<void, std::string> PathColumns::read(std::string_view line) {
  split(line, texts_);
  if (texts_.size() == count()) return {};
  return Unexpected<std::string>(
      fmt::format("{} columns, expected {}: {}", texts_.size(), count(), header_));
}

Expected<void, std::string> PathColumns::check_numbers(std::size_t first) const {
  for (std::size_t i = first; i < count(); ++i) {
    const auto number = parse_number(texts_[i]);
    if (number && std::isfinite(*number)) continue;
    return Unexpected<std::string>(fmt::format("{} must be a finite number, not {}",
                                               printable(names_[i], kLongestColumnName),
                                               quote(texts_[i])));
  }
  return {};
}

void PathColumns::split(std::string_view line, std::vector<std::string_view>& parts) const {
  parts.clear();
  while (true) {
    const std::size_t end = line.find(separator_);
    const std::string_view part = line.substr(0, end);
    parts.push_back(trims_ ? trimmed(part) : part);
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
  }
}

}  // namespace wend
