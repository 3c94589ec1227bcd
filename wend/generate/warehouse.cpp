// A warehouse, in cells of 0.1 m: rows of racks with aisles between them, a loading zone with dock
// doors at the lower wall.

#include <algorithm>
#include <cmath>

#include "wend/generate/floor_plan.hpp"
#include "wend/generate/generator_info.hpp"

namespace wend {
namespace {

constexpr int kRack = 11;          // depth of a rack
constexpr int kBay = 27;           // between two of its uprights
constexpr int kLongestRack = 280;  // cross aisles divide longer ones
constexpr int kShortestRack = kBay;
constexpr int kPalletLength = 12;
constexpr int kPalletWidth = 8;

struct WarehouseOptions {
  double aisle_width = 2.8;
  double stock = 0.75;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"aisle_width", "lower limit on the distance between two racks in metres"},
          self.aisle_width, {1, 100});
    field({"stock", "proportion of rack places with goods"}, self.stock, {0, 1});
  }

  int aisle() const {
    return static_cast<int>(std::lround(aisle_width / FloorPlan::kMetresPerCell));
  }

  int least_loading_zone() const { return std::max(30, aisle()); }

  MapSize least_size() const {
    return {2 * FloorPlan::kMargin + 2 * kRack + aisle(),
            2 * FloorPlan::kMargin + least_loading_zone() + kShortestRack + aisle()};
  }
};

/// Uprights along a rack, and goods between them.
void fill_rack(FloorPlan& plan, const Block& rack, double stock, Random& random) {
  plan.place(rack);
  const int bays = std::max(1, rack.height / kBay);
  for (int i = 0; i < bays; ++i) {
    const int begin = rack.y + i * rack.height / bays;
    const int end = rack.y + (i + 1) * rack.height / bays;
    plan.draw_wall({rack.x, begin, rack.width, 1});
    for (int place = 0; place < 3; ++place) {
      const int y = begin + 1 + place * (end - begin - 1) / 3;
      if (random.chance(stock)) plan.draw_wall({rack.x + 2, y + 1, rack.width - 4, 6});
    }
  }
}

/// Places racks from the loading zone to the far wall: single ones at the side walls, double ones
/// between aisles.
void place_racks(FloorPlan& plan, const Block& area, const WarehouseOptions& options,
                 Random& random) {
  const int aisle = options.aisle();
  const int doubles = std::max(0, (area.width - 2 * kRack - aisle) / (2 * kRack + aisle));
  const int aisles = doubles + 1;
  const int aisles_width = area.width - 2 * kRack * aisles;
  const int segments = 1 + area.height / (kLongestRack + aisle);
  for (int segment = 0; segment < segments; ++segment) {
    const int begin = segment * (area.height + aisle) / segments;
    const int end = (segment + 1) * (area.height + aisle) / segments - aisle;
    const auto rack_at = [&](int x) {
      fill_rack(plan, {area.x + x, area.y + begin, kRack, end - begin}, options.stock, random);
    };
    for (int i = 0; i < aisles; ++i) {
      const int left = 2 * kRack * i + aisles_width * i / aisles;
      const int right = 2 * kRack * i + kRack + aisles_width * (i + 1) / aisles;
      rack_at(left);
      rack_at(right);
    }
  }
}

/// Places pallets that wait in front of a dock door, two side by side.
void place_pallets(FloorPlan& plan, const Block& lane, double stock, Random& random) {
  constexpr int kPalletGap = 3;
  for (int y = lane.y; y + kPalletLength <= lane.y_end(); y += kPalletLength + kPalletGap) {
    for (int x = lane.x; x + kPalletWidth <= lane.x_end(); x += kPalletWidth + kPalletGap) {
      if (random.chance(stock)) plan.place({x, y, kPalletWidth, kPalletLength});
    }
  }
}

void lay_out_loading_zone(FloorPlan& plan, const Block& zone, double stock, Random& random) {
  constexpr int kDock = 28;
  constexpr int kDockPitch = 56;
  constexpr int kLane = 3 * kPalletWidth + 2 * 3;
  const int docks = std::max(1, (zone.width - 24) / kDockPitch);
  for (int i = 0; i < docks; ++i) {
    const int middle = zone.x + (2 * i + 1) * zone.width / (2 * docks);
    plan.cut_window({middle - kDock / 2, zone.y - 1, kDock, 1}, {0, -1});
    // Leaves room to turn in front of the door and in front of the racks.
    place_pallets(plan, {middle - kLane / 2, zone.y + 8, kLane, zone.height - 18}, stock, random);
  }
}

GridMap generate(MapSize size, const WarehouseOptions& options, Random& random) {
  const int aisle = options.aisle();
  const Block hall = Block{0, 0, size.width, size.height}.grown(-FloorPlan::kMargin);
  const int zone_height = std::clamp(hall.height / 4, options.least_loading_zone(),
                                     std::max(options.least_loading_zone(), 90));
  const Block zone{hall.x, hall.y, hall.width, zone_height};
  const Block racks{hall.x, zone.y_end(), hall.width, hall.height - zone_height - aisle};

  FloorPlan plan(size.width, size.height);
  plan.build({&hall, 1});
  place_racks(plan, racks, options, random);
  lay_out_loading_zone(plan, zone, options.stock, random);
  return plan.map();
}

}  // namespace

GeneratorInfo warehouse_generator() {
  GeneratorInfo info = generator_info<WarehouseOptions>(
      "warehouse", "racks in rows with aisles and a loading zone, 0.1 m a cell", generate);
  info.free_corner = FloorPlan::kFreeCorner;
  info.default_width = 160;
  info.default_height = 120;
  return info;
}

}  // namespace wend
