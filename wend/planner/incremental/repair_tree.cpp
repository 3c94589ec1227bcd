#include "wend/planner/incremental/repair_tree.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "wend/planner/grid/cost_grid_parts.hpp"
#include "wend/planner/grid/whole_estimate.hpp"
#include "wend/planner/grid/whole_search.hpp"
#include "wend/planner/incremental/kept_roots.hpp"
#include "wend/search/bucket_queue.hpp"
#include "wend/search/node_table.hpp"

namespace wend {
namespace {

constexpr Move opposite_move(unsigned move) {
  return static_cast<Move>((move + kDirections / 2) % kDirections);
}

template <class Cost, class Word, class Units>
class RepairTree final : public WholeSearch<RepairTree<Cost, Word, Units>, Word, Units> {
 public:
  RepairTree(std::shared_ptr<const CostGrid<Word>> its_grid, const BestFirst& parts)
      : Base(std::move(its_grid)),
        words_(grid().words()),
        estimate_(parts, grid().least_steps()),
        nodes_(grid().state_count()) {}

  bool allocated() const override { return nodes_.allocated(); }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    overflown_ = false;
    if (!begin_counting(limits, observer)) return;
    begin_at(start, goals);
    if (overflown_) end(SearchOutcome::cost_overflow);
    count_open(queue_.size());
  }

  OpenList open_list(std::size_t most) const override {
    BucketQueue<Entry> rest = queue_;
    OpenList list;
    const auto add = [&](StateId id) {
      ++list.count;
      if (list.entries.size() < most) list.entries.push_back({event_of(id), OpenTie::none});
    };
    while (!rest.empty()) {
      if (done_at(rest.seek())) break;
      const Entry entry = rest.pop();
      if (is_stale(entry)) continue;
      if (const std::uint64_t key = key_of(entry.id, entry.g); key >= rest.end_of_bucket()) {
        rest.push(key, entry);
        continue;
      }
      if (entry.id != start_) add(entry.id);
    }
    if (outcome() == SearchOutcome::running && ends_with_start()) add(start_);
    return list;
  }

  double heuristic(const Cell& place) const override { return estimate_.cells(place); }

  void write_path(Path& path) const override {
    path.clear();
    StateId id = start_;
    path.append(grid().cell(id));
    while (nodes_[id].arrival() != kNoMove) {
      id = grid().neighbour(id, opposite_move(nodes_[id].arrival()));
      path.append(grid().cell(id));
    }
  }

 private:
  using Base = WholeSearch<RepairTree, Word, Units>;
  friend Base;
  using Base::begin_counting;
  using Base::count_expansion;
  using Base::count_open;
  using Base::count_reached;
  using Base::end;
  using Base::event_of;
  using Base::grid;
  using Base::outcome;
  using Base::stopped;
  using Base::units_per_cell;
  using Grid = CostGrid<Word>;
  using Node = MoveNode<Cost>;

  struct Entry {
    Cost g;
    StateId id;
  };

  static constexpr std::uint64_t kMostCost = std::numeric_limits<Cost>::max() / 2;

  /// Goes on with the tree if it can be kept, or begins another.
  void begin_at(const Cell& start, std::span<const GoalRegion> goals) {
    if (start_entry_) queue_.push_anywhere(key_of(start_, start_entry_->g), *start_entry_);
    start_entry_.reset();
    const Cell before = grid().cell(start_);
    const auto changes = roots_.take(grid(), goals);
    start_ = grid().number(start);
    const GoalRegion here(start);
    estimate_.begin({&here, 1});
    if (!changes) return plant();
    moved_ += estimate_.units(before);
    repair(*changes);
    drop_stale_entries();
  }

  /// A new tree of roots only.
  void plant() {
    moved_ = 0;
    estimate_.set_least_steps(grid().least_steps());
    nodes_.begin_search();
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    roots_.for_each(grid(), [&](StateId root) { least = std::min(least, key_of(root, 0)); });
    queue_.begin(least, width_bits());
    roots_.for_each(grid(), [&](StateId root) { reach(root, 0, kNoMove); });
    kept_entries_ = queue_.size();
  }

  /// A bucket is between 1/8 and 1/16 of the cheapest straight step wide.
  unsigned width_bits() const {
    const std::uint64_t step = 2 * grid().least_steps() * Units::kStraight;
    return static_cast<unsigned>(std::bit_width(step)) - 4;
  }

  /// Cuts off what the changes make wrong, then opens what may lead around them.
  void repair(std::span<const typename Grid::Change> changes) {
    beside_.clear();
    for (const auto& change : changes) {
      const Word now = words_[change.id];
      beside_.push_back(change.id);
      if (Grid::steps(change.before) != Grid::steps(now)) {
        forget_from(change.id);
        add_neighbours(change.id);
        continue;
      }
      unsigned lost = legal_moves(change.before) & ~legal_moves(now);
      for (; lost != 0; lost &= lost - 1) {
        const auto direction = static_cast<unsigned>(std::countr_zero(lost));
        const StateId next = grid().neighbour(change.id, direction);
        if (arrives_by(next, direction)) forget_from(next);
      }
    }
    for (const StateId id : beside_) {
      Node& node = nodes_[id];
      if (!nodes_.reached(node) || !node.closed()) continue;
      node.reopen();
      queue_.push_anywhere(key_of(id, node.g), {node.g, id});
    }
  }

  unsigned legal_moves(Word word) const { return word == 0 ? 0U : grid().moves(kNoMove, word); }

  bool arrives_by(StateId id, unsigned direction) const {
    const Node& node = nodes_[id];
    return nodes_.reached(node) && node.arrival() == direction;
  }

  /// Forgets a node and all its descendants, and notes what lies beside them.
  void forget_from(StateId id) {
    if (!nodes_.reached(nodes_[id])) return;
    doomed_.assign(1, id);
    while (!doomed_.empty()) {
      const StateId at = doomed_.back();
      doomed_.pop_back();
      nodes_[at].forget();
      for (unsigned direction = 0; direction < kDirections; ++direction) {
        const StateId next = grid().neighbour(at, direction);
        if (arrives_by(next, direction)) {
          doomed_.push_back(next);
        } else {
          beside_.push_back(next);
        }
      }
    }
  }

  void add_neighbours(StateId id) {
    for (unsigned direction = 0; direction < kDirections; ++direction) {
      beside_.push_back(grid().neighbour(id, direction));
    }
  }

  /// Keeps the queue from growing with every repair.
  void drop_stale_entries() {
    constexpr std::size_t kSlack = 4096;
    if (queue_.size() < 2 * kept_entries_ + kSlack) return;
    std::vector<Entry> kept;
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    while (!queue_.empty()) {
      const Entry entry = queue_.pop();
      if (is_stale(entry)) continue;
      least = std::min(least, key_of(entry.id, entry.g));
      kept.push_back(entry);
    }
    queue_.begin(kept.empty() ? 0 : least, width_bits());
    for (const Entry& entry : kept) queue_.push_anywhere(key_of(entry.id, entry.g), entry);
    kept_entries_ = queue_.size();
  }

  bool is_stale(const Entry& entry) const {
    const Node& node = nodes_[entry.id];
    return !nodes_.reached(node) || node.g != entry.g || node.closed();
  }

  std::uint64_t key_of(StateId id, std::uint64_t g) const {
    return g + estimate_.units(grid().cell(id)) + moved_;
  }

  /// Has the start been reached, and can no key from `least` on lead to it more cheaply?
  bool done_at(std::uint64_t least) const {
    const Node& node = nodes_[start_];
    return nodes_.reached(node) && node.g + moved_ <= least;
  }

  /// Is the start what is expanded last?
  bool ends_with_start() const {
    const Node& node = nodes_[start_];
    return nodes_.reached(node) && !node.closed();
  }

  /// Expands one node, or ends the search.
  void advance() {
    while (!queue_.empty()) {
      if (done_at(queue_.seek())) break;
      const Entry entry = queue_.pop();
      if (is_stale(entry)) continue;
      if (entry.id == start_) {
        // It is expanded last. A later search, from elsewhere, may need its moves.
        start_entry_ = entry;
        continue;
      }
      const std::uint64_t key = key_of(entry.id, entry.g);
      if (key >= queue_.end_of_bucket()) {
        queue_.push(key, entry);
        continue;
      }
      if (stopped()) {
        queue_.push(key, entry);
        return;
      }
      expand(entry.id, entry.g);
      if (overflown_) end(SearchOutcome::cost_overflow);
      return;
    }
    if (!nodes_.reached(nodes_[start_])) return end(SearchOutcome::exhausted);
    if (ends_with_start()) {
      if (stopped()) return;
      count_expansion(start_);
    }
    end(SearchOutcome::found);
  }

  void expand(StateId id, std::uint64_t g) {
    Node& node = nodes_[id];
    node.close();
    count_expansion(id);
    const Word word = words_[id];
    const std::uint64_t steps = Grid::steps(word);
    unsigned moves = grid().moves(node.arrival(), word);
    for (; moves != 0; moves &= moves - 1) {
      const auto direction = static_cast<unsigned>(std::countr_zero(moves));
      const StateId next = grid().neighbour(id, direction);
      const std::uint64_t sum = steps + Grid::steps(words_[next]);
      const std::uint64_t unit = (direction & 1U) != 0 ? Units::kDiagonal : Units::kStraight;
      reach(next, g + sum * unit, static_cast<Move>(direction));
    }
    count_open(queue_.size());
  }

  /// Opens a node unless it was reached as well or better.
  void reach(StateId id, std::uint64_t g, Move arrival) {
    Node& node = nodes_[id];
    const bool reached = nodes_.reached(node);
    if (reached && node.g <= g) return;
    const std::uint64_t key = key_of(id, g);
    if (key - moved_ > kMostCost) {
      overflown_ = true;
      return;
    }
    nodes_.open(node, static_cast<Cost>(g), arrival);
    queue_.push_anywhere(key, {static_cast<Cost>(g), id});
    count_reached(id, reached);
  }

  CellArrival arrival_of(StateId id) const {
    const Node& node = nodes_[id];
    const Cell cell = grid().cell(id);
    CellArrival arrival{static_cast<double>(node.g) / units_per_cell(), estimate_.cells(cell), {}};
    if (node.arrival() != kNoMove) {
      arrival.parent = grid().cell(grid().neighbour(id, opposite_move(node.arrival())));
    }
    return arrival;
  }

  const Word* words_;
  WholeEstimate<Units> estimate_;  // to the start
  NodeTable<Node> nodes_;
  BucketQueue<Entry> queue_;
  std::size_t kept_entries_ = 0;  // when stale ones were last dropped
  std::uint64_t moved_ = 0;       // km
  KeptRoots<Word> roots_;
  std::vector<StateId> beside_;  // of a repair
  std::vector<StateId> doomed_;
  StateId start_ = 0;
  std::optional<Entry> start_entry_;  // of the present search, taken from the queue
  bool overflown_ = false;
};

}  // namespace

template <class Word>
std::shared_ptr<GridEngine> make_repair_tree(const std::shared_ptr<const CostGrid<Word>>& grid,
                                             const BestFirst& parts) {
  return widening_engine_on<RepairTree>(grid, parts);
}

template std::shared_ptr<GridEngine> make_repair_tree(
    const std::shared_ptr<const CostGrid<std::uint32_t>>&, const BestFirst&);
template std::shared_ptr<GridEngine> make_repair_tree(
    const std::shared_ptr<const CostGrid<std::uint64_t>>&, const BestFirst&);

}  // namespace wend
