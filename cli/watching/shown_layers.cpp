#include "cli/watching/shown_layers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/output/terminal.hpp"
#include "wend/render/terminal/text_picture.hpp"

namespace wend::cli {
namespace {

constexpr int kColumnsAnArrow = 2;

const char* const kHelp =
    "Layers to show for every cell, separated by commas: as numbers or arrows on small maps, else "
    "as a picture. Search: expansion, generation (orders), g, heuristic, f, closed, frontier, "
    "parent. Costs to the goal: cost, policy. Map: occupied, clearance, terrain";

std::vector<std::string> layer_names() {
  std::vector<std::string> names;
  for (const auto& choice : choice_names(LayerKind{})) names.emplace_back(choice.name);
  return names;
}

LayerKind parse_layer(const std::string& text) {
  for (const auto& choice : choice_names(LayerKind{})) {
    if (choice.name == text) return choice.value;
  }
  refuse_value("--show", option_text::unknown_choice(text, layer_names()));
}

bool is_order(LayerKind kind) {
  return kind == LayerKind::expansion || kind == LayerKind::generation;
}

/// Are the numbers only yes or no? Then a picture marks the cells.
std::optional<CellRole> role_of(LayerKind kind) {
  if (kind == LayerKind::closed) return CellRole::expanded;
  if (kind == LayerKind::frontier) return CellRole::frontier;
  return std::nullopt;
}

BitGrid cells_that_are_one(const Grid<double>& numbers) {
  BitGrid cells(numbers.width(), numbers.height());
  for (int y = 0; y < numbers.height(); ++y) {
    for (int x = 0; x < numbers.width(); ++x) cells.set({x, y}, numbers[{x, y}] == 1);
  }
  return cells;
}

/// The layer's numbers, lengths in metres where the map has them.
Heatmap heatmap_of(const Layer& layer, const Frame& frame) {
  Heatmap heatmap{layer_title(layer.kind, frame), layer.numbers};
  if (!is_length(layer.kind) || !frame.metric) return heatmap;
  for (int y = 0; y < heatmap.values.height(); ++y) {
    for (double& value : heatmap.values.row(y)) value *= frame.resolution;
  }
  return heatmap;
}

int columns_a_cell_of(const Layer& layer, const Frame& frame) {
  if (layer.numbers.empty()) return kColumnsAnArrow;
  return columns_a_number(heatmap_of(layer, frame).values);
}

std::string grid_text(Scene scene, const Layer& layer, TerminalColours colours,
                      const Style& style) {
  if (layer.numbers.empty()) {
    scene.arrows = layer.arrows;
    return text_arrows(scene, colours, style);
  }
  scene.heatmap = heatmap_of(layer, scene.space.map().frame());
  return text_numbers(scene, colours, style);
}

/// One panel with g, h and f in every cell, as on a blackboard, where these three are shown and cells are large enough.
std::optional<Panel> board_panel(const Scene& scene, const std::vector<Layer>& layers) {
  constexpr int kMostCells = 32;  // across and down
  const Frame& frame = scene.space.map().frame();
  const auto heatmap = [&](LayerKind kind) -> std::optional<Heatmap> {
    const auto layer = std::ranges::find(layers, kind, &Layer::kind);
    if (layer == layers.end() || layer->numbers.empty()) return std::nullopt;
    return heatmap_of(*layer, frame);
  };
  const auto g = heatmap(LayerKind::g);
  const auto h = heatmap(LayerKind::heuristic);
  auto f = heatmap(LayerKind::f);
  if (!g || !h || !f || layers.size() != 3) return std::nullopt;
  if (std::max(scene.space.width(), scene.space.height()) > kMostCells) return std::nullopt;
  const std::string unit = frame.metric ? " in m" : "";
  Panel panel{"In every cell, from the top: g, h and f" + unit, scene, {}};
  panel.scene.numbers_above = {g->values, h->values};
  panel.scene.heatmap = std::move(f);
  return panel;
}

}  // namespace

std::string layer_title(LayerKind kind, const Frame& frame) {
  return std::string(title_of(kind)) +
         (is_length(kind) ? (frame.metric ? " in m" : " in cells") : "");
}

void ShownLayers::add_to(Parser& app) {
  const auto add = [this](const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      const LayerKind kind = parse_layer(name);
      if (std::find(kinds_.begin(), kinds_.end(), kind) == kinds_.end()) kinds_.push_back(kind);
    }
  };
  app.add_list("--show", add, wrapped(kHelp)).separated_by_commas().type_name(kLayerType);
}

void ShownLayers::add_counting_to(Parser& app) {
  add_choice<bool>(app, "--count-from", from_zero_, {{"0", true}, {"1", false}},
                   "Number of the first cell in the layers expansion and generation (default 1); "
                   "with 0, text and JSON have -1 for cells that were not reached")
      .group("Watching the search");
}

bool ShownLayers::any_order() const { return std::ranges::any_of(kinds_, is_order); }

bool ShownLayers::counts(const Layer& layer) const { return from_zero_ && is_order(layer.kind); }

Layer ShownLayers::counted(Layer layer) const {
  if (!counts(layer)) return layer;
  for (int y = 0; y < layer.numbers.height(); ++y) {
    for (double& number : layer.numbers.row(y)) number -= 1;
  }
  return layer;
}

Layer ShownLayers::as_numbers(Layer layer) const {
  if (!counts(layer)) return layer;
  for (int y = 0; y < layer.numbers.height(); ++y) {
    for (double& number : layer.numbers.row(y)) number = std::isnan(number) ? -1 : number;
  }
  return layer;
}

bool ShownLayers::any_from(LayerSource source) const {
  return std::any_of(kinds_.begin(), kinds_.end(),
                     [source](LayerKind kind) { return source_of(kind) == source; });
}

Scene with_layer(Scene scene, const Layer& layer) {
  if (layer.kind == LayerKind::occupied) return scene;
  if (const auto role = role_of(layer.kind)) {
    scene.marked.push_back({*role, cells_that_are_one(layer.numbers)});
  } else if (layer.numbers.empty()) {
    scene.arrows = layer.arrows;
  } else {
    scene.heatmap = heatmap_of(layer, scene.space.map().frame());
    if (!layer.motions.empty()) {
      scene.heatmap->range = HeatRange{1, static_cast<double>(layer.motions.size())};
      scene.motions = layer.motions;
    }
  }
  return scene;
}

std::optional<std::string> layer_grid(const Scene& scene, const Layer& layer, const Screen& screen,
                                      StyleName style) {
  const Frame& frame = scene.space.map().frame();
  const int columns_a_cell = columns_a_cell_of(layer, frame);
  const bool too_wide = scene.space.width() * columns_a_cell > screen.columns;
  if (!is_small(scene.space.map(), screen) || (screen.is_terminal && too_wide)) return std::nullopt;
  const std::string grid = grid_text(scene, layer, screen.terminal.colours, style_of(style));
  return layer_title(layer.kind, frame) + "\n" +
         (screen.is_terminal ? grid : folded_grid(grid, columns_a_cell, screen.columns));
}

std::string layer_text(const Scene& scene, const Layer& layer, const Screen& screen,
                       const PictureArguments& arguments) {
  if (const auto grid = layer_grid(scene, layer, screen, arguments.style)) return *grid + "\n";
  const std::string drawn = large_picture(with_layer(scene, layer), screen, arguments);
  if (drawn.empty()) return {};
  const bool no_room = layer.numbers.empty() && !has_pixels(screen.terminal);
  return layer_title(layer.kind, scene.space.map().frame()) +
         (no_room ? " (too large for arrows here; -o FILE.png draws them)\n" : "\n") + drawn + "\n";
}

std::vector<Panel> layer_panels(const Scene& scene, const std::vector<Layer>& layers) {
  if (auto board = board_panel(scene, layers)) return {*std::move(board)};
  std::vector<Panel> panels;
  panels.reserve(layers.size());
  for (const Layer& layer : layers) {
    panels.push_back(
        {layer_title(layer.kind, scene.space.map().frame()), with_layer(scene, layer), {}});
  }
  if (panels.empty()) panels.push_back({{}, scene, {}});
  return panels;
}

}  // namespace wend::cli
