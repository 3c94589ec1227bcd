#include "wend/generate/furniture.hpp"

namespace wend {
namespace {

constexpr int kDoor = 9;        // width of a door
constexpr int kDoorFrom = 4;    // from the side wall
constexpr int kDoorSpace = 13;  // deep, kept free behind a door
constexpr int kDeskDepth = 7;
constexpr int kDeskLength = 14;
constexpr int kChair = 2;    // radius
constexpr int kShelf = 4;    // depth
constexpr int kStairs = 22;  // width of a staircase

/// Draws into one room, in the coordinates of the room.
class Decorator {
 public:
  Decorator(FloorPlan& plan, const Room& room) : plan_(plan), room_(room) {}

  int width() const { return room_.width(); }
  int depth() const { return room_.depth(); }

  bool place(const Block& piece) { return plan_.place(room_.to_plan(piece)); }
  bool place_round(int u, int v, int radius) {
    const Block centre = room_.to_plan({u, v, 1, 1});
    return plan_.place_round({centre.x, centre.y}, radius);
  }
  /// Places a piece along v, unless it would be very short.
  void shelf(const Block& piece) {
    if (piece.height >= 8) place(piece);
  }
  void chair(int u, int v) { place_round(u, v, kChair); }
  void draw_wall(const Block& wall) { plan_.draw_wall(room_.to_plan(wall)); }

  /// Cuts a gap in the corridor's wall.
  void opening(int u, int width) {
    plan_.open(room_.to_plan({u, -FloorPlan::kInnerWall, width, FloorPlan::kInnerWall}));
    plan_.keep_free(room_.to_plan({u, 0, width, kDoorSpace}));
  }

  /// Draws an open door, with its leaf in the room, at the side `u` of the gap.
  void door(int u, bool leaf_first) {
    opening(u, kDoor);
    draw_wall({leaf_first ? u - 1 : u + kDoor, 0, 1, kDoor - 1});
  }

 private:
  FloorPlan& plan_;
  const Room& room_;
};

void furnish_office(Decorator& room, Random& random) {
  const int window = room.depth();
  if (room.width() >= 36 && random.chance(0.6)) {  // two people, face to face at the window
    const int middle = room.width() / 2 + random.between(0, 2);
    for (const int side : {-1, 1}) {
      const int desk = side < 0 ? middle - kDeskDepth : middle;
      room.place({desk, window - kDeskLength, kDeskDepth, kDeskLength});
      room.chair(middle + side * (kDeskDepth + 3) - (side > 0 ? 1 : 0), window - 7);
    }
  } else {  // one, at a desk with a side table
    const int wall = room.width();
    room.place({wall - kDeskDepth, window - 22, kDeskDepth, 15});
    room.place({wall - 18, window - kDeskDepth, 18, kDeskDepth});
    room.chair(wall - 11, window - 11);
  }
  if (random.chance(0.7)) {  // shelves at the corridor
    room.place({room.width() - 21, 0, 21, kShelf});
  }
  if (room.width() >= 32 && random.chance(0.6)) {  // shelves at the side wall
    room.shelf({0, kDoorSpace + 3, kShelf, room.depth() - kDoorSpace - 13});
  }
  if (random.chance(0.5)) room.place_round(3, window - 4, 2);  // a plant
}

void furnish_meeting(Decorator& room, Random& random) {
  const bool across = room.width() >= room.depth();
  const int length = (across ? room.width() : room.depth() - 4) - 26;
  const int breadth = 12;
  const int u = room.width() / 2;
  const int v = room.depth() / 2 + 3;
  const Block table = across ? Block{u - length / 2, v - breadth / 2, length, breadth}
                             : Block{u - breadth / 2, v - length / 2, breadth, length};
  if (length < 12 || !room.place(table)) return;
  const int seats = length / 8;
  for (int i = 0; i < seats; ++i) {
    const int along = (2 * i + 1) * length / (2 * seats);
    for (const int beside : {-4, breadth + 3}) {
      if (across) {
        room.chair(table.x + along, table.y + beside);
      } else {
        room.chair(table.x + beside, table.y + along);
      }
    }
  }
  if (across) {
    room.chair(table.x - 4, v);
    room.chair(table.x_end() + 3, v);
  }
  if (random.chance(0.6)) room.place({room.width() - 24, 0, 20, kShelf});
}

void furnish_open_plan(Decorator& room, Random& random) {
  constexpr int kIsland = 31;  // from one double row of desks to the next
  constexpr int kDesk = 13;
  const int desks = std::max(1, (room.depth() - kDoorSpace) / kDesk);
  const int islands = std::max(1, (room.width() - 4) / kIsland);
  for (int i = 0; i < islands; ++i) {
    const int middle = (2 * i + 1) * room.width() / (2 * islands);
    for (int j = 0; j < desks; ++j) {
      const int v = room.depth() - (j + 1) * kDesk;
      for (const int side : {-1, 1}) {
        if (!room.place({side < 0 ? middle - kDeskDepth : middle, v, kDeskDepth, kDesk})) continue;
        if (random.chance(0.85)) {
          room.chair(middle + side * (kDeskDepth + 3) - (side > 0 ? 1 : 0), v + kDesk / 2);
        }
      }
    }
  }
  for (int u = 30; u + 45 < room.width(); u += 45) room.place({u, 0, 24, kShelf});
}

void furnish_kitchen(Decorator& room, Random& random) {
  const int counter = room.width() - 6;
  room.place({counter, 0, 6, room.depth()});
  const int tables = std::max(1, (counter - 4) / 32);
  for (int i = 0; i < tables; ++i) {
    const int u = (2 * i + 1) * counter / (2 * tables);
    const int v = room.depth() - 14 + random.between(-1, 1);
    if (!room.place_round(u, v, 5)) continue;
    for (const Cell side : {Cell{-7, -7}, Cell{7, -7}, Cell{-7, 7}, Cell{7, 7}}) {
      room.chair(u + side.x, v + side.y);
    }
  }
}

void furnish_storage(Decorator& room) {
  const int length = room.depth() - kDoorSpace - 3;
  room.place({room.width() - 6, 0, 6, room.depth()});
  room.shelf({0, kDoorSpace + 3, 6, length});
  for (int u = 16; u + 18 < room.width(); u += 18) room.shelf({u, kDoorSpace + 3, 8, length - 10});
}

void furnish_restroom(Decorator& room) {
  constexpr int kStall = 10;
  constexpr int kStallDepth = 15;
  const int window = room.depth();
  if (room.depth() < kDoorSpace + kStallDepth + 3) return furnish_storage(room);  // too shallow
  const int stalls = std::max(1, (room.width() - 8) / kStall);
  for (int i = 0; i < stalls; ++i) {
    const int u = i * kStall;
    room.place({u + 3, window - 6, 4, 6});
    room.draw_wall({u + kStall - 1, window - kStallDepth, 1, kStallDepth});  // to the next stall
    room.draw_wall({u, window - kStallDepth, 2, 1});                         // beside its door
    room.draw_wall({u + kStall - 3, window - kStallDepth, 2, 1});
  }
  room.place({room.width() - 5, 0, 5, room.depth() - kStallDepth - 4});  // basins
}

/// Lifts and a staircase.
void furnish_core(Decorator& room) {
  const int stairs = room.width() - kStairs;
  const int window = room.depth();
  room.place({stairs, 10, kStairs, window - 10});
  for (int v = 13; v < window - 10; v += 3) room.draw_wall({stairs, v, kStairs, 1});
  room.draw_wall({stairs + 10, 10, 2, window - 20});
  constexpr int kLift = 18;
  for (int u = 0; u + kLift <= stairs - 4; u += kLift + 1) {
    const Block cabin{u, window - kLift, kLift, kLift};
    if (!room.place(cabin)) continue;
    for (int i = 0; i < kLift; ++i) {  // crossed out, as plans show what has no floor
      room.draw_wall({cabin.x + i, cabin.y + i, 1, 1});
      room.draw_wall({cabin.x + kLift - 1 - i, cabin.y + i, 1, 1});
    }
  }
}

void furnish_lobby(Decorator& room, Random& random) {
  const int middle = room.width() / 2;
  const int desk = std::min(26, room.width() - 24);
  room.place({middle - desk / 2, room.depth() / 2, desk, 6});
  room.place({middle - desk / 2, room.depth() / 2 + 6, 6, 7});
  room.chair(middle + 1, room.depth() / 2 + 10);
  for (const int u : {0, room.width() - 8}) {  // sofas
    if (random.chance(0.8)) room.place({u, room.depth() - 23, 8, 14});
    room.place_round(u + 4, room.depth() - 5, 3);
  }
}

}  // namespace

void open_to_corridor(FloorPlan& plan, const Room& room) {
  Decorator decorator(plan, room);
  switch (room.kind) {
    case RoomKind::office:
    case RoomKind::meeting:
    case RoomKind::restroom:
    case RoomKind::storage:
      return decorator.door(kDoorFrom, true);
    case RoomKind::open_plan:
      decorator.door(kDoorFrom, true);
      return decorator.door(room.width() - kDoorFrom - kDoor, false);
    case RoomKind::kitchen:
      return decorator.opening(kDoorFrom, kDoor + 5);
    case RoomKind::core:
      return decorator.opening(2, room.width() - kStairs - 4);
    case RoomKind::lobby:
      return decorator.opening(0, room.width());
  }
}

void furnish(FloorPlan& plan, const Room& room, Random& random) {
  Decorator decorator(plan, room);
  switch (room.kind) {
    case RoomKind::office:
      return furnish_office(decorator, random);
    case RoomKind::meeting:
      return furnish_meeting(decorator, random);
    case RoomKind::open_plan:
      return furnish_open_plan(decorator, random);
    case RoomKind::kitchen:
      return furnish_kitchen(decorator, random);
    case RoomKind::restroom:
      return furnish_restroom(decorator);
    case RoomKind::storage:
      return furnish_storage(decorator);
    case RoomKind::core:
      return furnish_core(decorator);
    case RoomKind::lobby:
      return furnish_lobby(decorator, random);
  }
}

}  // namespace wend
