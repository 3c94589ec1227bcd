#include "wend_ros/value_rows.hpp"

#include <algorithm>
#include <cassert>

namespace wend_ros {

Difference difference(const ValueRows& before, const ValueRows& after) {
  assert(before.width() == after.width() && before.height() == after.height());
  Difference found;
  for (int y = 0; y < after.height(); ++y) {
    const auto old_row = before.row(y);
    const auto row = after.row(y);
    if (std::equal(row.begin(), row.end(), old_row.begin())) continue;  // a memcmp
    const auto first = std::mismatch(row.begin(), row.end(), old_row.begin()).first;
    const auto behind = std::mismatch(row.rbegin(), row.rend(), old_row.rbegin()).first.base();
    const auto begin = static_cast<int>(first - row.begin());
    const auto end = static_cast<int>(behind - row.begin());
    found.box = found.box.joined_with({{begin, y}, {end, y + 1}});
    for (auto x = static_cast<std::size_t>(begin); x < static_cast<std::size_t>(end); ++x) {
      found.cells += row[x] != old_row[x] ? 1 : 0;
    }
  }
  return found;
}

}  // namespace wend_ros
