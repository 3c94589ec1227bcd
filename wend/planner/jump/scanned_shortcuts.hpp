#pragma once

// ScannedShortcuts: the shortcuts that leave a jump point of a map of which nothing is prepared, found on the cells
// when a search asks. They are those of ShortcutGraph, in the same order, but for dead ends, which it leaves out. It
// does not know costs, so that searches in 32 and in 64 bits share its code.
//
// One thread.

#include <cstdint>
#include <span>
#include <vector>

#include "wend/geometry/cell_box.hpp"
#include "wend/jump/jump_scan.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

/// As Shortcut.
struct ScannedShortcut {
  ScannedJump first_jump;
  ScannedJump last_jump;
  int straight = 0;  // steps
  int diagonal = 0;
  bool ends = false;  // has the last jump point no successor?
  std::uint32_t passed_begin = 0;
  std::uint32_t passed_end = 0;

  ScannedJump first() const { return first_jump; }
  bool dead() const { return ends; }
};

class ScannedShortcuts {
 public:
  /// `passable` must live as long.
  explicit ScannedShortcuts(const BitGrid& passable) : scan_(passable) {}

  JumpScan& scan() { return scan_; }
  const JumpScan& scan() const { return scan_; }

  /// Follows the cells after an edit in these boxes.
  void repair(std::span<const CellBox> boxes);

  /// The jumps from any free cell, each a shortcut of its own. Valid until the next call of find().
  std::span<const ScannedShortcut> find_first(Cell start);

  /// The shortcuts from a jump point: each goes on while there is one successor.
  std::span<const ScannedShortcut> find(const ScannedJump& from);

  /// The jump points that a shortcut passes, its last one among them.
  std::span<const ScannedJump> passed(const ScannedShortcut& shortcut) const {
    return std::span(passed_).subspan(shortcut.passed_begin,
                                      shortcut.passed_end - shortcut.passed_begin);
  }

  /// The first successor of a jump point that has one.
  ScannedJump next(const ScannedJump& jump) { return onward(jump).next; }

 private:
  /// How a path goes on from a jump point.
  struct Onward {
    ScannedJump from;
    ScannedJump next;  // the first successor
    int count = -1;    // of successors, at most 2; less than 0: not known
  };

  static constexpr unsigned kOnwardBits = 9;

  void collect(Cell from, DirectionSet directions);
  const Onward& onward(const ScannedJump& jump);
  void extend(ScannedShortcut& shortcut);
  bool passes(const ScannedShortcut& shortcut, const ScannedJump& jump) const;
  void pass(ScannedShortcut& shortcut);

  JumpScan scan_;
  std::vector<Onward> onward_{std::size_t{1} << kOnwardBits};  // by a hash of the jump
  std::vector<ScannedShortcut> shortcuts_;                     // of the state being expanded
  std::vector<ScannedJump> passed_;                            // by these
};

}  // namespace wend
