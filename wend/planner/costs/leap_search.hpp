#pragma once

// LeapSearch: the search of a leap engine (leap_engine.hpp says how it works).

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "wend/base/bucket_queue.hpp"
#include "wend/planner/costs/cost_grid.hpp"
#include "wend/planner/costs/integer_search.hpp"
#include "wend/planner/costs/landmarks.hpp"
#include "wend/planner/costs/leap_rounds.hpp"
#include "wend/planner/costs/run_node.hpp"
#include "wend/planner/costs/run_stops.hpp"
#include "wend/planner/costs/side_rooms.hpp"
#include "wend/planner/costs/whole_estimate.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

/// Costs of the type Cost on a grid of Words, in Units: CostUnits, or OctileUnits where every cell costs the same.
/// With kInRounds an anytime search (leap_rounds.hpp).
template <class Cost, class Word, class Units, bool kInRounds = false>
class LeapSearch final : public IntegerSearch {
 public:
  LeapSearch(std::shared_ptr<const CostGrid<Word>> its_grid, const BestFirst& parts,
             std::shared_ptr<const Landmarks> landmarks = nullptr)
    requires(!kInRounds)
      : LeapSearch(std::move(its_grid), parts, std::move(landmarks), NoRounds{}) {}
  LeapSearch(std::shared_ptr<const CostGrid<Word>> its_grid, const BestFirst& parts,
             AnytimeWeights weights)
    requires kInRounds
      : LeapSearch(std::move(its_grid), parts, nullptr, Rounds(weights)) {}

  bool allocated() const override { return nodes_.allocated(); }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    overflown_ = false;
    best_ = kNoCost;
    expanded_before_ += metrics().expanded;
    if (!begin_counting(limits, observer)) return;
    nodes_.begin_search();
    catch_up();
    prepare_rooms(limits);
    if (rooms_ != nullptr) rooms_->close_for(start, goals);
    estimate_.begin(goals);
    stops_.set_goals(goals);
    const StateId id = grid().number(start);
    bounds_ = {};
    if (landmarks_ != nullptr && goals.size() == 1 && goals.front().is_one_place()) {
      bounds_ = Landmarks::Bounds(landmarks_, id, grid().number(goals.front().any()));
    }
    if constexpr (kInRounds) {
      rounds_.begin(*this, estimate(start, id));
    } else {
      queue_.begin(estimate(start, id), width_bits());
    }
    reach(id, start, 0, Node::kNoArrival);
    count_open(queue_.size());
    if (overflown_) end(SearchOutcome::cost_overflow);
  }

  SearchOutcome step() override {
    go_on();
    return advance(true);
  }
  SearchOutcome run() override {
    go_on();
    return outcome() == SearchOutcome::running ? advance(false) : outcome();
  }

  std::optional<double> bound() const override {
    if constexpr (kInRounds) return rounds_.bound(best_);
    return std::nullopt;
  }

  OpenList open_list(std::size_t most) const override {
    Queue rest = queue_;
    OpenList list;
    std::uint64_t best = best_;
    Cell goal = goal_;
    const auto add = [&](Cell cell) {
      ++list.count;
      if (list.entries.size() == most) return;
      list.entries.push_back({event_of(grid().number(cell)), OpenTie::none});
    };
    while (!rest.empty()) {
      const Entry entry = rest.pop();
      if (best <= rest.least_key()) break;
      if (is_stale(entry) || is_dominated(entry)) continue;
      const Cell cell = grid().cell(entry.id);
      if (!estimate_.is_goal(cell)) {
        add(cell);
      } else if (entry.g < best) {
        best = entry.g;
        goal = cell;
      }
    }
    if (is_due(best)) add(goal);
    return list;
  }

  double heuristic(const Cell& place) const override { return estimate_in_cells(place); }

  void write_path(Path& path) const override {
    path.clear();
    Cell cell = goal_;
    path.append(cell);
    for (;;) {
      const Node& node = nodes_[grid().number(cell)];
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
  using Node = std::conditional_t<kInRounds, AnytimeNode<RunNode<Cost>>, RunNode<Cost>>;

  using Entry = LeapEntry<Cost>;
  using Rounds = LeapRounds<Cost>;
  using Queue = BucketQueue<Entry, std::conditional_t<kInRounds, NewestOfFalling, NewestFirst>>;
  struct NoRounds {};
  using RoundsIfAny = std::conditional_t<kInRounds, Rounds, NoRounds>;
  friend Rounds;

  static constexpr bool is_diagonal_move(unsigned move) { return (move & 1U) != 0; }

  static constexpr std::uint64_t kStatesPerExpansion =
      4;  // which rooms are found in while one is expanded
  static constexpr StateId kFewestToPrefetch = 1U << 17U;
  static constexpr std::uint64_t kNoCost = UINT64_MAX;
  static constexpr std::uint64_t kMostCost = std::numeric_limits<Cost>::max() / 2;

  LeapSearch(std::shared_ptr<const Grid> its_grid, const BestFirst& parts,
             std::shared_ptr<const Landmarks> landmarks, RoundsIfAny rounds)
      : grid_(std::move(its_grid)),
        landmarks_(std::move(landmarks)),
        rounds_(std::move(rounds)),
        words_(grid().words()),
        log_position_(grid().log_end()),
        estimate_(parts, grid().least_steps()),
        leaps_(parts.leaps && parts.moves.connectivity == Connectivity::eight),
        cuts_corners_(parts.moves.corner_rule != CornerRule::none),
        prefetches_(grid().state_count() >= kFewestToPrefetch),
        stops_(grid()),
        nodes_(grid().state_count()) {}

  const Grid& grid() const { return *grid_; }
  bool has_path() const { return best_ != kNoCost; }

  double units_per_cell() const {
    return 2.0 * static_cast<double>(grid().one()) * Units::kStraight;
  }

  /// A bucket is between 1/8 and 1/16 of the cheapest straight step wide.
  unsigned width_bits() const {
    const std::uint64_t least = 2 * grid().least_steps() * Units::kStraight;
    return static_cast<unsigned>(std::bit_width(least)) - 4;
  }

  /// Takes what was repaired in the grid since the last search.
  void catch_up() {
    const auto changes = grid().changes_since(log_position_);
    if (changes) {
      stops_.repair(grid(), *changes);
    } else {
      stops_ = RunStops(grid());
    }
    if (landmarks_ != nullptr && (!changes || Landmarks::may_fall(grid(), *changes))) {
      landmarks_.reset();
    }
    if (!changes || (rooms_ != nullptr && !rooms_->outlast(grid(), *changes))) {
      rooms_.reset();
      expanded_before_ = 0;
    }
    log_position_ = grid().log_end();
    estimate_.set_least_steps(grid().least_steps());
  }

  /// Once searches have taken about as long. Searches in rounds do without: each path on the way would depend on it. So
  /// do those with landmarks, which know most of it.
  void prepare_rooms(const Limits& limits) {
    if (kInRounds || landmarks_ != nullptr || rooms_ != nullptr) return;
    if (expanded_before_ < grid().state_count() / kStatesPerExpansion) return;
    const Deadline deadline(limits);
    DeadlineCheck stop(&deadline);
    rooms_ = std::make_unique<SideRooms>(grid(), stop);
    if (stop.has_passed()) rooms_.reset();
  }

  std::uint64_t estimate(Cell cell, StateId id) const {
    return std::max(estimate_.units(cell), bounds_(id));
  }

  /// As people see it.
  double estimate_in_cells(Cell cell) const {
    const auto bound = static_cast<double>(bounds_(grid().number(cell)));
    return std::max(estimate_.cells(cell), bound / units_per_cell());
  }

  /// Was the cell reached more cheaply since?
  bool is_stale(const Entry& entry) const { return nodes_[entry.id].g != entry.g; }

  /// Prefetches what expanding a cell reads: the three rows around it, each of which may lie in two lines of the
  /// cache. Inline: g++ drops calls of a function that only prefetches.
  [[gnu::always_inline]] void fetch_ahead(StateId id) const {
    for (const StateId row : {grid().neighbour(id, 0), id, grid().neighbour(id, 4)}) {
      nodes_.prefetch(row - 1);
      nodes_.prefetch(row + 1);
      __builtin_prefetch(words_ + row - 1);
      __builtin_prefetch(words_ + row + 1);
    }
  }

  /// After a path of an anytime search.
  void go_on() {
    if (kInRounds && outcome() == SearchOutcome::improved) end(SearchOutcome::running);
  }

  SearchOutcome advance(bool once) {
    do {
      expand_next();
    } while (!once && outcome() == SearchOutcome::running);
    if constexpr (kInRounds) {
      if (once && outcome() == SearchOutcome::running && !any_due()) rounds_.end_round(*this);
    }
    return outcome();
  }

  /// Expands one cell, or ends the search.
  [[gnu::always_inline]] void expand_next() {
    while (!queue_.empty()) {
      const Entry entry = queue_.pop();
      if (best_ <= queue_.least_key()) {
        if constexpr (kInRounds) push(entry);
        break;
      }
      if (prefetches_) {
        if (const Entry* later = queue_.after_next()) fetch_ahead(later->id);
      }
      if (is_stale(entry)) continue;
      if (stopped()) {
        if constexpr (kInRounds) {
          push(entry);
          rounds_.limit(*this);
        }
        return;
      }
      if (!expand(entry.id, entry.g)) continue;
      if (overflown_) end(SearchOutcome::cost_overflow);
      if constexpr (kInRounds) hurry();
      return;
    }
    if constexpr (kInRounds) return end_round();
    if (!has_path()) return end(SearchOutcome::exhausted);
    if (stopped()) return;
    end(SearchOutcome::found);
    count_expansion(goal_id());
  }

  /// Ends the round early if the last one has to come.
  void hurry() {
    const bool may = has_path() && !rounds_.goal_is_due() && outcome() == SearchOutcome::running;
    if (may && rounds_.hurries(metrics().expanded)) rounds_.end_round(*this);
  }

  void end_round() {
    if (rounds_.goal_is_due()) {
      if (stopped()) return rounds_.limit(*this);
      count_expansion(goal_id());
      rounds_.set_goal_due(false);
    }
    rounds_.end_round(*this);
  }

  /// Is the goal, which an open entry reaches at this cost, still to be expanded?
  bool is_due(std::uint64_t best) const {
    if constexpr (kInRounds) return best < best_ || rounds_.goal_is_due();
    return best != kNoCost && outcome() == SearchOutcome::running;
  }

  /// Is there something to expand in this round? Drops what comes before it in the queue.
  bool any_due() {
    while (!queue_.empty()) {
      const Entry entry = queue_.pop();
      if (is_stale(entry) || is_dominated(entry)) continue;
      const Cell cell = grid().cell(entry.id);
      if (best_ > queue_.least_key() && estimate_.is_goal(cell)) {
        take_goal(cell, entry.g);
        continue;
      }
      push(entry);
      if (best_ <= queue_.least_key()) break;
      return true;
    }
    return rounds_.goal_is_due();
  }

  /// A goal is expanded last, when no other one can be reached more cheaply.
  void take_goal(Cell cell, std::uint64_t g) {
    if (g >= best_) return;
    best_ = g;
    goal_ = cell;
    if constexpr (kInRounds) rounds_.set_goal_due(true);
  }

  /// g + h of an open cell.
  std::uint64_t total(const Entry& entry) const {
    return entry.g + estimate(grid().cell(entry.id), entry.id);
  }

  /// Puts an entry back into the queue.
  void push(const Entry& entry) {
    queue_.push(rounds_.key(entry.g, estimate(grid().cell(entry.id), entry.id)), entry);
  }

  StateId goal_id() const { return grid().number(goal_); }
  bool has_parent(StateId id) const { return nodes_[id].move() != kNoMove; }
  StateId parent(StateId id) const {
    const Node& node = nodes_[id];
    return grid().neighbour(id, (node.move() + 4U) % kDirections, node.run());
  }

  /// Opens a cell again if the way over its parent has become cheaper since; returns its g.
  std::uint64_t reach_from_parent(StateId id) {
    Node& node = nodes_[id];
    const std::uint64_t steps = Grid::steps(words_[parent(id)]) + Grid::steps(words_[id]);
    const std::uint64_t unit = is_diagonal_move(node.move()) ? Units::kDiagonal : Units::kStraight;
    const std::uint64_t g = nodes_[parent(id)].g + steps * unit * node.run();
    if (g < node.g) {
      nodes_.open(node, static_cast<Cost>(g), Node::arrival_by(node.move(), node.run()));
      push({static_cast<Cost>(g), id});
      count_reached(id, true);
    }
    return node.g;
  }

  /// False if there is nothing to expand yet: the cell is dominated, or a goal.
  [[gnu::always_inline]] bool expand(StateId id, std::uint64_t g) {
    const Cell cell = grid().cell(id);
    const Move arrival = nodes_[id].move();
    const Word word = words_[id];
    const From from{id, cell, g, Grid::steps(word)};
    if (estimate_.is_goal(cell)) {
      take_goal(cell, g);
      return false;
    }
    unsigned moves = grid().moves(arrival, word);
    if (leaps_ && arrival != kNoMove) {
      if (Grid::interior(word)) {
        if (is_diagonal_move(arrival)) return expand_diagonal(from, arrival);
      } else if (!is_diagonal_move(arrival) && Grid::class_of(word) != CostClass::uniform) {
        moves = without_dearer_diagonals(from, arrival, moves);
      }
    }
    close(from.id);
    for (; moves != 0; moves &= moves - 1) {
      const auto direction = static_cast<unsigned>(std::countr_zero(moves));
      if (is_diagonal_move(direction)) {
        step_diagonally(from, direction);
      } else {
        step_straight(from, direction);
      }
    }
    count_open(queue_.size());
    return true;
  }

  void close(StateId id) {
    if constexpr (kInRounds) rounds_.close(nodes_[id]);
    count_expansion(id);
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
    return {direction, length, grid().neighbour(from.id, direction, length),
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
    const Cell cell = grid().cell(entry.id);
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
    close(from.id);
    follow(from, first);
    follow(from, second);
    step_diagonally(from, arrival);
    count_open(queue_.size());
    return true;
  }

  void step_straight(const From& from, unsigned direction) {
    const StateId next = grid().neighbour(from.id, direction);
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
    const StateId next = grid().neighbour(from.id, direction);
    const Cell step = kDirectionSteps[direction];
    reach(next, {from.cell.x + step.x, from.cell.y + step.y},
          from.g + (from.steps + Grid::steps(words_[next])) * Units::kDiagonal,
          Node::arrival_by(direction, 1));
  }

  /// Leaves out the diagonal moves after a straight step that cost at least as much as the diagonal step
  /// from the parent and a straight one.
  unsigned without_dearer_diagonals(const From& from, Move arrival, unsigned moves) const {
    const StateId parent = grid().neighbour(from.id, (arrival + 4U) % kDirections);
    const std::uint64_t parent_steps = Grid::steps(words_[parent]);
    for (const unsigned turn : {1U, 7U}) {
      const unsigned diagonal = (arrival + turn) % kDirections;
      if (((moves >> diagonal) & 1U) == 0) continue;
      const unsigned aside = (arrival + 2 * turn) % kDirections;
      const std::uint64_t via = Grid::steps(words_[grid().neighbour(from.id, aside)]);
      if (via == 0) continue;
      if (!cuts_corners_ && words_[grid().neighbour(parent, aside)] == 0) continue;
      const std::uint64_t to = Grid::steps(words_[grid().neighbour(from.id, diagonal)]);
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
    if (rooms_ != nullptr && rooms_->closed(id)) return;
    const std::uint64_t h = estimate(cell, id);
    const std::uint64_t f = g + h;
    if (f >= best_) return;
    if (f > kMostCost) {
      overflown_ = true;
      return;
    }
    nodes_.open(node, static_cast<Cost>(g), arrival);
    const Entry entry{static_cast<Cost>(g), id};
    if constexpr (kInRounds) {
      if (!reached) node.begin();
      rounds_.open(queue_, node, entry, h);
    } else {
      queue_.push(f, entry);
    }
    count_reached(id, reached);
  }

  CellArrival arrival_of(StateId id) const override {
    const Node& node = nodes_[id];
    const Cell cell = grid().cell(id);
    CellArrival arrival{
        cell, static_cast<double>(node.g) / units_per_cell(), estimate_in_cells(cell), {}};
    if (node.move() != kNoMove) {
      arrival.parent = wend::step(cell, opposite(static_cast<Direction>(node.move())),
                                  static_cast<int>(node.run()));
    }
    return arrival;
  }

  std::shared_ptr<const Grid> grid_;
  std::shared_ptr<const Landmarks> landmarks_;  // null: none, or no longer
  Landmarks::Bounds bounds_;                    // of the present query
  [[no_unique_address]] RoundsIfAny rounds_;
  const Word* words_;
  std::uint64_t log_position_;  // in the grid's log
  WholeEstimate<Units> estimate_;
  bool leaps_;
  bool cuts_corners_;
  bool prefetches_;  // on maps that the caches near a core do not hold
  RunStops stops_;
  std::unique_ptr<SideRooms> rooms_;   // null until they are prepared
  std::uint64_t expanded_before_ = 0;  // by searches since the rooms were lost
  NodeTable<Node, 16> nodes_;
  Queue queue_;
  bool overflown_ = false;
  std::uint64_t best_ = kNoCost;  // of the goals expanded so far
  Cell goal_{};
};

}  // namespace wend
