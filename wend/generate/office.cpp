// A floor of an office building, in cells of 0.1 m: corridors with rooms on both sides, windows all
// around. Long floors have cross corridors; deep ones have several corridors with courtyards between.

#include <algorithm>

#include "wend/generate/furniture.hpp"
#include "wend/generate/generator_info.hpp"

namespace wend {
namespace {

struct OfficeOptions {
  bool furniture = true;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"furniture", "add desks, chairs and shelves to the rooms"}, self.furniture);
  }

  MapSize least_size() const { return {80, 80}; }
};

constexpr int kWall = FloorPlan::kInnerWall;
constexpr int kCrossCorridor = 18;

/// Cells [begin, end) along one axis.
struct Span {
  int begin;
  int end;

  int length() const { return end - begin; }
};

/// Cuts `whole` into `parts` of about the same length with walls between them.
std::vector<Span> cut(Span whole, int parts, int between) {
  std::vector<Span> spans;
  spans.reserve(static_cast<std::size_t>(parts));
  const int length = whole.length() + between;
  for (int i = 0; i < parts; ++i) {
    spans.push_back(
        {whole.begin + i * length / parts, whole.begin + (i + 1) * length / parts - between});
  }
  return spans;
}

/// A row of rooms between a corridor and the facade, or the next row.
struct Row {
  Span x;
  Span y;
  bool corridor_above;
  std::vector<Room> rooms;
};

struct KindOfRoom {
  RoomKind kind;
  int least_width;
  int greatest_width;
  int weight;  // relative frequency
};

constexpr std::array kKinds{
    KindOfRoom{RoomKind::office, 27, 33, 6},  KindOfRoom{RoomKind::office, 36, 44, 4},
    KindOfRoom{RoomKind::meeting, 42, 58, 3}, KindOfRoom{RoomKind::open_plan, 66, 130, 3},
    KindOfRoom{RoomKind::kitchen, 36, 44, 2}, KindOfRoom{RoomKind::restroom, 28, 40, 2},
    KindOfRoom{RoomKind::storage, 24, 30, 1}, KindOfRoom{RoomKind::core, 46, 66, 2},
};

const KindOfRoom& drawn_kind(Random& random) {
  int total = 0;
  for (const KindOfRoom& kind : kKinds) total += kind.weight;
  int drawn = random.between(0, total - 1);
  std::size_t i = 0;
  while (drawn >= kKinds[i].weight) drawn -= kKinds[i++].weight;
  return kKinds[i];
}

/// Does a row have at most one room of this kind?
bool is_service(RoomKind kind) {
  return kind == RoomKind::kitchen || kind == RoomKind::restroom || kind == RoomKind::storage ||
         kind == RoomKind::core;
}

struct WantedRoom {
  RoomKind kind;
  int width;
};

/// The rooms that fill a row, with offices at both ends. All are a little wider or narrower than drawn.
std::vector<WantedRoom> wanted_rooms(int length, bool with_lobby, Random& random) {
  std::vector<WantedRoom> rooms;
  rooms.push_back({RoomKind::office, random.between(27, 40)});
  int used = rooms.front().width;
  const int last = random.between(27, 40);
  const int lobby_from = with_lobby ? length / 4 : length;
  bool lobby = with_lobby;
  std::vector<RoomKind> services;
  for (int misfits = 0; misfits < 12;) {
    WantedRoom room{};
    if (lobby && used >= lobby_from) {
      room = {RoomKind::lobby, random.between(44, 56)};
    } else {
      const KindOfRoom& kind = drawn_kind(random);
      if (is_service(kind.kind) &&
          std::find(services.begin(), services.end(), kind.kind) != services.end()) {
        ++misfits;
        continue;
      }
      room = {kind.kind, random.between(kind.least_width, kind.greatest_width)};
    }
    if (used + kWall + room.width + kWall + last > length + 8) {
      ++misfits;
      continue;
    }
    used += kWall + room.width;
    if (is_service(room.kind)) services.push_back(room.kind);
    if (room.kind == RoomKind::lobby) lobby = false;
    rooms.push_back(room);
  }
  rooms.push_back({RoomKind::office, last});
  return rooms;
}

void divide(Row& row, bool with_lobby, Random& random) {
  const std::vector<WantedRoom> wanted = wanted_rooms(row.x.length(), with_lobby, random);
  int total = 0;
  for (const WantedRoom& room : wanted) total += room.width;
  const int available = row.x.length() - kWall * (static_cast<int>(wanted.size()) - 1);
  int before = 0;
  int x = row.x.begin;
  for (const WantedRoom& room : wanted) {
    const int width = (before + room.width) * available / total - before * available / total;
    before += room.width;
    row.rooms.push_back({{x, row.y.begin, width, row.y.length()},
                         room.kind,
                         row.corridor_above,
                         random.chance(0.5)});
    x += width + kWall;
  }
}

struct Layout {
  std::vector<Block> corridors;
  std::vector<Row> rows;
};

/// Lays out a building at least as wide as it is high.
Layout layout(MapSize size, Random& random) {
  const Span x{FloorPlan::kMargin, size.width - FloorPlan::kMargin};
  const Span y{FloorPlan::kMargin, size.height - FloorPlan::kMargin};
  const int stripes = std::max(1, (y.length() + 50) / 98);
  const int crossings = stripes > 1 ? std::max(1, (x.length() + 150) / 320) : 0;
  Layout plan;

  std::vector<Span> wings = cut(x, crossings + 1, kCrossCorridor + 2 * kWall);
  for (std::size_t i = 0; i + 1 < wings.size(); ++i) {
    const int shift = random.between(-12, 12);
    wings[i].end += shift;
    wings[i + 1].begin += shift;
    plan.corridors.push_back({wings[i].end + kWall, y.begin, kCrossCorridor, y.length()});
  }
  for (const Span stripe : cut(y, stripes, kWall)) {
    const int corridor = random.between(15, 18);
    const int lower = (stripe.length() - corridor - 2 * kWall) * random.between(45, 55) / 100;
    const Span lower_rooms{stripe.begin, stripe.begin + lower};
    const Span upper_rooms{lower_rooms.end + corridor + 2 * kWall, stripe.end};
    plan.corridors.push_back({x.begin, lower_rooms.end + kWall, x.length(), corridor});
    for (const Span wing : wings) plan.rows.push_back({wing, lower_rooms, true, {}});
    for (const Span wing : wings) plan.rows.push_back({wing, upper_rooms, false, {}});
  }
  const std::size_t entrance = wings.size() / 2;
  for (std::size_t i = 0; i < plan.rows.size(); ++i) {
    divide(plan.rows[i], i == entrance && plan.rows[i].x.length() > 140, random);
  }

  // Courtyards: two rows back to back that are not built; at most one between two stripes, and never
  // one behind the other.
  std::size_t last_wing = wings.size();
  for (std::size_t stripe = 0; stripe + 1 < static_cast<std::size_t>(stripes); ++stripe) {
    const std::size_t wing = random.below(wings.size());
    if (wing == last_wing || !random.chance(0.6)) continue;
    last_wing = wing;
    const std::size_t upper_row = (2 * stripe + 1) * wings.size() + wing;
    plan.rows[upper_row].rooms.clear();
    plan.rows[upper_row + wings.size()].rooms.clear();
  }
  // In the rooms with the free corners, the furniture goes to the side away from them.
  plan.rows.front().rooms.front().mirrored = false;
  plan.rows.back().rooms.back().mirrored = true;
  // A corner that is not built, away from the free corners.
  std::vector<Room>& upper_left = plan.rows[plan.rows.size() - wings.size()].rooms;
  std::vector<Room>& lower_right = plan.rows[wings.size() - 1].rooms;
  if (upper_left.size() >= 3 && random.chance(0.7)) upper_left.erase(upper_left.begin());
  if (lower_right.size() >= 4 && random.chance(0.4)) lower_right.pop_back();
  return plan;
}

GridMap generate(MapSize size, const OfficeOptions& options, Random& random) {
  const bool tall = size.height > size.width;
  if (tall) std::swap(size.width, size.height);
  const Layout building = layout(size, random);
  std::vector<Block> floors = building.corridors;
  for (const Row& row : building.rows) {
    for (const Room& room : row.rooms) floors.push_back(room.floor);
  }
  FloorPlan plan(size.width, size.height);
  plan.build(floors);
  for (const Block& floor : floors) plan.cut_windows(floor);
  const Room& first = building.rows.front().rooms.front();
  const Room& last = building.rows.back().rooms.back();
  for (const Room* room : {&first, &last}) {  // from the free corner to the door
    plan.keep_free(room->to_plan({0, 0, 9, room->depth()}));
  }
  for (const Row& row : building.rows) {
    for (const Room& room : row.rooms) {
      open_to_corridor(plan, room);
      if (options.furniture) furnish(plan, room, random);
    }
  }
  if (tall) plan.transpose();
  return plan.map();
}

}  // namespace

GeneratorInfo office_generator() {
  GeneratorInfo info = generator_info<OfficeOptions>(
      "office", "a floor of an office building, 0.1 m a cell", generate);
  info.free_corner = FloorPlan::kFreeCorner;
  info.default_width = 160;
  info.default_height = 100;
  return info;
}

}  // namespace wend
