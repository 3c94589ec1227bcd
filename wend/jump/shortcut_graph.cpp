#include "wend/jump/shortcut_graph.hpp"

#include <algorithm>
#include <utility>

#include "wend/jump/jump_sources.hpp"

namespace wend {

Shortcut::Shortcut(Jump jump, Cell from, Cell to) : first_(jump), last_(jump) {
  lengthen(from, to);
}

/// False if there are too many steps to count.
bool Shortcut::lengthen(Cell from, Cell to) {
  const OctileWay way = octile_way(from, to);
  const int straight = straight_ + way.straight;
  const int diagonal = diagonal_ + way.diagonal;
  if (straight > kMostSteps || diagonal > kMostSteps) return false;
  straight_ = static_cast<std::uint16_t>(straight) & kMostSteps;
  diagonal_ = static_cast<std::uint16_t>(diagonal) & kMostSteps;
  return true;
}

ShortcutGraph::ShortcutGraph(std::shared_ptr<const JumpGraph> jumps)
    : jumps_(std::move(jumps)), raster_(jumps_->boards().width(), jumps_->boards().height()) {
  links_.reserve(kArrivals * jumps_->size_after_edits());
  links_.resize(kArrivals * jumps_->size(), kUnknown);
}

/// Finds whether there are no, one or several successors.
ShortcutGraph::Link ShortcutGraph::find(Jump jump) {
  Link link = kNone;
  jumps_->visit_jumps(jumps_->cell(jump.number()), jumps_->directions(jump), [&](Jump next) {
    link = link == kNone ? next.code() | kIsJump : kSeveral;
    return link != kSeveral;
  });
  return links_[jump.code()] = link;
}

/// A single successor gets a list too, if a search stops there. Dead shortcuts come after the others, so
/// that branches on them are seldom mispredicted.
ShortcutGraph::Link ShortcutGraph::make_list(Jump from) {
  next_.clear();
  const Cell cell = jumps_->cell(from.number());
  jumps_->append_jumps(cell, jumps_->directions(from), next_);
  const auto list = static_cast<Link>(shortcuts_.size());
  lists_.push_back({list, from, {}, {}});
  dead_.clear();
  for (const Jump next : next_) {
    Shortcut shortcut(next, cell, jumps_->cell(next.number()));
    extend(shortcut);
    lists_.back().seen.include(shortcut.seen_);
    lists_.back().ends.include(raster_.place(jumps_->cell(shortcut.last().number())));
    (shortcut.dead() ? dead_ : shortcuts_).push_back(shortcut);
  }
  shortcuts_.insert(shortcuts_.end(), dead_.begin(), dead_.end());
  shortcuts_.back().ends_list_ = 1;
  return links_[from.code()] = list;
}

/// Extends a shortcut from its first jump while there is only one successor; a cyclic chain ends before
/// it repeats.
void ShortcutGraph::extend(Shortcut& shortcut) {
  shortcut.last_ = shortcut.first_;
  if (shortcut.straight_ + shortcut.diagonal_ == 0) return;  // too long to count
  passed_.assign(1, shortcut.first_);
  while (passed_.size() < kMostPassed) {
    const Link link = link_of(shortcut.last_);
    shortcut.dead_ = link == kNone ? 1 : 0;
    if (shortcut.dead()) look_around(shortcut.last_, shortcut.seen_);
    if (!is_only_jump(link)) return;
    const Jump next = only_next(shortcut.last_);
    if (std::find(passed_.begin(), passed_.end(), next) != passed_.end()) return;
    if (!shortcut.lengthen(jumps_->cell(shortcut.last_.number()), jumps_->cell(next.number())))
      return;
    look_around(shortcut.last_, shortcut.seen_);
    shortcut.last_ = next;
    passed_.push_back(next);
  }
}

ShortcutGraph::Edits ShortcutGraph::edits_in(std::span<const CellBox> boxes,
                                             std::span<const Jump> changed) const {
  Edits edits;
  for (const CellBox& box : boxes) {
    edits.boxes.push_back(raster_.any_place_of(box.grown_by(1)));
  }
  CellBox around;
  for (const Jump jump : changed) {
    const Cell cell = jumps_->cell(jump.number());
    around = around.joined_with({cell, {cell.x + 1, cell.y + 1}});
  }
  edits.changed = raster_.any_place_of(around);
  return edits;
}

/// May a shortcut of the list pass a changed jump, which sees a box that was edited, or end at one?
bool ShortcutGraph::may_have_changed(const List& list, const Edits& edits) const {
  if (changed_[list.from.code()]) return true;
  const auto sees_edit = [&](auto&& may_see) { return std::ranges::any_of(edits.boxes, may_see); };
  const bool ends_near = list.ends.may_hold(edits.changed);
  if (!ends_near && !sees_edit([&](CoarsePlace box) { return list.seen.may_hold(box); })) {
    return false;
  }
  for (const Shortcut& shortcut : ShortcutList(shortcuts_.data() + list.first)) {
    if (changed_[shortcut.last().code()]) return true;
    if (sees_edit([&](CoarsePlace box) { return shortcut.may_see(box); })) return true;
  }
  return false;
}

/// What is known of the only successor of a jump stays: shortcuts of other lists may pass it.
void ShortcutGraph::forget_list(List& list) {
  const Shortcut* shortcut = shortcuts_.data() + list.first;
  const bool only = shortcut->ends_list_ != 0;
  const Link known = only ? shortcut->first().code() | kIsJump : kSeveral;
  links_[list.from.code()] = changed_[list.from.code()] ? kUnknown : known;
  for (; shortcut->ends_list_ == 0; ++shortcut) ++forgotten_;
  ++forgotten_;
  list.from = kNobody;
}

void ShortcutGraph::forget_list_of(Jump from) {
  const Link link = links_[from.code()];
  if (is_list(link)) {
    forget_list(*std::ranges::lower_bound(lists_, link, {}, &List::first));
  } else if (changed_[from.code()]) {
    links_[from.code()] = kUnknown;
  }
}

bool ShortcutGraph::leads_to(Link list, Jump first) const {
  for (const Shortcut& shortcut : ShortcutList(shortcuts_.data() + list)) {
    if (shortcut.first() == first) return true;
  }
  return false;
}

/// Follows the shortcuts that pass changed jumps, or end at one, back to the jump points where they begin. False if
/// looking at all lists takes less time.
bool ShortcutGraph::forget_before(std::span<const Jump> changed) {
  JumpSources sources(*jumps_, lists_.size() / 2);
  std::vector<Jump> jumps(changed.begin(), changed.end());
  std::vector<Jump> passed;
  for (std::size_t depth = 0; depth < kMostPassed && !jumps.empty(); ++depth) {
    passed.clear();
    for (const Jump jump : jumps) {
      if (!sources.find_before(jump)) return false;
      for (const Jump from : sources.jumps()) {
        const Link link = links_[from.code()];
        const bool only = is_only_jump(link) && only_next(from) == jump;
        if (only && !changed_[from.code()]) passed.push_back(from);
        if (is_list(link) && leads_to(link, jump)) forget_list_of(from);
      }
    }
    std::swap(jumps, passed);
  }
  return true;
}

void ShortcutGraph::repair(std::span<const CellBox> boxes, std::span<const Jump> changed) {
  links_.resize(kArrivals * jumps_->size(), kUnknown);
  changed_.resize(links_.size());
  for (const Jump jump : changed) changed_[jump.code()] = true;
  for (const Jump jump : changed) forget_list_of(jump);
  if (!forget_before(changed)) {
    const Edits edits = edits_in(boxes, changed);
    for (List& list : lists_) {
      if (list.from != kNobody && may_have_changed(list, edits)) forget_list(list);
    }
  }
  for (const Jump jump : changed) changed_[jump.code()] = false;
  if (2 * forgotten_ > shortcuts_.size()) compact();
}

void ShortcutGraph::forget() {
  links_.assign(kArrivals * jumps_->size(), kUnknown);
  shortcuts_.clear();
  lists_.clear();
  forgotten_ = 0;
}

/// Closes the gaps that forgotten lists left.
void ShortcutGraph::compact() {
  std::erase_if(lists_, [](const List& list) { return list.from == kNobody; });
  std::size_t end = 0;
  for (List& list : lists_) {
    std::size_t from = list.first;
    list.first = static_cast<Link>(end);
    links_[list.from.code()] = list.first;
    do {
      shortcuts_[end] = shortcuts_[from++];
    } while (shortcuts_[end++].ends_list_ == 0);
  }
  shortcuts_.erase(shortcuts_.begin() + static_cast<std::ptrdiff_t>(end), shortcuts_.end());
  forgotten_ = 0;
}

/// Includes all cells in sight of a jump point, except where a successor sees them as well.
void ShortcutGraph::look_around(Jump jump, CoarseBox& seen) const {
  using enum Direction;
  const Cell from = jumps_->cell(jump.number());
  const DirectionSet directions = jumps_->directions(jump);
  seen.include(raster_.place(from));
  if ((directions & set_of(plus_y)) != 0) look_ahead<plus_y>(from, seen);
  if ((directions & set_of(plus_x)) != 0) look_ahead<plus_x>(from, seen);
  if ((directions & set_of(minus_y)) != 0) look_ahead<minus_y>(from, seen);
  if ((directions & set_of(minus_x)) != 0) look_ahead<minus_x>(from, seen);
  if ((directions & set_of(plus_x_plus_y)) != 0) look_along_diagonal<plus_x_plus_y>(from, seen);
  if ((directions & set_of(plus_x_minus_y)) != 0) look_along_diagonal<plus_x_minus_y>(from, seen);
  if ((directions & set_of(minus_x_minus_y)) != 0) look_along_diagonal<minus_x_minus_y>(from, seen);
  if ((directions & set_of(minus_x_plus_y)) != 0) look_along_diagonal<minus_x_plus_y>(from, seen);
}

template <Direction kStraight>
void ShortcutGraph::look_ahead(Cell from, CoarseBox& seen) const {
  const int steps = jumps_->boards().distance_to_stop<kStraight>(from);
  seen.include(raster_.place(step(from, kStraight, steps)));
}

/// Does not follow a long diagonal to its end: then all cells in that direction may be seen.
template <Direction kDiagonal>
void ShortcutGraph::look_along_diagonal(Cell from, CoarseBox& seen) const {
  constexpr int kLongest = 24;
  const JumpBoards& boards = jumps_->boards();
  for (int steps = 0; steps < kLongest; ++steps) {
    if ((boards.moves(from) & set_of(kDiagonal)) == 0) return;
    from = step(from, kDiagonal, 1);
    look_ahead<turned(kDiagonal, -1)>(from, seen);
    look_ahead<turned(kDiagonal, 1)>(from, seen);
  }
  seen.include(raster_.place(step(from, kDiagonal, boards.width() + boards.height())));
}

}  // namespace wend
