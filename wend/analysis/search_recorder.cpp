#include "wend/analysis/search_recorder.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace wend {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

SearchLayers empty_layers(int width, int height) {
  return {.expansion = {width, height, 0},
          .generation = {width, height, 0},
          .g = {width, height, kUnknown},
          .h = {width, height, kUnknown},
          .f = {width, height, kUnknown},
          .parent = {width, height, std::nullopt}};
}

}  // namespace

SearchRecorder::SearchRecorder(const FreeSpace& space) : SearchRecorder(space, cells_of(space)) {}

SearchRecorder::SearchRecorder(const FreeSpace& space, const PlaceGrid& places)
    : reach_(places.on_corners() ? places.spacing : 0),
      layers_(empty_layers(space.width(), space.height())) {}

/// Visits the cell, or those that touch the corner.
template <class Visit>
void SearchRecorder::for_cells_at(Cell place, Visit&& visit) const {
  if (reach_ == 0) return visit(place);
  const int right = std::min(place.x + reach_, layers_.g.width());
  const int bottom = std::min(place.y + reach_, layers_.g.height());
  for (int y = std::max(place.y - reach_, 0); y < bottom; ++y) {
    for (int x = std::max(place.x - reach_, 0); x < right; ++x) visit(Cell{x, y});
  }
}

void SearchRecorder::on_generate(const SearchEvent& event) {
  const bool walked_back = !event.heading && layers_.generation[event.cell] != 0;
  if (walked_back) return;
  ++generated_;
  for_cells_at(event.cell, [this](Cell cell) {
    std::uint32_t& generation = layers_.generation[cell];
    if (generation == 0) generation = generated_;
  });
  write_down(event);
}

void SearchRecorder::on_expand(const SearchEvent& event) {
  expansions_.push_back(event.cell);
  generated_before_.push_back(generated_);
  if (!event.way.empty()) motions_.add(event.way);
  for_cells_at(event.cell, [this](Cell cell) {
    std::uint32_t& expansion = layers_.expansion[cell];
    if (expansion == 0) expansion = static_cast<std::uint32_t>(expansions_.size());
  });
}

void SearchRecorder::on_relax(const SearchEvent& event) { write_down(event); }

void SearchRecorder::write_down(const SearchEvent& event) {
  std::optional<Direction> towards_parent;
  if (event.parent) towards_parent = nearest_direction(event.cell, *event.parent);
  for_cells_at(event.cell, [&](Cell cell) {
    const bool knows_cheaper = event.heading && layers_.g[cell] <= event.g;
    if (knows_cheaper) return;
    layers_.g[cell] = event.g;
    layers_.h[cell] = event.h;
    layers_.f[cell] = event.f;
    layers_.parent[cell] = towards_parent;
  });
}

void SearchRecorder::clear() {
  layers_ = empty_layers(layers_.g.width(), layers_.g.height());
  expansions_.clear();
  motions_.clear();
  generated_before_.clear();
  generated_ = 0;
}

SearchSnapshot SearchRecorder::snapshot(std::size_t expansions) const {
  assert(expansions <= expansions_.size());
  const int width = layers_.g.width();
  const int height = layers_.g.height();
  const bool over = expansions == expansions_.size();
  const std::uint32_t generated = over ? generated_ : generated_before_[expansions];
  SearchSnapshot snapshot{BitGrid(width, height), BitGrid(width, height), std::nullopt};
  for (const Cell cell : every_cell(layers_.generation)) {
    const std::uint32_t generation = layers_.generation[cell];
    if (generation == 0 || generation > generated) continue;
    const std::uint32_t expansion = layers_.expansion[cell];
    const bool expanded = expansion != 0 && expansion <= expansions;
    (expanded ? snapshot.expanded : snapshot.frontier).set(cell, true);
  }
  if (expansions > 0) {
    const Cell place = expansions_[expansions - 1];
    snapshot.current = Cell{std::min(place.x, width - 1), std::min(place.y, height - 1)};
  }
  return snapshot;
}

}  // namespace wend
