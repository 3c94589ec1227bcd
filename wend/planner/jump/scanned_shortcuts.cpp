#include "wend/planner/jump/scanned_shortcuts.hpp"

#include <algorithm>

#include "wend/jump/shortcut_graph.hpp"

namespace wend {
namespace {

/// False if a Shortcut cannot count so many steps.
bool lengthen(ScannedShortcut& shortcut, const OctileWay& way) {
  const int straight = shortcut.straight + way.straight;
  const int diagonal = shortcut.diagonal + way.diagonal;
  if (straight > Shortcut::kMostSteps || diagonal > Shortcut::kMostSteps) return false;
  shortcut.straight = straight;
  shortcut.diagonal = diagonal;
  return true;
}

/// One of 64 bits; another jump may have the same.
std::uint64_t mark(const ScannedJump& jump) {
  const auto bit = static_cast<unsigned>(7 * jump.cell.x + 29 * jump.cell.y) + jump.arrival;
  return std::uint64_t{1} << (bit % 64);
}

}  // namespace

void ScannedShortcuts::repair(std::span<const CellBox> boxes) {
  for (const CellBox& box : boxes) scan_.forget(box);
  for (Onward& known : onward_) known.count = -1;
}

std::span<const ScannedShortcut> ScannedShortcuts::find_first(Cell start) {
  collect(start, 0xFF);
  return shortcuts_;
}

std::span<const ScannedShortcut> ScannedShortcuts::find(const ScannedJump& from) {
  passed_.clear();
  collect(from.cell, scan_.directions(from));
  for (ScannedShortcut& shortcut : shortcuts_) extend(shortcut);
  return shortcuts_;
}

void ScannedShortcuts::collect(Cell from, DirectionSet directions) {
  shortcuts_.clear();
  scan_.visit_jumps(from, directions, [&](const ScannedJump& jump) {
    ScannedShortcut& shortcut =
        shortcuts_.emplace_back(ScannedShortcut{.first_jump = jump, .last_jump = jump});
    lengthen(shortcut, octile_way(from, jump.cell));
    return true;
  });
}

/// Several paths reach most jump points.
const ScannedShortcuts::Onward& ScannedShortcuts::onward(const ScannedJump& jump) {
  const auto hash =
      static_cast<std::uint32_t>(jump.cell.y * scan_.width() + jump.cell.x) * 4 + jump.arrival;
  Onward& known = onward_[hash * 0x9E3779B1U >> (32 - kOnwardBits)];
  if (known.count >= 0 && known.from == jump) return known;
  known = {.from = jump, .next = {}, .count = 0};
  scan_.visit_jumps(jump.cell, scan_.directions(jump), [&known](const ScannedJump& found) {
    if (known.count == 0) known.next = found;
    return ++known.count < 2;
  });
  return known;
}

/// As ShortcutGraph::extend().
void ScannedShortcuts::extend(ScannedShortcut& shortcut) {
  shortcut.passed_begin = shortcut.passed_end = static_cast<std::uint32_t>(passed_.size());
  if (shortcut.straight + shortcut.diagonal == 0) return;  // too long to count
  std::uint64_t marks = mark(shortcut.last_jump);          // of the jumps passed
  for (std::size_t count = 1; count < ShortcutGraph::kMostPassed; ++count) {
    const auto& [from, next, successors] = onward(shortcut.last_jump);
    shortcut.ends = successors == 0;
    if (shortcut.ends) pass(shortcut);
    if (successors != 1) return;
    if ((marks & mark(next)) != 0 && passes(shortcut, next)) return;
    marks |= mark(next);
    if (!lengthen(shortcut, octile_way(shortcut.last_jump.cell, next.cell))) return;
    pass(shortcut);
    shortcut.last_jump = next;
  }
}

bool ScannedShortcuts::passes(const ScannedShortcut& shortcut, const ScannedJump& jump) const {
  const auto passed = std::span(passed_).subspan(shortcut.passed_begin);
  return jump == shortcut.last_jump || std::ranges::find(passed, jump) != passed.end();
}

void ScannedShortcuts::pass(ScannedShortcut& shortcut) {
  passed_.push_back(shortcut.last_jump);
  shortcut.passed_end = static_cast<std::uint32_t>(passed_.size());
}

}  // namespace wend
