#pragma once

// What planning on a map needs of memory, compared with what there is, before it is taken.

#include <optional>
#include <string>

#include "wend/map/grid_map.hpp"

namespace wend::cli {

/// Throws NoPathError with the status memory_limit if more bytes are needed than `available`, where
/// that is known.
void check_memory(const std::string& file, const GridMap& map, double need,
                  std::optional<double> available);

}  // namespace wend::cli
