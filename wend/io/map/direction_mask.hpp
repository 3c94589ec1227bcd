#pragma once

// Masks of directions from images: one-way zones, and heights whose slopes cost.

#include <filesystem>

#include "wend/base/expected.hpp"
#include "wend/io/map/load_mask.hpp"

namespace wend {

/// A mask of MaskKind::oneway or height: a map of free cells with directions.
Expected<LoadedMap, Error> load_direction_mask(const std::filesystem::path& file,
                                               const MaskReading& reading);

}  // namespace wend
