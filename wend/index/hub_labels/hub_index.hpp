#pragma once

// The label index of a map: it looks up the cheapest path between any two cells.
//
// Idea. Shortest paths turn at corners (corner_graph.hpp). Every corner has a label: some hubs, with
// the exact costs of the ways to them, so that the shortest way between two corners passes a hub of
// both (hub_labelling.hpp). The cells of a component may all turn first at the same corners; a record
// keeps which hubs they reach by which of these (component_hubs.hpp). A query reads two records, looks
// for the hub with the least sum, and reads the way there and back off as runs (heavy_paths.hpp).
//
// Why the answer is the shortest. Let first(s) be the corners at which ways from s may turn first. A
// path drawn from t, diagonal steps first, turns first at a c of first(t), or does not turn: then t
// sees s. Its rest from s to c, drawn from s, turns first at an a of first(s), or s sees c. So the
// cost is the least of three terms: octile(s, t) if one sees the other; d(s, a) + d(a, c) + d(c, t),
// where d(a, c) is the least sum over common hubs; d(s, c) + d(c, t) for a c that s sees. The third
// is left out where s or t is a corner, which stands for itself (first_corners.hpp). Hubs that a
// component leaves out are not missed: let h be the most important hub with the least sum for s and t.
// If s could do without it, a more important one g lies on the way from s to h, at no more cost; then
// the way from s by g and h to t is a shortest one, so the most important hub on its part between
// corners, which is g or one yet more important, has the least sum too. (For boards of up to a
// million cells a query takes 0.2 to 2 us, its path included.)
//
// Limits: 32767 rows and columns; no way to a hub may be longer than some 23,000 cells.

#include <memory>
#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/index/index_engine.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

inline constexpr std::string_view kHubLabels = "hub_labels";

/// Builds the index of the passable cells; cancelled or unsupported_map. The same bytes
/// whatever the workers.
Expected<IndexBytes, IndexError> build_hub_index(const BitGrid& passable,
                                                 const IndexBuilding& building);

/// An engine for an index of these cells, or what is wrong with the index. O(bytes).
Expected<std::unique_ptr<IndexEngine>, std::string> open_hub_index(IndexBytes index,
                                                                   const BitGrid& passable);

}  // namespace wend
