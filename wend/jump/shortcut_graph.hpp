#pragma once

// ShortcutGraph: chains of jumps without a choice, each as one shortcut. A shortcut is found when a search
// first asks for it, and kept: each search makes later searches faster.
//
// Where a jump point has only one successor, a search need not stop there, unless it sees its goal from
// there. So a shortcut has a box around all cells in sight of the jump points that it passes; a search
// whose goal is in the box must look closer. The box ends at the next jump points, because what lies
// behind a jump point in sight is in sight of that one as well. A shortcut whose last jump point has no
// successor is dead; its box also contains what that jump point sees.
//
//   wend::ShortcutGraph graph(std::make_shared<const wend::JumpGraph>(boards));
//   for (const wend::Shortcut& shortcut : graph.shortcuts(jump)) reach(shortcut);
//
// After an edit of the map, repair() forgets the shortcuts that the edit may have changed.
//
// 16 bytes per jump point, 16 for each shortcut found where there is a choice, and 16 for each list of them. One
// thread.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "wend/base/large_pages.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/geometry/cell_box.hpp"
#include "wend/jump/jump_graph.hpp"
#include "wend/space/grid/octile.hpp"

namespace wend {

// CoarseBox: a box around some cells in four bytes, so that one subtraction tells whether a cell may
// be in it.
//
//   const wend::CoarseRaster raster(width, height);
//   wend::CoarseBox box;
//   box.include(raster.place({3, 4}));
//   if (box.may_hold(raster.place(cell))) ...
//
// Places are pieces of the map, at most 127 in each direction, so a box may contain cells that were not
// added, but never misses an added one.

/// Where a cell lies: x, y, and both from the other end, 7 bits in each byte.
class CoarsePlace {
 public:
  static constexpr int kLast = 126;

  CoarsePlace() = default;
  constexpr CoarsePlace(int x, int y)
      : bytes_(static_cast<std::uint32_t>(x | y << 8 | (kLast - x) << 16 | (kLast - y) << 24)) {}
  /// The greatest x and y of a box, and the least ones, which lie farthest from the other end.
  constexpr CoarsePlace(CoarsePlace greatest, CoarsePlace least)
      : bytes_((greatest.bytes_ & 0xFFFFU) | (least.bytes_ & 0xFFFF0000U)) {}

 private:
  friend class CoarseBox;
  std::uint32_t bytes_ = 0;
};

class CoarseRaster {
 public:
  constexpr CoarseRaster(int width, int height) {
    while ((std::max(width, height) - 1) >> shift_ > CoarsePlace::kLast) ++shift_;
  }

  /// A cell outside counts as one at the edge.
  constexpr CoarsePlace place(Cell cell) const {
    return {std::clamp(cell.x >> shift_, 0, CoarsePlace::kLast),
            std::clamp(cell.y >> shift_, 0, CoarsePlace::kLast)};
  }

  /// What CoarseBox::may_hold() takes to tell whether it may hold any cell of a box.
  constexpr CoarsePlace any_place_of(const CellBox& box) const {
    return {place({box.end.x - 1, box.end.y - 1}), place(box.begin)};
  }

 private:
  int shift_ = 0;
};

/// Empty at first.
class CoarseBox {
 public:
  constexpr void include(CoarsePlace place) { include_bytes(place.bytes_); }

  constexpr void include(const CoarseBox& other) { include_bytes(other.least_); }

  /// Is no byte of the place less than the least? No byte borrows from the next: its highest bit is
  /// set before, and stays set if and only if it was not less.
  constexpr bool may_hold(CoarsePlace place) const {
    return (((place.bytes_ | kHighest) - least_) & kHighest) == kHighest;
  }

 private:
  constexpr void include_bytes(std::uint32_t bytes) {
    std::uint32_t least = 0;
    for (unsigned bit = 0; bit < 32; bit += 8) {
      least |= std::min(least_ >> bit & 0x7FU, bytes >> bit & 0x7FU) << bit;
    }
    least_ = least;
  }

  static constexpr std::uint32_t kHighest = 0x80808080U;

  std::uint32_t least_ = 0x7F7F7F7FU;  // by byte; no place is as large in all bytes
};

class Shortcut {
 public:
  static constexpr int kMostSteps = (1 << 15) - 1;  // of each kind; a jump with more stores 0

  /// A single jump between two cells. It sees nothing on its way.
  Shortcut(Jump jump, Cell from, Cell to);

  Jump first() const { return first_; }
  /// The first jump, or the end of a chain of jumps from there.
  Jump last() const { return last_; }

  /// Has the last jump point no successor?
  bool dead() const { return dead_ != 0; }

  /// May a cell be in sight of a jump point that the shortcut passes?
  bool may_see(CoarsePlace cell) const { return seen_.may_hold(cell); }

  /// The cost from its beginning to its end in OctileUnits<Cost>.
  template <class Cost>
  Cost cost(Cell begin, Cell end) const {
    using Units = OctileUnits<Cost>;
    if (straight_ + diagonal_ == 0) [[unlikely]]
      return octile_cost<Cost>(begin, end);
    return Units::kStraight * straight_ + Units::kDiagonal * diagonal_;
  }

 private:
  friend class ShortcutGraph;
  friend class ShortcutList;

  bool lengthen(Cell from, Cell to);

  Jump first_;
  Jump last_;
  std::uint16_t straight_ : 15 = 0;  // steps
  std::uint16_t dead_ : 1 = 0;
  std::uint16_t diagonal_ : 15 = 0;
  std::uint16_t ends_list_ : 1 = 0;
  CoarseBox seen_;
};

/// Consecutive shortcuts in memory; the last one is marked.
class ShortcutList {
 public:
  class Iterator {
   public:
    explicit Iterator(const Shortcut* shortcut) : shortcut_(shortcut) {}
    const Shortcut& operator*() const { return *shortcut_; }
    Iterator& operator++() {
      shortcut_ = shortcut_->ends_list_ != 0 ? nullptr : shortcut_ + 1;
      return *this;
    }
    friend bool operator==(Iterator, Iterator) = default;

   private:
    const Shortcut* shortcut_;
  };

  /// Null if there are none.
  explicit ShortcutList(const Shortcut* first) : first_(first) {}

  Iterator begin() const { return Iterator(first_); }
  Iterator end() const { return Iterator(nullptr); }

 private:
  const Shortcut* first_;
};

class ShortcutGraph {
 public:
  static constexpr std::size_t kMostPassed = 32;  // jump points, by a shortcut

  explicit ShortcutGraph(std::shared_ptr<const JumpGraph> jumps);

  const JumpGraph& jumps() const { return *jumps_; }
  const CoarseRaster& raster() const { return raster_; }

  /// The shortcuts from a jump point. Valid until the next call.
  ShortcutList shortcuts(Jump from) {
    Link link = link_of(from);
    if (link == kNone) return ShortcutList(nullptr);
    if (!is_list(link)) link = make_list(from);
    return ShortcutList(shortcuts_.data() + link);
  }

  /// Follows jumps() after an edit in these boxes. `changed`: the jumps from which a search may go on differently.
  /// O(jumps and cells before these jumps); if there are many, O(lists of shortcuts).
  void repair(std::span<const CellBox> boxes, std::span<const Jump> changed);

  /// The same if it is not known which jumps have changed: forgets everything. O(jump points).
  void forget();

  /// The only successor of a jump point that a shortcut passes.
  Jump only_next(Jump passed) const {
    const Link link = links_[passed.code()];
    assert(is_only_jump(link));
    return is_jump(link) ? Jump(link & ~kIsJump) : shortcuts_[link].first();
  }

  /// Prefetch the memory that shortcuts() will read: first the place of the shortcuts, then the
  /// shortcuts.
  void prefetch_place(Jump jump) const { __builtin_prefetch(&links_[jump.code()]); }
  void prefetch_shortcuts(Jump jump) const {
    const Link link = links_[jump.code()];
    if (is_list(link)) __builtin_prefetch(shortcuts_.data() + link);
  }

 private:
  /// The successors: none, one jump (its code, with the highest bit set), several jumps, or the number
  /// of the first shortcut in a list of all. The successors of the end of a shortcut are not computed
  /// before a search gets there.
  using Link = std::uint32_t;
  static constexpr Link kIsJump = Link{1} << 31U;
  static constexpr Link kUnknown = ~Link{0};
  static constexpr Link kNone = kUnknown - 1;
  static constexpr Link kSeveral = kUnknown - 2;

  static constexpr Jump kNobody{~std::uint32_t{0}};

  static bool is_list(Link link) { return link < kIsJump; }
  static bool is_jump(Link link) { return link >= kIsJump && link < kSeveral; }
  bool is_only_jump(Link link) const {
    return is_list(link) ? shortcuts_[link].ends_list_ != 0 : is_jump(link);
  }

  Link link_of(Jump jump) {
    const Link link = links_[jump.code()];
    return link == kUnknown ? find(jump) : link;
  }
  /// The shortcuts of a jump point.
  struct List {
    Link first;
    Jump from;       // kNobody: forgotten
    CoarseBox seen;  // by the jump points that they pass
    CoarseBox ends;  // where the shortcuts end
  };

  /// What an edit has changed.
  struct Edits {
    std::vector<CoarsePlace> boxes;
    CoarsePlace changed;  // a box around the jump points of changed jumps
  };

  Link find(Jump jump);
  Link make_list(Jump from);
  Edits edits_in(std::span<const CellBox> boxes, std::span<const Jump> changed) const;
  bool may_have_changed(const List& list, const Edits& edits) const;
  void forget_list(List& list);
  void forget_list_of(Jump from);
  bool leads_to(Link list, Jump first) const;
  bool forget_before(std::span<const Jump> changed);
  void compact();
  void extend(Shortcut& shortcut);
  void look_around(Jump jump, CoarseBox& seen) const;
  template <Direction kStraight>
  void look_ahead(Cell from, CoarseBox& seen) const;
  template <Direction kDiagonal>
  void look_along_diagonal(Cell from, CoarseBox& seen) const;

  std::shared_ptr<const JumpGraph> jumps_;
  CoarseRaster raster_;
  std::vector<Link, LargePages<Link>> links_;              // by the code of a jump
  std::vector<Shortcut, LargePages<Shortcut>> shortcuts_;  // lists
  std::vector<List> lists_;    // in the order of their shortcuts, without those that were forgotten
  std::size_t forgotten_ = 0;  // shortcuts
  std::vector<bool> changed_;  // by the code of a jump: while it is repaired
  std::vector<Jump> next_;     // of the list being made
  std::vector<Shortcut, LargePages<Shortcut>> dead_;  // of the list being made
  std::vector<Jump> passed_;                          // by the shortcut being made
};

}  // namespace wend
