#pragma once

// Portals: the free cells of a map as runs of rows, and the openings between runs of neighbouring rows. Lines of
// sight go from run to run through portals, so what can be seen is found in whole numbers, run by run.
//
//   const wend::Portals portals(space.passable());
//   for (const wend::TautCorner& corner : portals.corners()) mark(corner.x, corner.y);
//
// A portal of length 0 is a vertex between two cells that touch diagonally, the other two being blocked. There is
// one only where open_gap(cell, other) says that a path may pass. Everything off the map is blocked.
//
// A corner is a vertex at which a shortest path can turn: one of its four cells is blocked, or it is such a gap.
// It is an end of exactly one portal. Vertex (x, y) is the corner that cell (x, y) shares with (x - 1, y - 1).
//
// O(cells / 64 + runs) to make; 16 bytes a run, 24 a portal, 16 a corner.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "wend/base/deadline.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/sight/sight_point.hpp"

namespace wend {

/// The free cells [left, right) of a row between two blocked ones, and the portals on both of its sides.
struct SightRun {
  int left;
  int right;
  std::uint32_t
      first_below;  // its portals to row y - 1 are [first_below, first_below of the row's next run)
  std::uint32_t first_above;  // the same to row y + 1
};

/// The opening between a run of row y - 1 and one of row y: the points (left..right, y).
struct Portal {
  int left;
  int right;
  std::uint32_t below;         // the run of row y - 1
  std::uint32_t above;         // the run of row y
  std::uint32_t left_corner;   // kNoCorner: the wall goes straight on, or ends both runs
  std::uint32_t right_corner;  // of a gap, the same as left_corner
};

/// Which of the four cells around a vertex is blocked.
enum class BlockedCell : std::uint8_t { low_left, low_right, high_left, high_right, gap };

/// A vertex at which shortest paths turn.
struct TautCorner {
  int x;
  int y;
  std::uint32_t portal : 28;  // of which it is an end
  std::uint32_t blocked : 3;  // a BlockedCell
  /// Do taut lines through it rise from left to right? Then they lie in the quadrants low left and high right, else
  /// in the other two.
  std::uint32_t rising : 1;

  BlockedCell blocked_cell() const { return static_cast<BlockedCell>(blocked); }
};

class Portals {
 public:
  static constexpr std::uint32_t kNoCorner = UINT32_MAX;
  static constexpr std::uint32_t kNoRun = UINT32_MAX;

  /// May a path pass from one free cell to another that it touches diagonally, the two cells between them being
  /// blocked?
  using OpenGap = std::function<bool(Cell, Cell)>;

  /// No gap is open if `open_gap` is empty.
  explicit Portals(const BitGrid& free, const OpenGap& open_gap = {},
                   DeadlineCheck& stop = DeadlineCheck::never());

  int width() const { return width_; }
  int height() const { return static_cast<int>(first_run_.size()) - 1; }
  std::span<const TautCorner> corners() const { return corners_; }
  const SightRun& run(std::uint32_t id) const { return runs_[id]; }
  const Portal& portal(std::uint32_t id) const { return portals_[id]; }

  /// The portals on a side of a run are [first, end).
  std::uint32_t end_below(std::uint32_t run) const { return runs_[run + 1].first_below; }
  std::uint32_t end_above(std::uint32_t run) const { return runs_[run + 1].first_above; }

  /// The run of a free cell. O(log runs of the row).
  std::uint32_t run_of(Cell cell) const;

  /// Does the line between two points of free cells pass no obstacle? It may touch some. Exact.
  /// O(rows between them, log portals each).
  bool sees(const SightPoint& from, const SightPoint& to) const;
  /// The same between the centres of cells.
  bool sees(Cell from, Cell to) const {
    return sees(SightPoint::centre(from), SightPoint::centre(to));
  }

 private:
  std::uint32_t corner_at(int x, int y, std::uint32_t portal, BlockedCell blocked, bool rising);
  void join_rows(int y, const OpenGap& open_gap);
  void add_portal(int y, std::uint32_t below, std::uint32_t above);

  int width_;
  std::vector<std::uint32_t> first_run_;  // of each row, and one past the last
  std::vector<SightRun> runs_;            // and one past the last
  std::vector<Portal> portals_;
  std::vector<TautCorner> corners_;
};

}  // namespace wend
