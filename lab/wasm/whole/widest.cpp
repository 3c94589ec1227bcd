// Lab::widest(): how large a robot may be.

#include "lab/wasm/answers.hpp"
#include "lab/wasm/drawn_points.hpp"
#include "lab/wasm/json.hpp"
#include "lab/wasm/lab.hpp"
#include "wend/analysis/widest_path.hpp"

namespace wend::lab {

std::string Lab::widest(Point start, Point goal) {
  const auto view = session_.view();
  if (!view) return error_text(view.error());
  const FreeSpace& space = view->space;
  if (!space.contains(cell_at(start)) || !space.contains(cell_at(goal))) {
    return error_text({Status::invalid_map, "the start or the goal is not on the map"});
  }
  points_.clear();
  const auto found = widest_path(space, cell_at(start), cell_at(goal), moves_);
  if (!found) return Json().object().field("joined", false).end_object().text();
  points_ = drawn_points(found->path);
  return Json()
      .object()
      .field("joined", true)
      .field("radius", found->radius)
      .field("x", found->narrowest.x)
      .field("y", found->narrowest.y)
      .end_object()
      .text();
}

}  // namespace wend::lab
