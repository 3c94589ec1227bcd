#pragma once

// CornerCost: what indexes count in, the whole numbers of OctileUnits<std::uint32_t>.

#include <cstdint>
#include <limits>

#include "wend/space/grid/octile_way.hpp"

namespace wend {

using CornerCost = std::uint32_t;

/// More than any cost, and small enough to add two of them.
inline constexpr CornerCost kUnreachedCost = std::numeric_limits<CornerCost>::max() / 2;

}  // namespace wend
