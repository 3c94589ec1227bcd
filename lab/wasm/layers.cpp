// Lab::show(): the values of a layer.

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/wasm/answers.hpp"
#include "lab/wasm/json.hpp"
#include "lab/wasm/lab.hpp"
#include "wend/analysis/layer.hpp"

namespace wend::lab {

std::string Lab::show(std::string_view layer) {
  layer_ = std::string(layer);
  value_of_cell_.clear();
  values_ = {};
  if (layer == "expansion" || layer == "g" || layer == "h" || layer == "f") {
    show_search(layer);
  } else if (layer == "cost" || layer == "clearance") {
    if (const auto error = show_field(layer)) return *error;
  }
  find_range();
  return Json()
      .object()
      .field("least", static_cast<double>(values_.least))
      .field("greatest", static_cast<double>(values_.greatest))
      .end_object()
      .text();
}

void Lab::show_search(std::string_view layer) {
  values_.of_search = true;
  if (replay_.width() == 0) return;
  value_of_cell_.resize(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Replay::Known& known = replay_.known()[i];
    const std::uint32_t order = replay_.expansion()[i];
    value_of_cell_[i] = layer == "g"   ? known.g
                        : layer == "h" ? known.h
                        : layer == "f" ? known.f
                        : order > 0    ? static_cast<float>(order)
                                       : std::numeric_limits<float>::quiet_NaN();
  }
}

std::optional<std::string> Lab::show_field(std::string_view layer) {
  const auto view = session_.view();
  if (!view) return error_text(view.error());
  values_.of_search = false;
  Layer made{};
  if (layer == "clearance") {
    made = map_layer(LayerKind::clearance, view->space);
  } else {
    if (!goal_) return std::nullopt;
    const auto field = session_.cost_to_go(*view, {*goal_}, moves_);
    if (!field) return error_text(field.error());
    made = cost_to_go_layer(LayerKind::cost, view->space, *field->costs);
  }
  value_of_cell_.reserve(cells_.size());
  for (const double value : made.numbers.values()) {
    value_of_cell_.push_back(std::isfinite(value) ? static_cast<float>(value)
                                                  : std::numeric_limits<float>::quiet_NaN());
  }
  return std::nullopt;
}

void Lab::find_range() {
  float least = std::numeric_limits<float>::infinity();
  float greatest = -least;
  for (const float value : value_of_cell_) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  values_.least = least <= greatest ? least : 0;
  values_.greatest = least <= greatest ? greatest : 1;
}

}  // namespace wend::lab
