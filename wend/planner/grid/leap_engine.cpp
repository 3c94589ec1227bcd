#include "wend/planner/grid/leap_engine.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "wend/planner/grid/cost_grid.hpp"
#include "wend/planner/grid/run_node.hpp"
#include "wend/planner/grid/run_stops.hpp"
#include "wend/planner/grid/whole_estimate.hpp"
#include "wend/planner/widening_engine.hpp"
#include "wend/search/bucket_queue.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/space/grid/cost_units.hpp"
#include "wend/space/grid/grid_space.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {
namespace {

constexpr bool is_diagonal_move(unsigned move) { return (move & 1U) != 0; }

template <class Cost, class Word, class Units>
class LeapEngine final : public GridEngine {
 public:
  LeapEngine(std::shared_ptr<const CostGrid<Word>> grid, const BestFirst& parts,
             std::shared_ptr<const Landmarks> landmarks = nullptr)
      : grid_(std::move(grid)),
        landmarks_(std::move(landmarks)),
        words_(grid_->words()),
        log_position_(grid_->log_end()),
        estimate_(parts, grid_->least_steps()),
        leaps_(parts.leaps && parts.moves.connectivity == Connectivity::eight),
        cuts_corners_(parts.moves.corner_rule != CornerRule::none),
        stops_(*grid_),
        nodes_(grid_->state_count()) {}

  bool allocated() const override { return nodes_.allocated(); }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    limits_.begin(limits);
    observer_ = observer;
    metrics_ = {};
    overflown_ = false;
    best_ = kNoCost;
    outcome_ = allocated() ? SearchOutcome::running : SearchOutcome::out_of_memory;
    if (!allocated()) return;
    nodes_.begin_search();
    catch_up();
    estimate_.begin(goals);
    stops_.set_goals(goals);
    const StateId id = grid_->number(start);
    bounds_ = {};
    if (landmarks_ != nullptr && goals.size() == 1 && goals.front().is_one_place()) {
      bounds_ = Landmarks::Bounds(landmarks_, id, grid_->number(goals.front().any()));
    }
    queue_.begin(estimate(start, id), width_bits_for(grid_->least_steps()));
    reach(id, start, 0, Node::kNoArrival);
    metrics_.max_frontier = metrics_.generated;
    if (overflown_) outcome_ = SearchOutcome::cost_overflow;
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
    std::uint64_t best = best_;
    Cell goal = goal_;
    const auto add = [&](Cell cell) {
      ++list.count;
      if (list.entries.size() == most) return;
      list.entries.push_back({event_of(cell, nodes_[grid_->number(cell)]), OpenTie::none});
    };
    while (!rest.empty()) {
      const Entry entry = rest.pop();
      if (best <= rest.least_key()) break;
      if (is_stale(entry) || is_dominated(entry)) continue;
      const Cell cell = grid_->cell(entry.id);
      if (!estimate_.is_goal(cell)) {
        add(cell);
      } else if (entry.g < best) {
        best = entry.g;
        goal = cell;
      }
    }
    if (best != kNoCost && outcome_ == SearchOutcome::running) add(goal);
    return list;
  }

  double heuristic(const Cell& place) const override { return estimate_in_cells(place); }

  void write_path(Path& path) const override {
    path.clear();
    Cell cell = goal_;
    path.append(cell);
    for (;;) {
      const Node& node = nodes_[grid_->number(cell)];
      if (node.move() == kNoMove) break;
      const Cell back = kDirectionSteps[(node.move() + 4U) % kDirections];
      for (std::uint32_t left = node.run(); left > 0; --left) {
        cell = {cell.x + back.x, cell.y + back.y};
        path.append(cell);
      }
    }
    path.reverse();
  }

 private:
  using Grid = CostGrid<Word>;
  using Node = RunNode<Cost>;

  struct Entry {
    Cost g;
    StateId id;
  };

  static constexpr std::uint64_t kNoCost = UINT64_MAX;
  static constexpr std::uint64_t kMostCost = std::numeric_limits<Cost>::max() / 2;

  /// A bucket is between 1/8 and 1/16 of the cheapest straight step wide.
  static unsigned width_bits_for(std::uint64_t least_steps) {
    const std::uint64_t least = 2 * least_steps * Units::kStraight;
    return static_cast<unsigned>(std::bit_width(least)) - 4;
  }

  /// Takes what was repaired in the grid since the last search.
  void catch_up() {
    const auto changes = grid_->changes_since(log_position_);
    if (changes) {
      stops_.repair(*grid_, *changes);
    } else {
      stops_ = RunStops(*grid_);
    }
    if (landmarks_ != nullptr && (!changes || Landmarks::may_fall(*grid_, *changes))) {
      landmarks_.reset();
    }
    log_position_ = grid_->log_end();
    estimate_.set_least_steps(grid_->least_steps());
  }

  std::uint64_t estimate(Cell cell, StateId id) const {
    return std::max(estimate_.units(cell), bounds_(id));
  }

  double units_per_cell() const {
    return 2.0 * static_cast<double>(grid_->one()) * Units::kStraight;
  }

  /// As people see it.
  double estimate_in_cells(Cell cell) const {
    const auto bound = static_cast<double>(bounds_(grid_->number(cell)));
    return std::max(estimate_.cells(cell), bound / units_per_cell());
  }

  /// Was the cell reached more cheaply since?
  bool is_stale(const Entry& entry) const { return nodes_[entry.id].g != entry.g; }

  /// Expands one cell, or ends the search.
  void advance() {
    while (!queue_.empty()) {
      const Entry entry = queue_.pop();
      if (best_ <= queue_.least_key()) break;
      if (is_stale(entry)) continue;
      if (limits_.due(metrics_.expanded)) {
        outcome_ = limits_.look(metrics_.expanded);
        if (outcome_ != SearchOutcome::running) return;
      }
      if (!expand(entry.id, entry.g)) continue;
      if (overflown_) outcome_ = SearchOutcome::cost_overflow;
      return;
    }
    outcome_ = SearchOutcome::exhausted;
    if (best_ == kNoCost) return;
    if (limits_.due(metrics_.expanded)) outcome_ = limits_.look(metrics_.expanded);
    if (outcome_ != SearchOutcome::exhausted && outcome_ != SearchOutcome::running) return;
    outcome_ = SearchOutcome::found;
    const StateId id = grid_->number(goal_);
    count_expansion({id, goal_, best_, Grid::steps(words_[id])});
  }

  /// False if there is nothing to expand yet: the cell is dominated, or a goal.
  bool expand(StateId id, std::uint64_t g) {
    const Cell cell = grid_->cell(id);
    const Move arrival = nodes_[id].move();
    const Word word = words_[id];
    const From from{id, cell, g, Grid::steps(word)};
    if (estimate_.is_goal(cell)) {
      // It is expanded last, when no other goal can be reached more cheaply.
      if (g < best_) {
        best_ = g;
        goal_ = cell;
      }
      return false;
    }
    unsigned moves = grid_->moves(arrival, word);
    if (leaps_ && arrival != kNoMove) {
      if (Grid::interior(word)) {
        if (is_diagonal_move(arrival)) return expand_diagonal(from, arrival);
      } else if (!is_diagonal_move(arrival) && Grid::class_of(word) != CostClass::uniform) {
        moves = without_dearer_diagonals(from, arrival, moves);
      }
    }
    count_expansion(from);
    for (; moves != 0; moves &= moves - 1) {
      const auto direction = static_cast<unsigned>(std::countr_zero(moves));
      if (is_diagonal_move(direction)) {
        step_diagonally(from, direction);
      } else {
        step_straight(from, direction);
      }
    }
    metrics_.max_frontier = std::max<std::uint64_t>(metrics_.max_frontier, queue_.size());
    return true;
  }

  struct From {
    StateId id;
    Cell cell;
    std::uint64_t g;
    std::uint64_t steps;
  };

  /// A straight run: how far it leads, and what its end costs.
  struct Run {
    unsigned direction;
    std::uint32_t length;
    StateId end;
    std::uint64_t g;
  };

  Run run_from(const From& from, unsigned direction) const {
    const std::uint32_t length = std::min(stops_.distance(from.cell, direction), Node::kLongest);
    return {direction, length, grid_->neighbour(from.id, direction, length),
            from.g + 2 * from.steps * Units::kStraight * length};
  }

  /// Did a run that passes its start reach its end more cheaply?
  bool dominated(const Run& run) const {
    const Node& node = nodes_[run.end];
    return nodes_.reached(node) && node.g < run.g && node.move() == run.direction &&
           node.run() >= run.length;
  }

  /// The same for both runs of an interior cell that was reached by a diagonal step.
  bool is_dominated(const Entry& entry) const {
    const Move arrival = nodes_[entry.id].move();
    const Word word = words_[entry.id];
    const Cell cell = grid_->cell(entry.id);
    if (!leaps_ || !Grid::interior(word) || arrival == kNoMove || !is_diagonal_move(arrival)) {
      return false;
    }
    if (estimate_.is_goal(cell)) return false;
    const From from{entry.id, cell, entry.g, Grid::steps(word)};
    return dominated(run_from(from, (arrival + 7U) % kDirections)) ||
           dominated(run_from(from, (arrival + 1U) % kDirections));
  }

  void follow(const From& from, const Run& run) {
    const Cell step = kDirectionSteps[run.direction];
    const int length = static_cast<int>(run.length);
    reach(run.end, {from.cell.x + length * step.x, from.cell.y + length * step.y}, run.g,
          Node::arrival_by(run.direction, run.length));
  }

  /// An interior cell that was reached by a diagonal step: its two runs, and the diagonal step on.
  bool expand_diagonal(const From& from, Move arrival) {
    const Run first = run_from(from, (arrival + kDirections - 1U) % kDirections);
    if (dominated(first)) return false;
    const Run second = run_from(from, (arrival + 1U) % kDirections);
    if (dominated(second)) return false;
    count_expansion(from);
    follow(from, first);
    follow(from, second);
    step_diagonally(from, arrival);
    metrics_.max_frontier = std::max<std::uint64_t>(metrics_.max_frontier, queue_.size());
    return true;
  }

  void step_straight(const From& from, unsigned direction) {
    const StateId next = grid_->neighbour(from.id, direction);
    const Word word = words_[next];
    if (leaps_ && Grid::interior(word)) {
      follow(from, run_from(from, direction));
      return;
    }
    const Cell step = kDirectionSteps[direction];
    reach(next, {from.cell.x + step.x, from.cell.y + step.y},
          from.g + (from.steps + Grid::steps(word)) * Units::kStraight,
          Node::arrival_by(direction, 1));
  }

  void step_diagonally(const From& from, unsigned direction) {
    const StateId next = grid_->neighbour(from.id, direction);
    const Cell step = kDirectionSteps[direction];
    reach(next, {from.cell.x + step.x, from.cell.y + step.y},
          from.g + (from.steps + Grid::steps(words_[next])) * Units::kDiagonal,
          Node::arrival_by(direction, 1));
  }

  /// Leaves out the diagonal moves after a straight step that cost at least as much as the diagonal step
  /// from the parent and a straight one.
  unsigned without_dearer_diagonals(const From& from, Move arrival, unsigned moves) const {
    const StateId parent = grid_->neighbour(from.id, (arrival + 4U) % kDirections);
    const std::uint64_t parent_steps = Grid::steps(words_[parent]);
    for (const unsigned turn : {1U, 7U}) {
      const unsigned diagonal = (arrival + turn) % kDirections;
      if (((moves >> diagonal) & 1U) == 0) continue;
      const unsigned aside = (arrival + 2 * turn) % kDirections;
      const std::uint64_t via = Grid::steps(words_[grid_->neighbour(from.id, aside)]);
      if (via == 0) continue;
      if (!cuts_corners_ && words_[grid_->neighbour(parent, aside)] == 0) continue;
      const std::uint64_t to = Grid::steps(words_[grid_->neighbour(from.id, diagonal)]);
      const std::uint64_t here =
          (parent_steps + from.steps) * Units::kStraight + (from.steps + to) * Units::kDiagonal;
      const std::uint64_t other =
          (parent_steps + via) * Units::kDiagonal + (via + to) * Units::kStraight;
      if (other <= here) moves &= ~(1U << diagonal);
    }
    return moves;
  }

  /// Opens a cell unless it was reached as well or better.
  void reach(StateId id, Cell cell, std::uint64_t g, typename Node::Arrival arrival) {
    Node& node = nodes_[id];
    const bool reached = nodes_.reached(node);
    if (reached && node.g <= g) return;
    const std::uint64_t f = g + estimate(cell, id);
    if (f >= best_) return;
    if (f > kMostCost) {
      overflown_ = true;
      return;
    }
    metrics_.generated += reached ? 0 : 1;
    nodes_.open(node, static_cast<Cost>(g), arrival);
    queue_.push(f, {static_cast<Cost>(g), id});
    if (observer_ != nullptr) tell_reached(cell, node, reached);
  }

  void count_expansion(const From& from) {
    ++metrics_.expanded;
    if (observer_ != nullptr) observer_->on_expand(event_of(from.cell, nodes_[from.id]));
  }

  [[gnu::noinline]] void tell_reached(Cell cell, const Node& node, bool again) {
    if (again) {
      observer_->on_relax(event_of(cell, node));
    } else {
      observer_->on_generate(event_of(cell, node));
    }
  }

  SearchEvent event_of(Cell cell, const Node& node) const {
    const double g = static_cast<double>(node.g) / units_per_cell();
    const double h = estimate_in_cells(cell);
    SearchEvent event{{}, {}, g, h, g + h};
    event.cell = cell;
    if (node.move() != kNoMove) {
      event.parent = wend::step(cell, opposite(static_cast<Direction>(node.move())),
                                static_cast<int>(node.run()));
    }
    return event;
  }

  std::shared_ptr<const Grid> grid_;
  std::shared_ptr<const Landmarks> landmarks_;  // null: none, or no longer
  Landmarks::Bounds bounds_;                    // of the present query
  const Word* words_;
  std::uint64_t log_position_;  // in the grid's log
  WholeEstimate<Units> estimate_;
  bool leaps_;
  bool cuts_corners_;
  RunStops stops_;
  RunNodes<Cost> nodes_;
  BucketQueue<Entry> queue_;
  LimitCheck limits_;
  SearchObserver* observer_ = nullptr;
  SearchMetrics metrics_;
  SearchOutcome outcome_ = SearchOutcome::exhausted;
  bool overflown_ = false;
  std::uint64_t best_ = kNoCost;  // of the goals expanded so far
  Cell goal_{};
};

template <class Word>
GridPlanner::Parts parts_with(const std::shared_ptr<CostGrid<Word>>& grid,
                              const std::shared_ptr<GridEngine>& engine, const BestFirst& parts,
                              unsigned landmarks) {
  GridPlanner::Parts made{parts.moves, engine, parts.bound()};
  made.repaired = [=](const FreeSpace& space, const SpaceChange& change) {
    if (!grid->can_become(space)) {
      return landmarks == 0 ? best_first_parts(space, parts) : leap_parts(space, parts, landmarks);
    }
    grid->repair(space, change);
    return parts_with(grid, engine, parts, landmarks);
  };
  return made;
}

template <class Word>
GridPlanner::Parts parts_on(const FreeSpace& space, const BestFirst& parts, unsigned landmarks) {
  const auto grid = std::make_shared<CostGrid<Word>>(space, parts.moves);
  const auto bounds = landmarks == 0 ? nullptr : Landmarks::make(*grid, landmarks);
  return parts_with(grid, make_leap_engine<Word>(grid, parts, bounds), parts, landmarks);
}

}  // namespace

bool can_leap(const FreeSpace& space, const BestFirst& parts) {
  return parts.whole() && !sweeps_diagonals(space, parts.moves);
}

template <>
std::shared_ptr<GridEngine> make_leap_engine(
    std::shared_ptr<const CostGrid<std::uint64_t>> grid, const BestFirst& parts,
    const std::shared_ptr<const Landmarks>& /*landmarks*/) {
  using Engine = LeapEngine<std::uint64_t, std::uint64_t, CostUnits>;
  return std::make_shared<Engine>(std::move(grid), parts);
}

template <>
std::shared_ptr<GridEngine> make_leap_engine(std::shared_ptr<const CostGrid<std::uint32_t>> grid,
                                             const BestFirst& parts,
                                             const std::shared_ptr<const Landmarks>& landmarks) {
  using Compact = std::uint32_t;
  using Wide = std::uint64_t;
  // The costs of landmarks are those of the compact engine.
  const auto widening = [&]<class Units, class WideUnits>() {
    return std::make_shared<WideningEngine<GridEngine>>(
        [&] {
          return std::make_unique<LeapEngine<Compact, Compact, Units>>(grid, parts, landmarks);
        },
        [grid, parts] {
          return std::make_unique<LeapEngine<Wide, Compact, WideUnits>>(grid, parts);
        });
  };
  if (grid->one() != 1) return widening.template operator()<CostUnits, CostUnits>();
  return widening.template operator()<OctileUnits<Compact>, OctileUnits<Wide>>();
}

GridPlanner::Parts leap_parts(const FreeSpace& space, const BestFirst& parts, unsigned landmarks) {
  if (CostGrid<std::uint32_t>::holds(space.costs())) {
    return parts_on<std::uint32_t>(space, parts, landmarks);
  }
  return parts_on<std::uint64_t>(space, parts, landmarks);
}

}  // namespace wend
