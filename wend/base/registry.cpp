#include "wend/base/registry.hpp"

#include <algorithm>
#include <numeric>

namespace wend {
namespace {

/// Counts letters inserted, deleted, changed, or swapped with a neighbour (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);  // the row two above
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({changed, row[j - 1] + 1, above[j] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string> closest_name(std::string_view typed,
                                        std::span<const std::string> names) {
  std::optional<std::string> closest;
  std::size_t least = 0;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(typed, name);
    if (3 * distance > std::max(name.size(), typed.size())) continue;
    if (!closest || distance < least) {
      closest = name;
      least = distance;
    }
  }
  return closest;
}

std::string listed(std::span<const std::string> names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return text;
}

std::string suggestion(std::string_view typed, std::span<const std::string> names) {
  if (const auto closest = closest_name(typed, names)) return "did you mean '" + *closest + "'?";
  return "choose from " + listed(names);
}

std::string unknown_name(std::string_view kind, std::string_view typed,
                         std::span<const std::string> names) {
  return "there is no " + std::string(kind) + " '" + std::string(typed) +
         "': " + suggestion(typed, names);
}

}  // namespace wend
