#include "wend/planner/search_recorder.hpp"

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

SearchRecorder::SearchRecorder(const FreeSpace& space)
    : y_up_(space.map().frame().y_up), layers_(empty_layers(space.width(), space.height())) {}

void SearchRecorder::on_generate(const SearchEvent& event) {
  if (layers_.generation[event.cell] != 0) return;
  layers_.generation[event.cell] = ++generated_;
  write_down(event);
}

void SearchRecorder::on_expand(const SearchEvent& event) {
  expansions_.push_back(event.cell);
  generated_before_.push_back(generated_);
  std::uint32_t& expansion = layers_.expansion[event.cell];
  if (expansion == 0) expansion = static_cast<std::uint32_t>(expansions_.size());
}

void SearchRecorder::on_relax(const SearchEvent& event) { write_down(event); }

void SearchRecorder::write_down(const SearchEvent& event) {
  layers_.g[event.cell] = event.g;
  layers_.h[event.cell] = event.h;
  layers_.f[event.cell] = event.f;
  if (event.parent) {
    layers_.parent[event.cell] = nearest_direction(event.cell, *event.parent, y_up_);
  }
}

void SearchRecorder::clear() {
  layers_ = empty_layers(layers_.g.width(), layers_.g.height());
  expansions_.clear();
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
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t generation = layers_.generation[{x, y}];
      if (generation == 0 || generation > generated) continue;
      const std::uint32_t expansion = layers_.expansion[{x, y}];
      const bool expanded = expansion != 0 && expansion <= expansions;
      (expanded ? snapshot.expanded : snapshot.frontier).set({x, y}, true);
    }
  }
  if (expansions > 0) snapshot.current = expansions_[expansions - 1];
  return snapshot;
}

}  // namespace wend
