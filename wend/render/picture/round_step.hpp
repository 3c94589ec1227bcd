#pragma once

// Round steps: how many corners of a lattice share one number on an axis.

namespace wend {

/// The least of 1, 2, 5, 10, 20, 50, 100 ... that is not less; at most 10^9.
int round_step(double least);

}  // namespace wend
