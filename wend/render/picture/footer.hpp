#pragma once

// The footer of a picture: a scale bar on the left, and on the right the legend, on as many lines
// as it needs.

#include <optional>
#include <vector>

#include "wend/render/legend.hpp"
#include "wend/render/picture/canvas.hpp"
#include "wend/render/picture/layout.hpp"
#include "wend/render/style.hpp"

namespace wend {

class Footer {
 public:
  static constexpr int kLine = 34;  // pixels from one line to the next

  /// For that many pixels of width. The scale bar is left out where it has none.
  Footer(std::vector<LegendItem> legend, std::optional<ScaleBar> bar, double width);

  /// At least one.
  int lines() const { return static_cast<int>(rows_.size()); }

  /// `left` is the left end of the middle of the first line.
  void draw(cairo_t* context, Point left, const Style& style) const;

 private:
  /// Distributes the legend over rows.
  void arrange(cairo_t* context, std::vector<LegendItem> legend);

  std::optional<ScaleBar> bar_;
  std::vector<std::vector<LegendItem>> rows_;
  double width_;
};

}  // namespace wend
