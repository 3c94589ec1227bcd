// A random walk with a short memory: orthogonal steps, and no cell that was visited a moment ago
// unless it is the only way. The planner to be better than.

#include <algorithm>
#include <array>
#include <cmath>

#include "wend/base/random.hpp"
#include "wend/planner/grid/grid_planner.hpp"
#include "wend/planner/search_status.hpp"
#include "wend/search/limit_check.hpp"
#include "wend/search/node_table.hpp"
#include "wend/space/grid/grid_path.hpp"
#include "wend/space/grid/grid_space.hpp"

namespace wend {
namespace {

constexpr double kMostSteps = 1e8;  // a walk keeps 8 bytes a step

struct RandomWalkOptions {
  std::int64_t max_steps = 1'000'000;
  std::int64_t seed = 1;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"max_steps",
           "limit on the number of steps; the walk avoids the cells of its last "
           "floor(sqrt(max_steps)) steps"},
          self.max_steps, OptionRange{0, kMostSteps});
    field({"seed", "seed of the random numbers: each seed gives another walk"}, self.seed,
          OptionRange{0, 9e15});
  }
};

constexpr GridMoves kOrthogonal{Connectivity::four, CornerRule::none};

/// When each cell was visited last, as far as this walk remembers.
class ShortMemory {
 public:
  ShortMemory(std::size_t cells, std::uint32_t length)
      : length_(length), visits_(static_cast<StateId>(cells)) {}

  bool allocated() const { return visits_.allocated(); }
  void clear() { visits_.begin_search(); }
  void add(StateId cell, std::uint32_t step) { visits_.open(visits_[cell], step, kNoMove); }

  /// Was the cell visited in the last steps before `now`?
  bool holds(StateId cell, std::uint32_t now) const {
    const auto& visit = visits_[cell];
    return visits_.reached(visit) && now - visit.g < length_;
  }

 private:
  std::uint32_t length_;
  NodeTable<std::uint32_t> visits_;  // g is the step
};

class RandomWalkPlanner final : public Planner {
 public:
  RandomWalkPlanner(FreeSpace space, RandomWalkOptions options)
      : Planner(std::move(space)),
        options_(options),
        grid_(free_space(), kOrthogonal),
        memory_(free_space().map().size(), memory_length()) {}

  bool allocated() const { return memory_.allocated(); }

 private:
  std::optional<Status> do_check(const Query& query) override {
    return cells_.assign(free_space(), kOrthogonal.adjacency(), query);
  }

  Status do_plan(const Query& query, Plan& out) override {
    begin_walk(query.limits, query.observer, out);
    for (;;) {
      if (const auto outcome = walk_on(out)) return *outcome;
    }
  }

  std::optional<Status> do_begin(const Query& query, Plan& out) override {
    stepped_limits_ = query.limits;
    begin_walk(stepped_limits_, query.observer, out);
    return std::nullopt;
  }

  std::optional<Status> do_step(Plan& out) override { return walk_on(out); }

  /// It keeps no frontier: it goes on from where it is.
  OpenList do_open_list(std::size_t most) const override {
    OpenList list{{}, 1};
    if (most > 0) list.entries.push_back({event(last_)});
    return list;
  }

  std::string do_reason(const Query& query, Status status) const override {
    return reason_in_cells(free_space(), query, status);
  }

  void do_update(std::span<const Cell> /*changed*/) override {
    grid_ = ExactGrid(free_space(), kOrthogonal);
    memory_ = ShortMemory(free_space().map().size(), memory_length());
  }

  std::uint32_t memory_length() const {
    return static_cast<std::uint32_t>(std::sqrt(static_cast<double>(options_.max_steps)));
  }

  /// Both are needed as long as the walk goes on.
  void begin_walk(const Limits& limits, SearchObserver* observer, Plan& out) {
    limits_.begin(limits);
    observer_ = observer;
    random_ = Random(static_cast<std::uint64_t>(options_.seed));
    memory_.clear();
    steps_ = 0;
    here_ = grid_.state(cells_.start);
    arrive(out, std::nullopt);
  }

  void arrive(Plan& out, std::optional<Cell> from) {
    out.path.append(here_.cell);
    memory_.add(here_.number, steps_);
    ++out.metrics.generated;
    out.metrics.max_frontier = 1;
    if (observer_ != nullptr) observer_->on_generate(event(from));
    last_ = from;
  }

  SearchEvent event(std::optional<Cell> from) const {
    const double steps = steps_;
    return {here_.cell, from, steps, 0, steps};
  }

  /// One step; an outcome if the walk is over.
  std::optional<Status> walk_on(Plan& out) {
    if (const auto status = stopped(out.metrics.expanded)) return give_up(*status, out);
    ++out.metrics.expanded;
    if (observer_ != nullptr) observer_->on_expand(event(last_));
    if (std::find(cells_.goals.begin(), cells_.goals.end(), here_.cell) != cells_.goals.end()) {
      out.cost = grid_path_cost(free_space(), out.path.cells());
      return Status::found;
    }
    if (steps_ == options_.max_steps) return give_up(Status::step_limit, out);
    const Cell from = here_.cell;
    here_ = random_neighbour();
    ++steps_;
    arrive(out, from);
    return std::nullopt;
  }

  static Status give_up(Status status, Plan& out) {
    out.path.clear();
    return status;
  }

  std::optional<Status> stopped(std::uint64_t expanded) {
    if (!limits_.due(expanded)) return std::nullopt;
    const SearchOutcome outcome = limits_.look(expanded);
    if (outcome == SearchOutcome::running) return std::nullopt;
    return status_of(outcome);
  }

  /// One of the neighbours that are not remembered, or, if there is none, one of all. There is one:
  /// the goal is another cell of the same component.
  GridState random_neighbour() {
    std::array<GridState, 4> fresh;
    std::array<GridState, 4> all;
    std::size_t fresh_count = 0;
    std::size_t count = 0;
    grid_.for_each_successor(here_, kNoMove, [&](const GridState& next, Move, std::uint64_t) {
      all[count++] = next;
      if (!memory_.holds(next.number, steps_)) fresh[fresh_count++] = next;
    });
    return fresh_count > 0 ? fresh[random_.below(fresh_count)] : all[random_.below(count)];
  }

  RandomWalkOptions options_;
  ExactGrid grid_;
  ShortMemory memory_;
  GridQuery cells_;
  Random random_{0};
  GridState here_;
  std::optional<Cell> last_;
  std::uint32_t steps_ = 0;
  LimitCheck limits_;
  SearchObserver* observer_ = nullptr;
  Limits stepped_limits_;  // of a walk that is stepped
};

PlannerResult make(const FreeSpace& space, const OptionValues& values) {
  const auto options = parse_options<RandomWalkOptions>(values);
  if (!options) {
    return Unexpected<PlannerError>({Status::invalid_option, options.error().message()});
  }
  auto planner = std::make_unique<RandomWalkPlanner>(space, *options);
  if (!planner->allocated()) {
    return Unexpected<PlannerError>(
        {Status::memory_limit, "not enough memory for the cells that the walk remembers"});
  }
  return planner;
}

}  // namespace

PlannerInfo random_walk_planner() {
  return {.name = "random_walk",
          .summary = "Random walk with a short memory, on 4 neighbours",
          .idea =
              "At every step it moves to a random one of the 4 neighbours and avoids the cells "
              "that it has just left if there is another. It has no frontier and does not use the "
              "position of the goal.",
          .citation = "Pearson 1905",
          .guarantee_text = "none: the walk ends after max_steps",
          .time = "O(s) in the s steps taken; max_steps is the only bound on s",
          .memory = "8 bytes per cell and 8 per step",
          .bytes_per_cell = 8,
          .when =
              "As a baseline that every planner must beat, and to test how a program handles a "
              "planner that fails. Not for execution on a robot.",
          .guarantee = Guarantee::none,
          .plans_on_terrain = false,
          .preprocessing = Preprocessing::none,
          .can_step = true,
          .options = option_schema<RandomWalkOptions>(),
          .make = make};
}

}  // namespace wend
