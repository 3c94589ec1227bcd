// Edits of the C interface: boxes of cells, with new states or new costs.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "wend/c/boundary.hpp"
#include "wend/c/objects.hpp"
#include "wend/map/map_edit.hpp"

namespace wend::c {
namespace {

/// The cells of an edit.
struct Box {
  Cell corner;
  std::int32_t width;
  std::int32_t height;
};

/// Are there as many values as the box has cells?
Expected<void, Failure> check_size(const Box& box, std::size_t values, std::string_view what) {
  const auto& [corner, width, height] = box;
  if (width < 1 || height < 1 || width > static_cast<std::int64_t>(GridMap::kMaxCells) / height ||
      values != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    return refused("there are " + std::to_string(values) + " " + std::string(what) +
                   " for a box of " + std::to_string(width) + " x " + std::to_string(height) +
                   " cells");
  }
  return {};
}

Expected<MapEdit, Failure> edit_of(const Box& box, std::span<const std::uint8_t> states) {
  if (const auto fits = check_size(box, states.size(), "bytes"); !fits) {
    return Unexpected<Failure>(fits.error());
  }
  const std::int32_t width = box.width;
  MapEdit edit{.corner = box.corner, .states = Grid<CellState>(width, box.height)};
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] > static_cast<std::uint8_t>(CellState::unknown)) {
      return refused("states[" + std::to_string(i) + "] is " + std::to_string(states[i]) +
                     ": 0 free, 1 occupied or 2 unknown expected");
    }
    const auto column = static_cast<int>(i % static_cast<std::size_t>(width));
    const auto row = static_cast<int>(i / static_cast<std::size_t>(width));
    edit.states[{column, row}] = static_cast<CellState>(states[i]);
  }
  return edit;
}

Expected<MapEdit, Failure> edit_of(const Box& box, std::span<const double> terrain) {
  if (const auto fits = check_size(box, terrain.size(), "multipliers"); !fits) {
    return Unexpected<Failure>(fits.error());
  }
  return MapEdit{.corner = box.corner,
                 .terrain = {box.width, box.height, {terrain.begin(), terrain.end()}}};
}

/// Edits the map by an array of the caller, which calls it `name`.
template <class Value>
wend_status edit_by(wend_session* session, const Box& box, const Value* values, std::size_t count,
                    std::string_view name, wend_error* error) {
  return guarded(error, [&]() -> Expected<void, Failure> {
    if (session == nullptr) return refused("session is null");
    if (values == nullptr) return refused(std::string(name) + " is null");
    const auto edit = edit_of(box, std::span(values, count));
    if (!edit) return Unexpected<Failure>(edit.error());
    return or_without_planners(*session, [&]() -> Expected<void, Failure> {
      const auto done = session->edit(*edit);
      if (!done) return failed(done.error());
      return {};
    });
  });
}

}  // namespace
}  // namespace wend::c

using namespace wend::c;

wend_status wend_session_edit(wend_session* session, int32_t x, int32_t y, int32_t width,
                              int32_t height, const uint8_t* states, size_t size,
                              wend_error* error) {
  return edit_by(session, {{x, y}, width, height}, states, size, "states", error);
}

wend_status wend_session_edit_terrain(wend_session* session, int32_t x, int32_t y, int32_t width,
                                      int32_t height, const double* terrain, size_t count,
                                      wend_error* error) {
  return edit_by(session, {{x, y}, width, height}, terrain, count, "terrain", error);
}
