#include "wend/index/corner_hierarchy/corner_hierarchy.hpp"

#include <cassert>
#include <limits>
#include <optional>

#include "wend/index/corner_hierarchy/hierarchy_search.hpp"
#include "wend/index/file/index_sections.hpp"
#include "wend/index/run_writer.hpp"
#include "wend/map/connected_components.hpp"
#include "wend/search/min_heap.hpp"

namespace wend {
namespace {

constexpr std::string_view kPlanner = "corner_hierarchy";
constexpr std::uint32_t kVersion = 1;
constexpr unsigned kUnorderedBits = 15;  // nearly a straight step

enum Section : std::size_t {
  core_begin,
  heights,
  nodes,
  arcs,
  vias,
  section_count,
};

std::vector<GraphArc> arcs_of(const Turns& turns, const IndexBuilding& building) {
  std::vector<GraphArc> arcs;
  for (std::uint32_t turn = 0; turn < turns.size() && !building.cancelled(); ++turn) {
    turns.for_each_next(
        turn, [&](std::uint32_t next, CornerCost cost) { arcs.push_back({turn, next, cost}); });
  }
  return arcs;
}

/// The arrays that are read in place from a file.
struct StoredHierarchy {
  std::span<const std::uint32_t> heights;
  ContractionHierarchy hierarchy;
};

template <class T>
bool read(const IndexReader& reader, Section number, std::span<const T>& out) {
  const auto section = reader.section<T>(number);
  if (section) out = *section;
  return section.has_value();
}

std::optional<StoredHierarchy> read_hierarchy(const IndexReader& reader) {
  StoredHierarchy stored;
  std::span<const std::uint32_t> core;
  ContractionHierarchy& hierarchy = stored.hierarchy;
  const bool all = reader.sections() == section_count && read(reader, core_begin, core) &&
                   read(reader, heights, stored.heights) && read(reader, nodes, hierarchy.nodes) &&
                   read(reader, arcs, hierarchy.arcs) && read(reader, vias, hierarchy.vias);
  if (!all || core.size() != 1) return std::nullopt;
  hierarchy.core_begin = core.front();
  return stored;
}

/// The cells of the turns by height; nullopt if the heights are not a permutation of the turns.
std::optional<std::vector<Cell>> cells_by_height(const Turns& turns,
                                                 std::span<const std::uint32_t> heights) {
  constexpr Cell kNowhere{-1, -1};
  if (heights.size() != turns.size()) return std::nullopt;
  std::vector<Cell> cells(heights.size(), kNowhere);
  for (std::uint32_t turn = 0; turn < turns.size(); ++turn) {
    if (heights[turn] >= cells.size() || cells[heights[turn]] != kNowhere) return std::nullopt;
    cells[heights[turn]] = turns.cell(turn);
  }
  return cells;
}

/// Do shortcuts cost at least the octile distance between their cells, and arcs of the graph exactly
/// that?
bool costs_fit(const ContractionHierarchy& hierarchy, std::span<const Cell> cells) {
  for (std::uint32_t node = 0; node < hierarchy.size(); ++node) {
    const std::uint32_t end = hierarchy.nodes[node + 1].leaving;
    for (std::uint32_t number = hierarchy.nodes[node].leaving; number < end; ++number) {
      const HierarchyArc& arc = hierarchy.arcs[number];
      const auto least = octile_cost<CornerCost>(cells[node], cells[arc.node]);
      const bool fits = hierarchy.vias[number].shortcut() ? arc.cost >= least : arc.cost == least;
      if (!fits) return false;
    }
  }
  return true;
}

class CornerHierarchyEngine final : public IndexEngine {
 public:
  CornerHierarchyEngine(IndexReader reader, Turns turns, const StoredHierarchy& stored,
                        std::vector<Cell> cells)
      : reader_(std::move(reader)),
        turns_(std::move(turns)),
        heights_(stored.heights),
        cells_(std::move(cells)),
        search_(stored.hierarchy, kUnorderedBits) {}

  OctileSteps find(Cell start, Cell goal) override {
    metrics_ = {1, 1, 1};
    if (turns_.sees(start, goal)) {
      path_.begin(start);
    } else if (turns_.sees(goal, start)) {
      path_.begin(start);
      path_.append(octile_bend(goal, start));
    } else {
      search(start, goal);
    }
    path_.append(goal);
    return path_.steps();
  }

  void write(std::span<Cell> cells) override { path_.write(cells); }

  SearchMetrics metrics() const override { return metrics_; }

 private:
  void search(Cell start, Cell goal) {
    starts_.clear();
    goals_.clear();
    turns_.for_each_first(start, [&](const TurnChoice& choice, CornerCost cost) {
      starts_.add(choice, {cost, cost + octile_cost<CornerCost>(choice.cell, goal)});
    });
    turns_.for_each_last(goal, [&](const TurnChoice& choice, CornerCost cost) {
      goals_.add(choice, {cost, cost + octile_cost<CornerCost>(choice.cell, start)});
    });
    const CornerCost cost = search_.find(starts_.ends, goals_.ends, HierarchySearch::kNoCost,
                                         OctileQuery{*this, start, goal});
    assert(cost < HierarchySearch::kNoCost);  // they are connected
    metrics_ = search_.metrics();
    nodes_.clear();
    path_.begin(start);
    if (cost < HierarchySearch::kNoCost) search_.append_nodes(nodes_);
    for (const std::uint32_t node : nodes_) path_.append(cells_[node]);
  }

  /// Where the paths of a query turn first, or last.
  struct Ends {
    std::vector<TurnChoice> choices;
    std::vector<HierarchyEnd> ends;

    void clear() {
      choices.clear();
      ends.clear();
    }
    void add(const TurnChoice& choice, const HierarchyEnd& end) {
      choices.push_back(choice);
      ends.push_back(end);
    }
  };

  struct OctileQuery {
    const CornerHierarchyEngine& engine;
    Cell start;
    Cell goal;

    CornerCost to_start(std::uint32_t node) const {
      return octile_cost<CornerCost>(engine.cells_[node], start);
    }
    CornerCost to_goal(std::uint32_t node) const {
      return octile_cost<CornerCost>(engine.cells_[node], goal);
    }

    template <class Visit>
    void for_each_start(std::uint32_t i, Visit&& visit) const {
      engine.for_each_node(engine.starts_.choices[i], visit);
    }
    template <class Visit>
    void for_each_goal(std::uint32_t i, Visit&& visit) const {
      engine.for_each_node(engine.goals_.choices[i], visit);
    }
  };

  template <class Visit>
  void for_each_node(const TurnChoice& choice, Visit&& visit) const {
    turns_.for_each_of(choice, [&](std::uint32_t turn) { visit(heights_[turn]); });
  }

  IndexReader reader_;  // owns the memory of the spans
  Turns turns_;
  std::span<const std::uint32_t> heights_;  // by turn
  std::vector<Cell> cells_;                 // by height
  HierarchySearch search_;
  Ends starts_;
  Ends goals_;
  std::vector<std::uint32_t> nodes_;
  LegPath path_;
  SearchMetrics metrics_;
};

constexpr std::uint64_t kMost = std::numeric_limits<HierarchyCost>::max();
constexpr std::uint64_t kUnreached = std::numeric_limits<std::uint64_t>::max();

struct Entry {
  std::uint64_t cost;
  std::uint32_t turn;

  friend bool operator<(const Entry& a, const Entry& b) { return a.cost < b.cost; }
};

/// Dijkstra's algorithm over the turns, from a cell.
class Spread {
 public:
  Spread(const Turns& turns, std::span<const GraphArc> arcs)
      : turns_(turns), arcs_(arcs), costs_(turns.size(), kUnreached), begins_(turns.size() + 1) {
    for (const GraphArc& arc : arcs) ++begins_[arc.tail + 1];
    for (std::uint32_t turn = 0; turn < turns.size(); ++turn) begins_[turn + 1] += begins_[turn];
  }

  /// The cost of the farthest turn.
  std::uint64_t from(Cell cell) {
    turns_.for_each_first(cell, [&](const TurnChoice& choice, CornerCost cost) {
      turns_.for_each_of(choice, [&](std::uint32_t turn) { reach(turn, cost); });
    });
    std::uint64_t farthest = 0;
    while (!queue_.empty()) {
      const Entry least = min_heap::pop(queue_);
      if (least.cost > costs_[least.turn]) continue;
      farthest = least.cost;
      for (std::uint32_t arc = begins_[least.turn]; arc < begins_[least.turn + 1]; ++arc) {
        reach(arcs_[arc].head, least.cost + arcs_[arc].cost);
      }
    }
    return farthest;
  }

 private:
  void reach(std::uint32_t turn, std::uint64_t cost) {
    if (cost >= costs_[turn]) return;
    costs_[turn] = cost;
    min_heap::push(queue_, {cost, turn});
  }

  const Turns& turns_;
  std::span<const GraphArc> arcs_;  // in the order of their tails
  std::vector<std::uint64_t> costs_;
  std::vector<std::uint32_t> begins_;
  std::vector<Entry> queue_;
};

}  // namespace

bool paths_may_be_too_long(const Turns& turns, std::span<const GraphArc> arcs) {
  using Units = OctileUnits<CornerCost>;
  const auto width = static_cast<std::uint64_t>(turns.passable().width());
  const auto height = static_cast<std::uint64_t>(turns.passable().height());
  if (width * height * Units::kDiagonal < kMost) return false;
  const std::uint64_t longest_leg = (width + height) * Units::kStraight;
  Spread spread(turns, arcs);
  const ConnectedComponents components(turns.passable());
  std::vector<bool> measured(turns.passable().count() + 1);
  for (std::uint32_t turn = 0; turn < turns.size(); ++turn) {
    const std::uint32_t component = components.component(turns.cell(turn), Adjacency::edges);
    if (measured[component]) continue;
    measured[component] = true;
    const std::uint64_t farthest = spread.from(turns.cell(turn)) + longest_leg;
    if (2 * farthest >= kMost) return true;
  }
  return longest_leg >= kMost;  // for paths without turns
}

Expected<IndexBytes, Error> build_corner_hierarchy(const BitGrid& passable,
                                                   const IndexBuilding& building,
                                                   const ContractionEffort& effort) {
  const Turns turns(passable, building);
  const std::vector<GraphArc> arcs = arcs_of(turns, building);
  if (building.cancelled()) return failure(Status::cancelled, "the index was not finished");
  if (paths_may_be_too_long(turns, arcs)) {
    return failure(Status::unsupported_map,
                   "paths on this map may cost more than the index can store");
  }
  auto contracted = contract(turns.size(), arcs, effort, building);
  if (!contracted) return Unexpected<Error>(contracted.error());
  IndexWriter writer(kPlanner, kVersion, passable);
  writer.add(std::span<const std::uint32_t>(&contracted->core_begin, 1));
  writer.add(std::span<const std::uint32_t>(contracted->heights));
  writer.add(std::span<const HierarchyNode>(contracted->nodes));
  writer.add(std::span<const HierarchyArc>(contracted->arcs));
  writer.add(std::span<const HierarchyVia>(contracted->vias));
  return writer.finish();
}

Expected<std::unique_ptr<IndexEngine>, Error> open_corner_hierarchy(IndexBytes index,
                                                                    const BitGrid& passable) {
  auto reader = IndexReader::open(std::move(index), kPlanner, kVersion, passable);
  if (!reader) return Unexpected<Error>(reader.error());
  const auto stored = read_hierarchy(*reader);
  if (!stored) return index_failure("its sections are not those of a hierarchy");
  if (const auto fault = fault_of(stored->hierarchy)) return index_failure(*fault);
  Turns turns(passable);
  auto cells = cells_by_height(turns, stored->heights);
  if (!cells || stored->hierarchy.size() != turns.size()) {
    return index_failure("its nodes are not the turns of this map");
  }
  if (!costs_fit(stored->hierarchy, *cells)) {
    return index_failure("the costs of its arcs do not match this map");
  }
  return std::make_unique<CornerHierarchyEngine>(*std::move(reader), std::move(turns), *stored,
                                                 *std::move(cells));
}

}  // namespace wend
