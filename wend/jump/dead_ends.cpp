#include "wend/jump/dead_ends.hpp"

#include <algorithm>
#include <bit>

namespace wend {
namespace {

struct Run {
  int line;
  int first;
  int last;
};

/// The runs of some lines, and which of them touch.
class Runs {
 public:
  explicit Runs(const BitLines& lines) : begins_(static_cast<std::size_t>(lines.lines()) + 1) {
    for (int line = 0; line < lines.lines(); ++line) {
      begins_[static_cast<std::size_t>(line)] = runs_.size();
      add_runs(lines, line);
    }
    begins_.back() = runs_.size();
    before_.resize(runs_.size());
    behind_.resize(runs_.size());
    degrees_.resize(runs_.size());
    for (int line = 1; line < lines.lines(); ++line) join(line - 1, line);
  }

  std::size_t size() const { return runs_.size(); }
  const Run& operator[](std::size_t run) const { return runs_[run]; }

  /// The number of remaining runs that touch it.
  std::uint32_t degree(std::size_t run) const { return degrees_[run]; }

  /// The one run that touches a run of degree 1.
  std::size_t only_neighbour(std::size_t run) const {
    for (const Range& range : {before_[run], behind_[run]}) {
      for (std::size_t other = range.begin; other < range.end; ++other) {
        if (degrees_[other] != kTaken) return other;
      }
    }
    return run;
  }

  void take_away(std::size_t run, std::size_t neighbour) {
    degrees_[run] = kTaken;
    --degrees_[neighbour];
  }

 private:
  static constexpr std::uint32_t kTaken = static_cast<std::uint32_t>(-1);

  struct Range {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  void add_runs(const BitLines& lines, int line) {
    const auto words = lines.words(line);
    int begin = -1;  // of the current run
    for (std::size_t i = 0; i < words.size(); ++i) {
      std::uint64_t word = words[i];
      for (int bit = 0; bit < 64;) {
        const int at = static_cast<int>(i) * 64 + bit - 1;
        if (begin < 0) {
          if (word == 0) break;
          const int skip = std::countr_zero(word);
          begin = at + skip;
          bit += skip;
          word >>= skip;
        } else {
          const int skip = std::countr_one(word);
          bit += skip;
          if (bit >= 64) break;
          runs_.push_back({line, begin, at + skip - 1});
          begin = -1;
          word = skip < 64 ? word >> skip : 0;
        }
      }
    }
  }

  /// Records which runs of two neighbouring lines touch, from left to right.
  void join(int one_line, int other_line) {
    std::size_t other = begins_[static_cast<std::size_t>(other_line)];
    const std::size_t end = begins_[static_cast<std::size_t>(other_line) + 1];
    for (std::size_t run = begins_[static_cast<std::size_t>(one_line)];
         run < begins_[static_cast<std::size_t>(one_line) + 1]; ++run) {
      while (other < end && runs_[other].last < runs_[run].first) ++other;
      std::size_t behind = other;
      for (; behind < end && runs_[behind].first <= runs_[run].last; ++behind) {
        ++degrees_[run];
        ++degrees_[behind];
        if (before_[behind].end == 0) before_[behind].begin = run;
        before_[behind].end = run + 1;
      }
      behind_[run] = {other, behind};
    }
  }

  std::vector<Run> runs_;
  std::vector<std::size_t> begins_;  // by line
  std::vector<Range> before_;        // by run: those that touch it in the line before
  std::vector<Range> behind_;
  std::vector<std::uint32_t> degrees_;
};

/// A removed run, and where it touched the run that it led to.
struct Record {
  bool is_row;  // else a column
  int line;
  int first;  // along the line, both inclusive
  int last;
  int exit_line;
  int exit_first;
  int exit_last;
};

Cell cell_at(bool is_row, int line, int at) { return is_row ? Cell{at, line} : Cell{line, at}; }

/// Removes dead ends, alternating between rows and columns.
class Peeling {
 public:
  explicit Peeling(const BitLines& rows)
      : core_(rows), numbers_(rows.length(), rows.lines(), DeadEnds::kCore) {
    // A round that removes little is not worth its time.
    constexpr std::size_t kLeastShare = 400;
    const std::size_t least = numbers_.size() / kLeastShare;
    bool by_rows = true;
    for (int idle = 0; idle < 2; by_rows = !by_rows) {
      idle = peel(by_rows) > least ? 0 : idle + 1;
    }
  }

  std::size_t cells() const { return cells_; }
  const std::vector<Record>& records() const { return records_; }
  Grid<std::uint32_t>& numbers() { return numbers_; }

 private:
  /// Runs one round. Returns the number of cells removed.
  std::size_t peel(bool by_rows) {
    Runs runs(by_rows ? core_ : core_.transposed());
    std::vector<std::size_t> leaves;
    for (std::size_t run = 0; run < runs.size(); ++run) {
      if (runs.degree(run) == 1) leaves.push_back(run);
    }
    const std::size_t cells_before = cells_;
    while (!leaves.empty()) {
      const std::size_t leaf = leaves.back();
      leaves.pop_back();
      if (runs.degree(leaf) != 1) continue;  // its neighbour was removed
      const std::size_t neighbour = runs.only_neighbour(leaf);
      runs.take_away(leaf, neighbour);
      write_down(by_rows, runs[leaf], runs[neighbour]);
      if (runs.degree(neighbour) == 1) leaves.push_back(neighbour);
    }
    return cells_ - cells_before;
  }

  void write_down(bool by_rows, const Run& run, const Run& exit) {
    records_.push_back({by_rows, run.line, run.first, run.last, exit.line,
                        std::max(run.first, exit.first), std::min(run.last, exit.last)});
    const auto number = static_cast<std::uint32_t>(records_.size());
    for (int at = run.first; at <= run.last; ++at) {
      const Cell cell = cell_at(by_rows, run.line, at);
      numbers_[cell] = number;
      core_.reset(cell.y, cell.x);
    }
    cells_ += static_cast<std::size_t>(run.last - run.first + 1);
  }

  BitLines core_;  // by rows
  Grid<std::uint32_t> numbers_;
  std::vector<Record> records_;
  std::size_t cells_ = 0;
};

bool has_jump_point(const Record& record, const BitLines& jump_points) {
  for (int at = record.first; at <= record.last; ++at) {
    const Cell cell = cell_at(record.is_row, record.line, at);
    if (jump_points.get(cell.y, cell.x)) return true;
  }
  return false;
}

}  // namespace

DeadEnds::DeadEnds(const JumpBoards& boards) {
  Peeling peeling(boards.rows());
  numbers_ = std::move(peeling.numbers());
  cells_ = peeling.cells();
  const std::vector<Record>& records = peeling.records();
  const BitLines jump_points = boards.jump_points();

  // Dead ends lead to ones that were removed later, so a loop from the last to the first already knows
  // their exits. It writes the lists in that order; they are reversed at the end.
  std::vector<bool> jumps(records.size() + 1);
  std::vector<std::size_t> ends(records.size() + 2);
  for (std::size_t number = records.size(); number > 0; --number) {
    const Record& record = records[number - 1];
    const std::size_t begin = exit_numbers_.size();
    const auto add = [&](std::uint32_t exit) {
      if (std::find(exit_numbers_.begin() + static_cast<std::ptrdiff_t>(begin), exit_numbers_.end(),
                    exit) == exit_numbers_.end()) {
        exit_numbers_.push_back(exit);
      }
    };
    std::uint32_t last = kCore;
    for (int at = record.exit_first; at <= record.exit_last; ++at) {
      const std::uint32_t exit = numbers_[cell_at(record.is_row, record.exit_line, at)];
      if (exit == kCore || exit == last) continue;
      last = exit;
      if (jumps[exit]) {
        add(exit);
      } else {
        for (std::size_t i = ends[exit + 1]; i < ends[exit]; ++i) add(exit_numbers_[i]);
      }
    }
    jumps[number] = has_jump_point(record, jump_points);
    ends[number] = exit_numbers_.size();
  }
  std::reverse(exit_numbers_.begin(), exit_numbers_.end());
  exits_.resize(records.size() + 2);
  for (std::size_t number = 1; number < exits_.size(); ++number) {
    exits_[number] = exit_numbers_.size() - ends[number];
  }
}

void OpenDeadEnds::open_for(Cell start, std::span<const Cell> goals) {
  if (++query_ == 0) {  // the numbers of queries have run out
    std::fill(opened_.begin(), opened_.end(), 0);
    query_ = 1;
  }
  opened_[DeadEnds::kCore] = query_;
  open(number(start));
  for (const Cell goal : goals) open(number(goal));
  for (const std::uint32_t kept : kept_open_) open(kept);
}

void OpenDeadEnds::keep_open(std::span<const Cell> cells) {
  for (const Cell cell : cells) {
    const std::uint32_t here = number(cell);
    if (here != DeadEnds::kCore) kept_open_.push_back(here);
  }
  std::ranges::sort(kept_open_);
  const auto repeated = std::ranges::unique(kept_open_);
  kept_open_.erase(repeated.begin(), repeated.end());
}

void OpenDeadEnds::open(std::uint32_t first) {
  push(first);
  while (!pending_.empty()) {
    const std::uint32_t next = pending_.back();
    pending_.pop_back();
    for (const std::uint32_t exit : dead_ends_->exits(next)) push(exit);
  }
}

void OpenDeadEnds::push(std::uint32_t number) {
  if (opened_[number] == query_) return;
  opened_[number] = query_;
  pending_.push_back(number);
}

}  // namespace wend
