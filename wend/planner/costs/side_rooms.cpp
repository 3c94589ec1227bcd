#include "wend/planner/costs/side_rooms.hpp"

#include <bit>
#include <functional>
#include <queue>
#include <utility>

#include "wend/base/zeroed_memory.hpp"
#include "wend/jump/bit_lines.hpp"
#include "wend/space/grid/cost_units.hpp"

namespace wend {
namespace {

constexpr int kWidestDoor = 16;           // cells
constexpr std::uint32_t kLeastRoom = 32;  // cells

/// Is a room worth the search at its door, which may see as many cells as the square of its width?
bool pays(std::uint32_t cells, int door) {
  return door <= kWidestDoor && cells >= kLeastRoom &&
         cells >= static_cast<std::uint32_t>(door * door);
}

struct FoundRun {
  int line;
  int begin;
  int end;
  std::uint32_t number = 0;  // in the order of the search, from 1 on; 0: not reached yet
  std::uint32_t low = 0;     // the least number that a run of its subtree touches
  std::uint32_t parent = 0;
  std::uint32_t next = 0;   // the next run that it may touch
  std::uint32_t cells = 0;  // of the subtree
};

/// A run that separates a subtree of the search from all else.
struct Door {
  std::uint32_t run;
  std::uint32_t begin;  // the numbers of the runs behind it
  std::uint32_t end;
  std::uint32_t cells;
};

template <class Word>
BitLines free_rows(const CostGrid<Word>& grid) {
  BitLines free(grid.height(), grid.width());
  for (int y = 0; y < grid.height(); ++y) {
    const auto words = free.words(y);
    const Word* row = grid.words() + grid.number({0, y});
    for (std::size_t x = 0; x < static_cast<std::size_t>(grid.width()); ++x) {
      words[(x + 1) / 64] |= std::uint64_t{row[x] != 0} << ((x + 1) % 64);
    }
  }
  return free;
}

/// The runs of some lines, and a depth-first search of them. (R. Tarjan, "Depth-First Search and Linear Graph Algorithms",
/// 1972.)
class RunTree {
 public:
  explicit RunTree(const BitLines& free) {
    for (int line = 0; line < free.lines(); ++line) {
      first_.push_back(static_cast<std::uint32_t>(runs_.size()));
      find_runs(free.words(line), line);
    }
    first_.push_back(static_cast<std::uint32_t>(runs_.size()));
  }

  const std::vector<std::uint32_t>& first() const { return first_; }
  const std::vector<FoundRun>& runs() const { return runs_; }
  std::size_t cells() const { return cells_; }

  /// The doors that separate something, the outer ones first.
  std::vector<Door> doors(DeadlineCheck& stop) {
    for (std::uint32_t root = 0; root < runs_.size() && !stop(); ++root) {
      if (runs_[root].number == 0) search_from(root, stop);
    }
    std::ranges::sort(doors_, {}, &Door::begin);
    return std::move(doors_);
  }

  /// Calls take(run) for the runs that touch a run.
  template <class Take>
  void for_touching(const FoundRun& run, Take&& take) const {
    for (const int line : {run.line - 1, run.line + 1}) {
      for (std::uint32_t i = first_touching(line, run); touches(i, line, run); ++i) take(runs_[i]);
    }
  }

 private:
  void find_runs(std::span<const std::uint64_t> words, int line) {
    std::uint64_t before = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
      std::uint64_t edges = words[i] ^ (words[i] << 1U | before);
      before = words[i] >> 63U;
      for (; edges != 0; edges &= edges - 1) {
        const int at = static_cast<int>(64 * i) + std::countr_zero(edges) - 1;
        if ((words[i] & edges & (~edges + 1)) != 0) {
          runs_.push_back({line, at, at});
        } else {
          runs_.back().end = at;
          cells_ += static_cast<std::size_t>(at - runs_.back().begin);
        }
      }
    }
  }

  std::uint32_t first_touching(int line, const FoundRun& run) const {
    if (line < 0 || line + 1 >= static_cast<int>(first_.size())) return 0;
    const auto begin = runs_.begin() + first_[static_cast<std::size_t>(line)];
    const auto end = runs_.begin() + first_[static_cast<std::size_t>(line) + 1];
    return static_cast<std::uint32_t>(
        std::ranges::lower_bound(begin, end, run.begin, {}, &FoundRun::end) - runs_.begin());
  }
  bool touches(std::uint32_t i, int line, const FoundRun& run) const {
    return i < runs_.size() && runs_[i].line == line && runs_[i].begin <= run.end;
  }

  void reach(std::uint32_t at, std::uint32_t parent) {
    FoundRun& run = runs_[at];
    run.number = run.low = ++reached_;
    run.parent = parent;
    run.cells = static_cast<std::uint32_t>(run.end - run.begin);
    run.next = first_touching(run.line - 1, run);
  }

  /// The next run that this one touches; itself after the last.
  std::uint32_t take_next(std::uint32_t at) {
    FoundRun& run = runs_[at];
    if (run.next <= at) {  // the line before
      if (touches(run.next, run.line - 1, run)) return run.next++;
      run.next = std::max(first_touching(run.line + 1, run), at + 1);
    }
    return touches(run.next, run.line + 1, run) ? run.next++ : at;
  }

  void search_from(std::uint32_t root, DeadlineCheck& stop) {
    reach(root, root);
    for (std::uint32_t at = root; !stop();) {
      const std::uint32_t next = take_next(at);
      if (next != at) {
        if (runs_[next].number == 0) {
          reach(next, at);
          at = next;
        } else {
          runs_[at].low = std::min(runs_[at].low, runs_[next].number);
        }
        continue;
      }
      if (at == root) return;
      const std::uint32_t parent = runs_[at].parent;
      leave(runs_[at], runs_[parent], parent);
      at = parent;
    }
  }

  void leave(const FoundRun& run, FoundRun& parent, std::uint32_t parent_at) {
    parent.low = std::min(parent.low, run.low);
    parent.cells += run.cells;
    if (run.low < parent.number || !pays(run.cells, parent.end - parent.begin)) return;
    doors_.push_back({parent_at, run.number, reached_ + 1, run.cells});
  }

  std::vector<std::uint32_t> first_;  // run of each line, and the end
  std::vector<FoundRun> runs_;
  std::size_t cells_ = 0;
  std::uint32_t reached_ = 0;
  std::vector<Door> doors_;
};

}  // namespace

template <class Word>
class SideRooms::Finder {
 public:
  Finder(SideRooms& rooms, const CostGrid<Word>& grid)
      : rooms_(rooms), grid_(grid), costs_(zeroed_table<std::uint64_t>(grid.state_count())) {}

  /// By rows, or by columns. Without memory there are no rooms.
  void find(const BitLines& free, std::size_t by_columns, DeadlineCheck& stop) {
    if (costs_ == nullptr) return;
    RunTree tree(free);
    const std::vector<Door> doors = tree.doors(stop);
    std::vector<Door> around;  // the doors of the rooms that the present one lies in
    for (const Door& door : doors) {
      if (stop.now()) return;
      while (!around.empty() && around.back().end <= door.begin) around.pop_back();
      // A room that is nearly all, or differs little from another, is of no use.
      if (door.cells > tree.cells() / 2) continue;
      if (!around.empty() && door.cells > around.back().cells / 2) continue;
      if (!is_door(tree, door, by_columns)) continue;
      around.push_back(door);
      const auto first = static_cast<std::uint32_t>(rooms_.entries_.size());
      for (const Entry& entry : entries_) rooms_.entries_.push_back(entry.id);
      rooms_.doors_.insert(rooms_.doors_.end(), door_.begin(), door_.end());
      rooms_.rooms_.push_back({by_columns, door.begin, door.end, first,
                               static_cast<std::uint32_t>(rooms_.entries_.size())});
    }
    Runs& lines = rooms_.lines_[by_columns];
    lines.first = tree.first();
    for (const FoundRun& run : tree.runs()) lines.runs.push_back({run.begin, run.number});
  }

 private:
  struct Entry {
    std::uint64_t cost;
    StateId id;
    bool operator>(const Entry& other) const { return cost > other.cost; }
  };

  static constexpr std::uint64_t kDoor = std::uint64_t{1} << 63U;

  StateId number(std::size_t by_columns, int line, int at) const {
    return grid_.number(by_columns != 0 ? Cell{line, at} : Cell{at, line});
  }
  std::uint64_t step(StateId from, StateId to, unsigned direction) const {
    const auto sum =
        CostGrid<Word>::steps(grid_.word(from)) + CostGrid<Word>::steps(grid_.word(to));
    return sum * ((direction & 1U) != 0 ? CostUnits::kDiagonal : CostUnits::kStraight);
  }

  /// Is every path from one cell of the run to another through what lies behind it dearer than the one along the run? If
  /// so, door_ and entries_ are those of the room.
  bool is_door(const RunTree& tree, const Door& door, std::size_t by_columns) {
    const FoundRun& run = tree.runs()[door.run];
    door_.clear();
    entries_.clear();
    for (int at = run.begin; at < run.end; ++at) door_.push_back(number(by_columns, run.line, at));
    tree.for_touching(run, [&](const FoundRun& other) {
      if (other.number < door.begin || other.number >= door.end) return;
      const int end = std::min(other.end, run.end + 1);
      for (int at = std::max(other.begin, run.begin - 1); at < end; ++at) {
        entries_.push_back({0, number(by_columns, other.line, at)});
      }
    });
    const bool dearer = is_dearer_behind();
    for (const StateId id : touched_) costs_[id] = 0;
    touched_.clear();
    return dearer;
  }

  /// Dijkstra's algorithm from all cells of the door at once, each at its cost along the door from the first one: so a cell
  /// of the door is reached more cheaply from behind only if a path from an earlier one is.
  bool is_dearer_behind() {
    std::uint64_t along = 0;
    for (std::size_t i = 0; i < door_.size(); ++i) {
      if (i > 0) along += step(door_[i - 1], door_[i], 0);
      put(door_[i], kDoor | along);
    }
    open_ = {};
    for (const Entry& entry : entries_) {
      for (unsigned direction = 0; direction < kDirections; ++direction) {
        const StateId from = grid_.neighbour(entry.id, direction);
        if ((costs_[from] & kDoor) == 0) continue;
        reach(entry.id, (costs_[from] & ~kDoor) + step(from, entry.id, direction), along);
      }
    }
    while (!open_.empty()) {
      const Entry at = open_.top();
      open_.pop();
      if (costs_[at.id] != at.cost) continue;
      for (unsigned direction = 0; direction < kDirections; ++direction) {
        const StateId to = grid_.neighbour(at.id, direction);
        if (grid_.word(to) == 0) continue;
        const std::uint64_t cost = at.cost + step(at.id, to, direction);
        if ((costs_[to] & kDoor) == 0) {
          reach(to, cost, along);
        } else if (cost <= (costs_[to] & ~kDoor)) {
          return false;
        }
      }
    }
    return true;
  }

  void reach(StateId id, std::uint64_t cost, std::uint64_t most) {
    if (cost >= most || (costs_[id] != 0 && costs_[id] <= cost)) return;
    put(id, cost);
    open_.push({cost, id});
  }
  void put(StateId id, std::uint64_t cost) {
    if (costs_[id] == 0) touched_.push_back(id);
    costs_[id] = cost;
  }

  SideRooms& rooms_;
  const CostGrid<Word>& grid_;
  ZeroedTable<std::uint64_t> costs_;  // 0: not reached
  std::vector<StateId> touched_;
  std::vector<StateId> door_;
  std::vector<Entry> entries_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

template <class Word>
SideRooms::SideRooms(const CostGrid<Word>& grid, DeadlineCheck& stop)
    : closed_((grid.state_count() + 63) / 64) {
  const BitLines free = free_rows(grid);
  Finder<Word> finder(*this, grid);
  finder.find(free, 0, stop);
  finder.find(free.transposed(), 1, stop);
  std::ranges::sort(doors_);
  for (const Room& room : rooms_) set(room, true);
}

std::uint32_t SideRooms::Runs::number_at(int line, int at) const {
  const auto begin = runs.begin() + first[static_cast<std::size_t>(line)];
  const auto end = runs.begin() + first[static_cast<std::size_t>(line) + 1];
  return std::prev(std::ranges::upper_bound(begin, end, at, {}, &Run::begin))->number;
}

void SideRooms::close_for(Cell start, std::span<const GoalRegion> goals) {
  if (rooms_.empty()) return;
  for (const std::uint32_t room : open_) set(rooms_[room], true);
  open_.clear();
  const bool one = goals.size() == 1 && goals.front().is_one_place();
  const auto here = numbers_of(start);
  const auto there = one ? numbers_of(goals.front().any()) : here;
  for (std::uint32_t i = 0; i < rooms_.size(); ++i) {
    if (!one || contains(rooms_[i], here) || contains(rooms_[i], there)) open_.push_back(i);
  }
  for (const std::uint32_t room : open_) set(rooms_[room], false);
}

void SideRooms::set(const Room& room, bool closed) {
  for (std::uint32_t i = room.first_entry; i < room.end_of_entries; ++i) {
    const StateId id = entries_[i];
    const std::uint64_t bit = std::uint64_t{1} << (id % 64);
    closed_[id / 64] = closed ? closed_[id / 64] | bit : closed_[id / 64] & ~bit;
  }
}

template SideRooms::SideRooms(const CostGrid<std::uint32_t>&, DeadlineCheck&);
template SideRooms::SideRooms(const CostGrid<std::uint64_t>&, DeadlineCheck&);

}  // namespace wend
