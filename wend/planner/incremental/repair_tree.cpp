#include "wend/planner/incremental/repair_tree.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "wend/planner/grid/whole_estimate.hpp"
#include "wend/planner/widening_engine.hpp"
#include "wend/search/bucket_queue.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/space/grid/cost_units.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {
namespace {

constexpr Move opposite_move(unsigned move) {
  return static_cast<Move>((move + kDirections / 2) % kDirections);
}

template <class Cost, class Word, class Units>
class RepairTree final : public GridEngine {
 public:
  RepairTree(std::shared_ptr<const CostGrid<Word>> grid, const BestFirst& parts)
      : grid_(std::move(grid)),
        words_(grid_->words()),
        estimate_(parts, grid_->least_steps()),
        nodes_(grid_->state_count()) {}

  bool allocated() const override { return nodes_.allocated(); }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    limits_.begin(limits);
    observer_ = observer;
    metrics_ = {};
    overflown_ = false;
    outcome_ = allocated() ? SearchOutcome::running : SearchOutcome::out_of_memory;
    if (!allocated()) return;
    begin_at(start, goals);
    if (overflown_) outcome_ = SearchOutcome::cost_overflow;
    metrics_.max_frontier = queue_.size();
  }

  SearchOutcome step() override {
    advance();
    return outcome_;
  }

  SearchOutcome run() override {
    while (outcome_ == SearchOutcome::running) advance();
    return outcome_;
  }

  const SearchMetrics& metrics() const override { return metrics_; }

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
    if (outcome_ == SearchOutcome::running && ends_with_start()) add(start_);
    return list;
  }

  double heuristic(const Cell& place) const override { return estimate_.cells(place); }

  void write_path(Path& path) const override {
    path.clear();
    StateId id = start_;
    path.append(grid_->cell(id));
    while (nodes_[id].arrival() != kNoMove) {
      id = grid_->neighbour(id, opposite_move(nodes_[id].arrival()));
      path.append(grid_->cell(id));
    }
  }

 private:
  using Grid = CostGrid<Word>;
  using Node = MoveNode<Cost>;

  struct Entry {
    Cost g;
    StateId id;
  };

  static constexpr std::uint64_t kMostCost = std::numeric_limits<Cost>::max() / 2;

  /// Goes on with the tree if it can be kept, or begins another.
  void begin_at(const Cell& start, std::span<const GoalRegion> goals) {
    const Cell before = started_ ? grid_->cell(start_) : start;
    if (start_entry_) queue_.push_anywhere(key_of(start_, start_entry_->g), *start_entry_);
    start_entry_.reset();
    const GoalRegion here(start);
    const auto changes = grid_->changes_since(log_position_);
    log_position_ = grid_->log_end();
    start_ = grid_->number(start);
    const bool keeps = started_ && changes && least_steps_ == grid_->least_steps() &&
                       std::ranges::equal(goals, goals_) && !changes_a_root(*changes);
    if (!keeps) {
      estimate_.begin({&here, 1});
      plant(goals);
      return;
    }
    moved_ += estimate_between(before, start);
    estimate_.begin({&here, 1});
    repair(*changes);
    drop_stale_entries();
  }

  std::uint64_t estimate_between(Cell from, Cell to) {
    const GoalRegion there(to);
    estimate_.begin({&there, 1});
    return estimate_.units(from);
  }

  /// A new tree of roots only.
  void plant(std::span<const GoalRegion> goals) {
    started_ = true;
    moved_ = 0;
    least_steps_ = grid_->least_steps();
    estimate_.set_least_steps(least_steps_);
    nodes_.begin_search();
    goals_.assign(goals.begin(), goals.end());
    std::vector<StateId> roots;
    const CellBox map{{0, 0}, {grid_->width(), grid_->height()}};
    for (const GoalRegion& goal : goals) {
      goal.for_each([&](Cell cell) {
        if (map.contains(cell) && words_[grid_->number(cell)] != 0)
          roots.push_back(grid_->number(cell));
      });
    }
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (const StateId root : roots) least = std::min(least, key_of(root, 0));
    // A bucket is between 1/8 and 1/16 of the cheapest straight step wide.
    const std::uint64_t step = 2 * least_steps_ * Units::kStraight;
    queue_.begin(least, static_cast<unsigned>(std::bit_width(step)) - 4);
    for (const StateId root : roots) reach(root, 0, kNoMove);
    kept_entries_ = queue_.size();
  }

  bool changes_a_root(std::span<const typename Grid::Change> changes) const {
    return std::ranges::any_of(changes, [&](const auto& change) {
      return Grid::steps(change.before) != Grid::steps(words_[change.id]) &&
             any_contains(goals_, grid_->cell(change.id));
    });
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
        const StateId next = grid_->neighbour(change.id, direction);
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

  unsigned legal_moves(Word word) const { return word == 0 ? 0U : grid_->moves(kNoMove, word); }

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
        const StateId next = grid_->neighbour(at, direction);
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
      beside_.push_back(grid_->neighbour(id, direction));
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
    const std::uint64_t step = 2 * least_steps_ * Units::kStraight;
    queue_.begin(kept.empty() ? 0 : least, static_cast<unsigned>(std::bit_width(step)) - 4);
    for (const Entry& entry : kept) queue_.push_anywhere(key_of(entry.id, entry.g), entry);
    kept_entries_ = queue_.size();
  }

  bool is_stale(const Entry& entry) const {
    const Node& node = nodes_[entry.id];
    return !nodes_.reached(node) || node.g != entry.g || node.closed();
  }

  std::uint64_t key_of(StateId id, std::uint64_t g) const {
    return g + estimate_.units(grid_->cell(id)) + moved_;
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
      if (limits_.due(metrics_.expanded)) {
        outcome_ = limits_.look(metrics_.expanded);
        if (outcome_ != SearchOutcome::running) {
          queue_.push(key, entry);
          return;
        }
      }
      expand(entry.id, entry.g);
      if (overflown_) outcome_ = SearchOutcome::cost_overflow;
      return;
    }
    const bool found = nodes_.reached(nodes_[start_]);
    outcome_ = found ? SearchOutcome::found : SearchOutcome::exhausted;
    if (!ends_with_start()) return;
    if (limits_.due(metrics_.expanded)) outcome_ = limits_.look(metrics_.expanded);
    if (outcome_ == SearchOutcome::running) outcome_ = SearchOutcome::found;
    if (outcome_ == SearchOutcome::found) count_expansion(start_);
  }

  void expand(StateId id, std::uint64_t g) {
    Node& node = nodes_[id];
    node.close();
    count_expansion(id);
    const Word word = words_[id];
    const std::uint64_t steps = Grid::steps(word);
    unsigned moves = grid_->moves(node.arrival(), word);
    for (; moves != 0; moves &= moves - 1) {
      const auto direction = static_cast<unsigned>(std::countr_zero(moves));
      const StateId next = grid_->neighbour(id, direction);
      const std::uint64_t sum = steps + Grid::steps(words_[next]);
      const std::uint64_t unit = (direction & 1U) != 0 ? Units::kDiagonal : Units::kStraight;
      reach(next, g + sum * unit, static_cast<Move>(direction));
    }
    metrics_.max_frontier = std::max<std::uint64_t>(metrics_.max_frontier, queue_.size());
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
    metrics_.generated += reached ? 0 : 1;
    if (observer_ != nullptr) tell_reached(id, reached);
  }

  void count_expansion(StateId id) {
    ++metrics_.expanded;
    if (observer_ != nullptr) observer_->on_expand(event_of(id));
  }

  [[gnu::noinline]] void tell_reached(StateId id, bool again) {
    if (again) {
      observer_->on_relax(event_of(id));
    } else {
      observer_->on_generate(event_of(id));
    }
  }

  SearchEvent event_of(StateId id) const {
    const Node& node = nodes_[id];
    const Cell cell = grid_->cell(id);
    const double per_cell = 2.0 * static_cast<double>(grid_->one()) * Units::kStraight;
    const double g = static_cast<double>(node.g) / per_cell;
    const double h = estimate_.cells(cell);
    SearchEvent event{{}, {}, g, h, g + h};
    event.cell = cell;
    if (node.arrival() != kNoMove) {
      event.parent = grid_->cell(grid_->neighbour(id, opposite_move(node.arrival())));
    }
    return event;
  }

  std::shared_ptr<const Grid> grid_;
  const Word* words_;
  WholeEstimate<Units> estimate_;  // to the start
  NodeTable<Node> nodes_;
  BucketQueue<Entry> queue_;
  std::size_t kept_entries_ = 0;  // when stale ones were last dropped
  bool started_ = false;          // is there a tree?
  std::uint64_t log_position_ = 0;
  std::uint64_t least_steps_ = 0;
  std::uint64_t moved_ = 0;  // km
  std::vector<GoalRegion> goals_;
  std::vector<StateId> beside_;  // of a repair
  std::vector<StateId> doomed_;
  StateId start_ = 0;
  std::optional<Entry> start_entry_;  // of the present search, taken from the queue
  LimitCheck limits_;
  SearchObserver* observer_ = nullptr;
  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
  bool overflown_ = false;
};

}  // namespace

template <>
std::shared_ptr<GridEngine> make_repair_tree(std::shared_ptr<const CostGrid<std::uint64_t>> grid,
                                             const BestFirst& parts) {
  using Tree = RepairTree<std::uint64_t, std::uint64_t, CostUnits>;
  return std::make_shared<Tree>(std::move(grid), parts);
}

template <>
std::shared_ptr<GridEngine> make_repair_tree(std::shared_ptr<const CostGrid<std::uint32_t>> grid,
                                             const BestFirst& parts) {
  using Compact = std::uint32_t;
  using Wide = std::uint64_t;
  const auto widening = [&]<class Units, class WideUnits>() {
    return std::make_shared<WideningEngine<GridEngine>>(
        [&] { return std::make_unique<RepairTree<Compact, Compact, Units>>(grid, parts); },
        [grid, parts] {
          return std::make_unique<RepairTree<Wide, Compact, WideUnits>>(grid, parts);
        });
  };
  if (grid->one() != 1) return widening.template operator()<CostUnits, CostUnits>();
  return widening.template operator()<OctileUnits<Compact>, OctileUnits<Wide>>();
}

}  // namespace wend
