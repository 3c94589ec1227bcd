#pragma once

// --show: layers of a search, of the costs to the goal and of the map, instead of the path alone.

#include <optional>
#include <string>
#include <vector>

#include "cli/arguments/parser.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/terminal.hpp"
#include "wend/analysis/layer.hpp"
#include "wend/render/picture/panels.hpp"
#include "wend/render/scene.hpp"

namespace wend::cli {

class ShownLayers {
 public:
  /// --show LAYER[,LAYER...], once or more.
  void add_to(Parser& app);

  /// --count-from 0|1
  void add_counting_to(Parser& app);

  /// The layer with orders counted from where they were asked to begin.
  Layer counted(Layer layer) const;

  /// The layer as text and JSON have it: if orders are counted from 0, -1 stands where there is none.
  Layer as_numbers(Layer layer) const;

  const std::vector<LayerKind>& kinds() const { return kinds_; }
  bool empty() const { return kinds_.empty(); }

  /// Is there one of the order of expansion or generation?
  bool any_order() const;

  /// Is there one from that source?
  bool any_from(LayerSource source) const;

 private:
  bool counts(const Layer& layer) const;

  std::vector<LayerKind> kinds_;
  bool from_zero_ = false;
};

/// What a layer is, with the unit of lengths: "clearance in m" where the map has metres.
std::string layer_title(LayerKind kind, const Frame& frame);

/// The scene with the layer drawn on the map.
Scene with_layer(Scene scene, const Layer& layer);

/// A title and an aligned grid of numbers or arrows; nothing where the map is too large for it.
std::optional<std::string> layer_grid(const Scene& scene, const Layer& layer, const Screen& screen,
                                      StyleName style);

/// A title and an aligned grid of numbers or arrows where the map is small enough for it, else a
/// picture; empty where that is not to be shown.
std::string layer_text(const Scene& scene, const Layer& layer, const Screen& screen,
                       const PictureArguments& arguments);

/// A panel for each layer; without layers, one panel of the scene.
std::vector<Panel> layer_panels(const Scene& scene, const std::vector<Layer>& layers);

}  // namespace wend::cli
