#pragma once

// Doubts: sentences about what is legal in a map file, but probably not meant. They are notes of the map that was read.

#include <string>
#include <vector>

#include "wend/geometry/frame.hpp"
#include "wend/io/map/image_map.hpp"

namespace wend {

/// A yaw that can only be degrees, and a resolution that can only be another unit than metres.
std::vector<std::string> doubts_about(const Frame& frame);

/// An image that is almost black because its values are of fewer bits, the unknown grey of map savers where it is not
/// unknown, and thresholds by which no cell is free or none is occupied. `map` is what `rows` became.
std::vector<std::string> doubts_about(const ImageMapRows& rows, const ImageMeaning& meaning,
                                      const GridMap& map);

}  // namespace wend
