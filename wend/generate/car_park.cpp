// A car park for robots with a shape, in cells of 0.1 m: double rows of bays across the aisles, a row
// against the upper wall, and against the lower wall a row of bays along the aisle. Roads lead around the
// rows and between them; each row ends in a kerb. Parked cars stand a little askew.
//
// All sizes follow from the width of a bay, so that the same park serves cars (2.5 m) and small robots.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "wend/generate/floor_plan.hpp"
#include "wend/generate/generator_info.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/map/connected_components.hpp"

namespace wend {
namespace {

struct CarParkOptions {
  double bay_width = 2.5;
  double occupied = 0.7;
  bool parallel = true;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field(
        {"bay_width",
         "width of a bay in metres; it sets the other sizes: a bay is twice as long, an aisle 2.4 "
         "times as wide"},
        self.bay_width, {0.6, 10});
    field({"occupied", "proportion of bays with a parked car"}, self.occupied, {0, 1});
    field({"parallel", "bays at the lower wall lie along the aisle, not across"}, self.parallel);
  }

  /// Cells in a multiple of the width of a bay.
  int cells(double widths) const {
    return static_cast<int>(std::lround(widths * bay_width / FloorPlan::kMetresPerCell));
  }

  int bay() const { return cells(1); }
  int depth() const { return cells(2); }
  int aisle() const { return cells(2.4); }
  int bay_along_aisle() const { return cells(2.6); }
  int kerb() const { return std::max(1, cells(0.1)); }
  int lower_row() const { return parallel ? bay() : depth(); }
  /// Two rows back to back, with a kerb between.
  int double_row() const { return 2 * depth() + 1; }

  /// The lower row, an aisle and the upper row, as wide as one bay between two roads.
  MapSize least_size() const {
    return {2 * FloorPlan::kMargin + 2 * aisle() + 2 * kerb() + bay_along_aisle(),
            2 * FloorPlan::kMargin + lower_row() + aisle() + depth()};
  }
};

/// Bays side by side between two kerbs.
struct BayRow {
  Block area;       // without the kerbs
  bool lengthwise;  // cars stand along the aisle
};

/// The parts of the rows between roads, from left to right: their first columns and widths.
struct Stretch {
  int x;
  int width;
};

std::vector<Stretch> stretches_of(int width, const CarParkOptions& options) {
  constexpr int kMostBays = 16;
  const int road = options.aisle();
  const int longest = kMostBays * options.bay() + 2 * options.kerb();
  const int count = std::max(1, (width - road + longest + road - 1) / (longest + road));
  const int available = width - (count + 1) * road;
  std::vector<Stretch> stretches;
  int x = FloorPlan::kMargin;
  for (int i = 0; i < count; ++i) {
    x += road;
    stretches.push_back({x, part(i, count, available)});
    x += stretches.back().width;
  }
  return stretches;
}

class CarPark {
 public:
  CarPark(MapSize size, const CarParkOptions& options, Random& random)
      : options_(options), random_(random), plan_(size.width, size.height) {
    const Block floor{FloorPlan::kMargin, FloorPlan::kMargin, size.width - 2 * FloorPlan::kMargin,
                      size.height - 2 * FloorPlan::kMargin};
    plan_.build(std::span(&floor, 1));
    for (const Stretch& stretch : stretches_of(floor.width, options)) build(stretch, floor);
  }

  /// The park as a map. Gaps that nothing leads to are filled.
  GridMap map() {
    BitGrid free(plan_.cells().width(), plan_.cells().height());
    for (const Cell cell : every_cell(plan_.cells())) {
      if (plan_.cells()[cell] == CellState::free) free.set(cell, true);
    }
    const ConnectedComponents parts(free);
    const Cell start{FloorPlan::kFreeCorner, FloorPlan::kFreeCorner};
    for (const Cell cell : every_cell(plan_.cells())) {
      if (free[cell] && !parts.connected(start, cell, Adjacency::edges)) {
        plan_.draw_wall({cell.x, cell.y, 1, 1});
      }
    }
    return plan_.map();
  }

 private:
  void build(const Stretch& stretch, const Block& floor) {
    const int needed = options_.lower_row() + options_.aisle() + options_.depth();
    const int pitch = options_.double_row() + options_.aisle();
    const int doubles = (floor.height - needed) / pitch;
    const int left_over = floor.height - needed - doubles * pitch;
    int y = floor.y;
    add_row(stretch, y, options_.lower_row(), options_.parallel);
    y += options_.lower_row();
    for (int i = 0; i < doubles; ++i) {
      y += options_.aisle() + part(i, doubles + 1, left_over);
      add_row(stretch, y, options_.depth(), false);
      plan_.draw_wall({stretch.x, y + options_.depth(), stretch.width, 1});
      add_row(stretch, y + options_.depth() + 1, options_.depth(), false);
      y += options_.double_row();
    }
    add_row(stretch, floor.y_end() - options_.depth(), options_.depth(), false);
  }

  void add_row(const Stretch& stretch, int y, int depth, bool lengthwise) {
    const int kerb = options_.kerb();
    plan_.draw_wall({stretch.x, y, kerb, depth});
    plan_.draw_wall({stretch.x + stretch.width - kerb, y, kerb, depth});
    park({{stretch.x + kerb, y, stretch.width - 2 * kerb, depth}, lengthwise});
  }

  void park(const BayRow& row) {
    const int length = row.lengthwise ? options_.bay_along_aisle() : options_.bay();
    const int bays = row.area.width / length;
    int x = row.area.x;
    for (int i = 0; i < bays; ++i) {
      const int width = part(i, bays, row.area.width);
      if (random_.chance(options_.occupied)) {
        park_car({x, row.area.y, width, row.area.height}, row);
      }
      x += width;
    }
  }

  /// A car of 3.8 to 4.6 m x 1.75 to 1.9 m in a bay of 5 m x 2.5 m, and in proportion elsewhere.
  void park_car(const Block& bay, const BayRow& row) {
    const double unit = options_.cells(1);
    const double length = unit * (1.52 + 0.32 * random_.uniform());
    const double width = unit * (0.7 + 0.06 * random_.uniform());
    const double askew = radians_from(6 * random_.uniform() - 3);
    const double aside = unit * 0.1 * (random_.uniform() - 0.5);
    const double heading = row.lengthwise ? 0 : kPi / 2;
    draw_car({bay.x + bay.width / 2.0 + aside, bay.y + bay.height / 2.0, heading + askew}, length,
             width);
  }

  /// Fills the cells whose centres lie in a rectangle.
  void draw_car(const Pose& pose, double length, double width) {
    const SineCosine heading = sine_and_cosine(pose.heading);
    const int reach = static_cast<int>(std::ceil(length));
    const Cell middle = cell_at(pose.point());
    for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
      for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
        const double dx = x + 0.5 - pose.x;
        const double dy = y + 0.5 - pose.y;
        const double along = heading.cosine * dx + heading.sine * dy;
        const double across = heading.cosine * dy - heading.sine * dx;
        if (std::abs(along) <= length / 2 && std::abs(across) <= width / 2) {
          plan_.draw_wall({x, y, 1, 1});
        }
      }
    }
  }

  const CarParkOptions& options_;
  Random& random_;
  FloorPlan plan_;
};

GridMap generate(MapSize size, const CarParkOptions& options, Random& random) {
  return CarPark(size, options, random).map();
}

}  // namespace

GeneratorInfo car_park_generator() {
  GeneratorInfo info = generator_info<CarParkOptions>(
      "car_park", "a car park in metres: bays across and along the aisles, 0.1 m a cell", generate);
  info.free_corner = FloorPlan::kFreeCorner;
  info.default_width = 480;
  info.default_height = 330;
  return info;
}

}  // namespace wend
