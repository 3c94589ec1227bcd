#pragma once

// CellPaints: the colour of every cell of a scene, and how much it counts where many cells share a
// pixel.

#include <optional>

#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend {

struct Paint {
  Colour colour;
  double weight = 1;

  friend constexpr bool operator==(const Paint&, const Paint&) = default;
};

/// A cell of two colours.
struct Stripes {
  Colour base;
  Colour stripe;

  friend constexpr bool operator==(const Stripes&, const Stripes&) = default;
};

class CellPaints {
 public:
  /// Both must outlive this; the scene's layers are as large as its map.
  CellPaints(const Scene& scene, const Style& style);

  int width() const { return scene_.space.width(); }
  int height() const { return scene_.space.height(); }

  Paint operator[](Cell cell) const;

  /// How rough ground shows where it needs stripes: under a role, or everywhere in a style that has
  /// greys alone.
  std::optional<Stripes> stripes(Cell cell) const;

  /// The colour of a cell's value in the heatmap, where it has a finite one and is no obstacle.
  std::optional<Colour> heat(Cell cell) const;

 private:
  const Scene& scene_;
  const Style& style_;
  std::optional<HeatRange> range_;  // of the heatmap, where it has a finite value
};

/// Is that ground drawn as rough, by itself or under a role?
bool is_rough(const Scene& scene, Cell cell);

}  // namespace wend
