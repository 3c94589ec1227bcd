#include "lab/wasm/painting/replay.hpp"

#include <algorithm>
#include <limits>

namespace wend::lab {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kFewOf =
    4;  // a quarter of the cells: more of them are cleared faster in order

}  // namespace

void Replay::begin(int width, int height, const PlaceGrid& places) {
  width_ = width;
  height_ = height;
  reach_ = places.on_corners() ? places.spacing : 0;
  const auto cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  expansions_.clear();
  if (cells == 0) return;  // the columns stay, for the next search
  if (expansion_.size() == cells && reached_.size() < cells / kFewOf) {
    clear_reached();
  } else {
    expansion_.assign(cells, 0);
    generation_.assign(cells, 0);
    parent_.assign(cells, kNone);
    known_.assign(cells, {kUnknown, kUnknown, kUnknown});
  }
  reached_.clear();
}

void Replay::clear_reached() {
  for (const std::uint32_t cell : reached_) {
    expansion_[cell] = 0;
    generation_[cell] = 0;
    parent_[cell] = kNone;
    known_[cell] = {kUnknown, kUnknown, kUnknown};
  }
}

void Replay::reach(std::uint32_t cell) {
  if (generation_[cell] == 0 && expansion_[cell] == 0) reached_.push_back(cell);
}

std::uint32_t Replay::index(Cell cell) const {
  // A vertex can lie on the far edges of the map.
  const int x = std::clamp(cell.x, 0, width_ - 1);
  const int y = std::clamp(cell.y, 0, height_ - 1);
  return static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width_) +
         static_cast<std::uint32_t>(x);
}

template <class Visit>
void Replay::for_cells_at(Cell place, Visit&& visit) const {
  if (reach_ == 0) return visit(index(place));
  const int right = std::min(place.x + reach_, width_);
  const int below = std::min(place.y + reach_, height_);
  for (int y = std::max(place.y - reach_, 0); y < below; ++y) {
    for (int x = std::max(place.x - reach_, 0); x < right; ++x) visit(index({x, y}));
  }
}

void Replay::on_generate(const SearchEvent& event) {
  const bool walked_back = !event.heading && generation_[index(event.cell)] != 0;
  if (walked_back) return;
  const std::uint32_t now = std::max(steps(), std::uint32_t{1});
  for_cells_at(event.cell, [&](std::uint32_t cell) {
    reach(cell);
    if (generation_[cell] == 0) generation_[cell] = now;
  });
  write_down(event);
}

void Replay::on_expand(const SearchEvent& event) {
  expansions_.push_back(index(event.cell));
  for_cells_at(event.cell, [&](std::uint32_t cell) {
    reach(cell);
    if (expansion_[cell] == 0) expansion_[cell] = steps();
  });
}

void Replay::on_relax(const SearchEvent& event) { write_down(event); }

void Replay::write_down(const SearchEvent& event) {
  const std::uint32_t parent = event.parent ? index(*event.parent) : kNone;
  const Known known{static_cast<float>(event.g), static_cast<float>(event.h),
                    static_cast<float>(event.f)};
  for_cells_at(event.cell, [&](std::uint32_t cell) {
    const bool knows_cheaper = event.heading && known_[cell].g <= known.g;
    if (knows_cheaper) return;
    known_[cell] = known;
    parent_[cell] = parent;
  });
}

}  // namespace wend::lab
