#include "wend/path/gears.hpp"

namespace wend {

std::vector<int> gears_of(const Path& path) {
  std::vector<int> gears;
  for (const Segment& segment : path.segments()) gears.push_back(gear_of(segment));
  return gears;
}

}  // namespace wend
