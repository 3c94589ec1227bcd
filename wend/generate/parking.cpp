// A parking yard seen from above: rows of bays with parked cars, kerbs at the ends of the rows,
// aisles between them, roads across, patches of worn road. Some parts are busier than others.
//
// A driving car stands on a corner of four cells and turns on quarter circles with a radius of one
// cell; it cannot use a corner that touches an obstacle. So it is effectively two cells wide, and a
// passage between obstacles that is n cells wide has n - 1 lines of corners to drive along. Hence
//
//   a parked car   2 cells wide and 4 or 3 long.
//   a bay          3 cells wide, the car and a gap of one cell: nothing gets through between two
//                  parked cars, but an empty bay with a gap on either side is 4 cells wide, with
//                  three lines to drive into along. As deep as a long car.
//   an aisle       at least 4 cells wide, as the roads are: three lines, so that a car turns into a
//                  bay from either direction, backs out and turns without leaving the aisle.
//   a double row   two rows nose to nose with a gap between, which no car fits along; through two
//                  empty bays one drives from aisle to aisle.
//   a kerb         1 cell wide; it ends one cell before the aisle, so that cars can cut the corner.

#include "wend/generate/block.hpp"
#include "wend/generate/generator_info.hpp"
#include "wend/generate/hills.hpp"

namespace wend {
namespace {

constexpr int kCarWidth = 2;
constexpr int kLongCar = 4;
constexpr int kShortCar = 3;
constexpr int kGap = 1;  // between two cars, beside and before them
constexpr int kBayWidth = kCarWidth + kGap;
constexpr int kBayDepth = kLongCar;
constexpr int kAisle = 4;
constexpr int kKerb = 1;
constexpr int kEnds = 2 * kKerb + kGap;  // in a row: its kerbs, and the gap before the first car
constexpr int kMostBays = 16;            // in a row; then comes a road
constexpr int kPatches = 9;              // rough distance between patches of worn road
constexpr int kQuarters = 90;            // rough distance between busy parts of the yard

struct ParkingOptions {
  double occupied = 0.7;
  double rough = 0.08;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"occupied", "proportion of bays with a parked car"}, self.occupied, {0, 1});
    field({"rough", "proportion of the ground that is rough road, which costs twice as much"},
          self.rough, {0, 1});
  }

  /// A row at the upper edge and one at the lower edge, each with one bay, an aisle between them.
  MapSize least_size() const {
    return {kAisle + kEnds + kBayWidth + kAisle, kBayDepth + kAisle + kBayDepth};
  }
};

/// The first cells of rows of bays, from the upper edge down. Even rows have their aisle below, odd
/// ones above.
std::vector<int> rows_of_bays(int height) {
  const auto needed = [](int rows) {
    const int aisles = (rows + 1) / 2;
    return rows * kBayDepth + aisles * kAisle + (rows - 1) / 2 * kGap;
  };
  int rows = 2;
  while (needed(rows + 1) <= height) ++rows;
  const int aisles = (rows + 1) / 2;
  std::vector<int> begins;
  int y = 0;
  for (int row = 0; row < rows; ++row) {
    begins.push_back(y);
    const bool aisle_below = row % 2 == 0;
    y += kBayDepth + (aisle_below ? kAisle + part(row / 2, aisles, height - needed(rows)) : kGap);
  }
  return begins;
}

/// Rows between two roads.
struct Wing {
  int x;
  int bays;

  int width() const { return kEnds + bays * kBayWidth; }
};

/// Places roads along both sides, and as many between as are needed to shorten the rows.
std::vector<Wing> wings_of(int width) {
  constexpr int kLongest = kEnds + kMostBays * kBayWidth + kAisle;
  const int wings = (width - kAisle + kLongest - 1) / kLongest;
  const int roads = wings + 1;
  const int bays = (width - roads * kAisle - wings * kEnds) / kBayWidth;
  const int left_over = width - roads * kAisle - wings * kEnds - bays * kBayWidth;
  std::vector<Wing> all;
  int x = 0;
  for (int i = 0; i < wings; ++i) {
    x += kAisle + part(i, roads, left_over);
    all.push_back({x, part(i, wings, bays)});
    x += all.back().width();
  }
  return all;
}

/// The probability of a car in a bay: some parts of the yard are busier than others.
class Occupancy {
 public:
  Occupancy(MapSize size, double mean, Random& random)
      : mean_(mean),
        spread_(std::min(mean, 1 - mean)),
        quarters_(size.width, size.height, kQuarters, random) {}

  double at(Cell cell) const { return mean_ + spread_ * (2 * quarters_.share_below(cell) - 1); }

 private:
  double mean_;
  double spread_;  // limited so that it is the same in both directions
  Hills quarters_;
};

/// Cars in the bays of one row, their noses away from the aisle.
void park(Grid<CellState>& cells, const Wing& wing, int y, bool aisle_below,
          const Occupancy& occupancy, Random& random) {
  for (int bay = 0; bay < wing.bays; ++bay) {
    const int x = wing.x + kKerb + kGap + bay * kBayWidth;
    if (!random.chance(occupancy.at({x, y}))) continue;
    const int length = random.chance(0.5) ? kLongCar : kShortCar;
    const Block car{x, aisle_below ? y : y + kBayDepth - length, kCarWidth, length};
    fill(cells, car, CellState::occupied);
  }
}

/// Kerbs at both ends of a row or a double row.
void place_kerbs(Grid<CellState>& cells, const Wing& wing, int y, int y_end) {
  if (y > 0) ++y;
  if (y_end < cells.height()) --y_end;
  for (const int x : {wing.x, wing.x + wing.width() - kKerb}) {
    fill(cells, {x, y, kKerb, y_end - y}, CellState::occupied);
  }
}

Grid<CellState> cells_of(MapSize size, double occupied, Random& random) {
  Grid<CellState> cells(size.width, size.height, CellState::free);
  const Occupancy occupancy(size, occupied, random);
  const std::vector<int> rows = rows_of_bays(size.height);
  for (const Wing& wing : wings_of(size.width)) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const bool aisle_below = i % 2 == 0;
      park(cells, wing, rows[i], aisle_below, occupancy, random);
      if (i > 0 && aisle_below) continue;  // the previous row has the kerbs of both
      const bool is_double = !aisle_below && i + 1 < rows.size();
      place_kerbs(cells, wing, rows[i], (is_double ? rows[i + 1] : rows[i]) + kBayDepth);
    }
  }
  return cells;
}

Grid<double> worn_roads(const Grid<CellState>& cells, double share, Random& random) {
  if (share == 0) return {};
  const Hills hills(cells.width(), cells.height(), kPatches, random);
  Grid<double> terrain(cells.width(), cells.height(), 1);
  for (const Cell cell : every_cell(cells)) {
    const bool worn = hills.share_below(cell) >= 1 - share;
    if (worn && cells[cell] == CellState::free) terrain[cell] = kRoughRoad;
  }
  return terrain;
}

GridMap generate(MapSize size, const ParkingOptions& options, Random& random) {
  const Grid<CellState> cells = cells_of(size, options.occupied, random);
  Grid<double> terrain = worn_roads(cells, options.rough, random);
  return *make_grid_map(cells, {}, std::move(terrain));
}

}  // namespace

GeneratorInfo parking_generator() {
  GeneratorInfo info = generator_info<ParkingOptions>(
      "parking", "a parking yard for a car: rows of bays, aisles and roads", generate);
  info.free_corner = 0;
  return info;
}

}  // namespace wend
