#pragma once

// The furniture in the rooms of an office.

#include "wend/base/random.hpp"
#include "wend/generate/floor_plan.hpp"

namespace wend {

enum class RoomKind { office, meeting, open_plan, kitchen, restroom, storage, core, lobby };

/// A room and the corridor it opens to. Inside, u runs along the corridor's wall and v from there
/// to the windows, so that one arrangement of furniture serves all rooms.
struct Room {
  Block floor;
  RoomKind kind;
  bool corridor_above;  // at greater y
  bool mirrored;        // u runs towards smaller x

  int width() const { return floor.width; }
  int depth() const { return floor.height; }

  Block to_plan(const Block& uv) const {
    return {mirrored ? floor.x_end() - uv.x_end() : floor.x + uv.x,
            corridor_above ? floor.y_end() - uv.y_end() : floor.y + uv.y, uv.width, uv.height};
  }
};

/// Makes doors, or a wide opening, in the wall towards the corridor. The floor behind is kept free.
void open_to_corridor(FloorPlan& plan, const Room& room);

/// Places the furniture of a room.
void furnish(FloorPlan& plan, const Room& room, Random& random);

}  // namespace wend
