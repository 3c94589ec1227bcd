#pragma once

// How state spaces and searches name states and moves, without knowing each other.

#include <cstdint>

namespace wend {

/// States of a space are numbered from 0 without gaps.
using StateId = std::uint32_t;

/// How a state was reached: the number of a move of its space, below kNoMove.
using Move = std::uint8_t;
inline constexpr unsigned kMoveBits = 4;                // a move takes this many bits of a node
inline constexpr Move kNoMove = (1U << kMoveBits) - 1;  // for a start

}  // namespace wend
