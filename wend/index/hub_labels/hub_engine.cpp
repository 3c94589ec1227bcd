// The engine that answers queries from the sections of a label index (hub_index.hpp).

#include <algorithm>
#include <cstdlib>

#include "wend/index/hub_labels/hub_sections.hpp"
#include "wend/index/run_writer.hpp"
#include "wend/jump/jump_boards.hpp"

namespace wend {
namespace {

/// The index in a record of the corner by which its i-th hub is reached.
template <class Record>
std::uint32_t corner_of(const Record& record, std::uint32_t i) {
  std::uint32_t corner = 0;
  while (i >= record.count(corner)) i -= record.count(corner++);
  return corner;
}

/// Prefetches an element if it exists.
template <class T>
void prefetch(std::span<const T> array, std::size_t place) {
  if (place < array.size()) __builtin_prefetch(array.data() + place);
}

/// Calls visit(i, cost) for the hubs of a record, with the costs from one of its cells.
template <class Record, class Visit>
void for_costs(const Record& record, Cell cell, Visit&& visit) {
  std::uint32_t i = 0;
  for (std::uint32_t corner = 0; corner < record.corner_count(); ++corner) {
    const auto to_corner = octile_cost<CornerCost>(cell, record.cell(corner));
    const std::uint32_t end = i + record.count(corner);
    for (; i < end; ++i) visit(i, to_corner + record.cost(i));
  }
}

/// Hub is std::uint16_t, or std::uint32_t if 16 bits do not name all hubs.
template <class Hub>
class HubEngine final : public IndexEngine {
 public:
  /// Keeps the bytes that contain the sections.
  HubEngine(IndexBytes index, const HubSections& sections, const BitGrid& passable)
      : index_(std::move(index)),
        sections_(sections),
        width_(static_cast<std::size_t>(passable.width())),
        sight_(passable),
        sums_(sections.hub_count, kNoSum) {}

  OctileSteps find(Cell start, Cell goal) override {
    start_ = start;
    goal_ = goal;
    const Record from = record_of(start);
    const Record to = record_of(goal);
    metrics_ = {1, 1, 1};
    if (sight_.sees(start, goal)) {
      way_ = {octile_cost<CornerCost>(start, goal),
              goal,
              goal,
              {},
              octile_cost<CornerCost>(start, goal)};
    } else if (sight_.sees(goal, start)) {
      way_ = {octile_cost<CornerCost>(start, goal), start, start, {}, 0};
    } else {
      way_ = way_by_hub(from, to);
      if (!from.is_corner() && !to.is_corner()) {
        if (to.corner_count() <= from.corner_count()) {
          improve_by_sight(to, goal, start, way_);
        } else {
          improve_by_sight(from, start, goal, way_);
        }
      }
      metrics_.expanded += from.hub_count() + to.hub_count();
      metrics_.generated = metrics_.expanded;
    }
    return octile_steps_of(way_.cost);
  }

  void write(std::span<Cell> cells) override {
    // Looks up both before writing anything, so that one does not wait for the other.
    const std::uint32_t up = way_.hub ? place_of(way_.first, *way_.hub) : run_word::kHub;
    const std::uint32_t down = way_.hub ? place_of(way_.last, *way_.hub) : run_word::kHub;
    prefetch(sections_.runs, up);
    prefetch(sections_.runs, down);
    cells.front() = start_;
    const std::size_t steps = cells.size() - 1;
    RunWriter<1> upwards(cells.data() + 1, steps, start_);
    upwards.go_to(way_.first);
    follow(up, upwards);
    cells.back() = goal_;  // the upward writer may have overwritten it
    // The downward writer must not overwrite the upward part.
    const std::size_t met = octile_steps_of(way_.cost_to_middle).cells() - 1;
    RunWriter<-1> downwards(&cells.back() - 1, steps - std::min(met, steps), goal_);
    downwards.go_to(way_.last);
    follow(down, downwards);
  }

  SearchMetrics metrics() const override { return metrics_; }

 private:
  using Record = HubRecord<Hub>;

  /// A cost in the upper half; in the lower half, the index in the record of the hub that it leads to.
  using Sum = std::uint64_t;
  static constexpr Sum kNoSum = Sum{1} << 63U;
  static constexpr unsigned kHalf = 32;  // bits

  /// A path that goes diagonally first from the start to `first` and from the goal to `last`. In between
  /// it passes a hub, or these are the same cell.
  struct Way {
    CornerCost cost = kUnreachedCost;
    Cell first;
    Cell last;
    std::optional<Hub> hub;
    CornerCost cost_to_middle = 0;  // from the start to the hub, or to that cell
  };

  std::size_t number_of(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * width_ + static_cast<std::size_t>(cell.x);
  }
  Record record_of(Cell cell) const {
    return Record(sections_.records.data() + sections_.record_of_cell[number_of(cell)]);
  }

  Way way_by_hub(const Record& from, const Record& to) {
    note_sums(from);
    Sum least = kNoSum;
    std::uint32_t last = 0;
    for_costs(to, goal_, [&](std::uint32_t i, CornerCost cost) {
      const Sum sum = sums_[to.hub(i)] + (Sum{cost} << kHalf);
      if (sum < least) {
        least = sum;
        last = i;
      }
    });
    forget_sums(from);
    if (least == kNoSum) return {};
    const auto first = static_cast<std::uint32_t>(least);
    const std::uint32_t corner = corner_of(from, first);
    const Cell first_cell = from.cell(corner);
    return {static_cast<CornerCost>(least >> kHalf), first_cell, to.cell(corner_of(to, last)),
            to.hub(last), octile_cost<CornerCost>(start_, first_cell) + from.cost(first)};
  }

  void note_sums(const Record& from) {
    for_costs(from, start_, [&](std::uint32_t i, CornerCost cost) {
      Sum& sum = sums_[from.hub(i)];
      sum = std::min(sum, Sum{cost} << kHalf | i);
    });
  }

  void forget_sums(const Record& from) {
    for (const Hub hub : from.hubs()) sums_[hub] = kNoSum;
  }

  /// Takes the path by a first corner of one end that the other end sees, if it is shorter.
  void improve_by_sight(const Record& seen, Cell own, Cell other, Way& way) const {
    for (std::uint32_t i = 0; i < seen.corner_count(); ++i) {
      const Cell corner = seen.cell(i);
      const CornerCost cost =
          octile_cost<CornerCost>(own, corner) + octile_cost<CornerCost>(corner, other);
      if (cost < way.cost && sight_.sees(other, corner)) {
        way = {cost, corner, corner, {}, octile_cost<CornerCost>(start_, corner)};
      }
    }
  }

  std::uint32_t place_of(Cell corner, Hub hub) const {
    const Record record = record_of(corner);
    const auto hubs = record.hubs();
    const auto found = std::lower_bound(hubs.begin(), hubs.end(), hub);
    if (found == hubs.end()) return run_word::kHub;
    return record.place(static_cast<std::uint32_t>(found - hubs.begin()));
  }

  template <int kWay>
  void follow(std::uint32_t place, RunWriter<kWay>& writer) const {
    while (place < sections_.runs.size()) {
      const RunWord* word = sections_.runs.data() + place;
      if (*word == run_word::kJoint) return;  // a joint leads to a run
      for (; *word != run_word::kJoint; ++word) {
        writer.run(run_word::direction(*word), run_word::steps(*word));
      }
      place = word[1] | static_cast<std::uint32_t>(word[2]) << 16U;
      if (writer.room() == 0) return;
    }
  }

  IndexBytes index_;
  HubSections sections_;
  std::size_t width_;
  Sight sight_;
  std::vector<Sum> sums_;  // by hub: from the start; kNoSum between queries
  Cell start_;
  Cell goal_;
  Way way_;
  SearchMetrics metrics_;
};

}  // namespace

std::unique_ptr<IndexEngine> make_hub_engine(IndexBytes index, const HubSections& sections,
                                             const BitGrid& passable) {
  if (sections.hub_count <= HubSections::kMostShortHubs) {
    return std::make_unique<HubEngine<std::uint16_t>>(std::move(index), sections, passable);
  }
  return std::make_unique<HubEngine<std::uint32_t>>(std::move(index), sections, passable);
}

}  // namespace wend
