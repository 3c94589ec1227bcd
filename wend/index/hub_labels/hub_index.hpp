#pragma once

// The label index of a map: it looks up the cheapest path between any two cells.
//
// Idea. Shortest paths turn at corners (corner_graph.hpp). Every corner has a label: some hubs and the
// exact costs of the paths to them. Between any two corners, a shortest path passes a hub of both labels
// (hub_labelling.hpp). The cells of a component may all turn first at the same corners; a record stores
// which hubs they reach by which of these corners (hub_labelling.hpp). A query reads two records, finds
// the common hub with the least sum, and reads the paths to it and from it as runs (hub_sections.hpp).
//
// Why the path is shortest. Let first(s) be the corners at which paths from s may turn first. Draw a
// shortest path from t, diagonal steps first. It turns first at a c of first(t), or it does not turn:
// then t sees s. Draw the rest between s and c from s: it turns first at an a of first(s), or s sees c.
// So the cost is the least of three terms: octile(s, t) if one sees the other; d(s, a) + d(a, c) +
// d(c, t), where d(a, c) is the least sum over common hubs; d(s, c) + d(c, t) for a c that s sees. The
// third term is not needed where s or t is a corner, which stands for itself (first_corners.hpp). The
// hubs that a component omits are not missed: let h be the most important hub with the least sum for s
// and t. If s does not need h, a more important hub g lies on a path from s to h of no greater cost.
// Then the path from s by g and h to t is a shortest path, so the most important hub on its part between
// corners, which is g or an even more important one, has the least sum too. (For boards of up to a
// million cells a query takes 0.2 to 2 us, its path included.)
//
// Limits: 32767 rows and columns; no path to a hub may be longer than about 23,000 cells.

#include <memory>
#include <string>
#include <string_view>

#include "wend/base/error.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/index/index_engine.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

inline constexpr std::string_view kHubLabels = "hub_labels";

/// Builds the index of the passable cells. Errors: cancelled or unsupported_map. The bytes do not depend
/// on the workers.
Expected<IndexBytes, Error> build_hub_index(const BitGrid& passable, const IndexBuilding& building);

/// An engine for an index of these cells, or what is wrong with the index. O(bytes).
Expected<std::unique_ptr<IndexEngine>, Error> open_hub_index(IndexBytes index,
                                                             const BitGrid& passable);

}  // namespace wend
