#include "wend/render/map_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace wend {
namespace {

/// Colours times weights times areas, and what to divide them by.
struct Sum {
  double red = 0;
  double green = 0;
  double blue = 0;
  double weight = 0;

  void add(const Paint& paint, double area) {
    const double share = area * paint.weight;
    red += share * paint.colour.red;
    green += share * paint.colour.green;
    blue += share * paint.colour.blue;
    weight += share;
  }

  void add(const Sum& other, double area) {
    red += area * other.red;
    green += area * other.green;
    blue += area * other.blue;
    weight += area * other.weight;
  }

  std::uint32_t pixel() const {
    const auto byte = [this](double sum) {
      return static_cast<std::uint32_t>(std::lround(std::clamp(sum / weight, 0.0, 1.0) * 255));
    };
    return byte(red) << 16U | byte(green) << 8U | byte(blue);
  }
};

/// Calls visit(pixel, overlap) for the pixels that cell `index` of `cells` covers when these are
/// spread over `pixels` pixels.
template <class Visit>
void for_pixels_of(int index, int cells, int pixels, Visit&& visit) {
  const double begin = static_cast<double>(index) * pixels / cells;
  const double end = static_cast<double>(index + 1) * pixels / cells;
  for (int pixel = static_cast<int>(begin); pixel < pixels && pixel < end; ++pixel) {
    visit(pixel, std::min<double>(end, pixel + 1) - std::max<double>(begin, pixel));
  }
}

class RowWriter {
 public:
  RowWriter(cairo_surface_t* image, int width, int height)
      : bytes_(cairo_image_surface_get_data(image)),
        stride_(static_cast<std::size_t>(cairo_image_surface_get_stride(image))),
        height_(height),
        pixels_(static_cast<std::size_t>(width)),
        sums_(static_cast<std::size_t>(width)) {}

  /// Rows of cells come in order, from the top.
  void add(const std::vector<Sum>& cells, int index, int count) {
    for_pixels_of(index, count, height_, [&](int row, double area) {
      if (row != row_) finish_row();
      row_ = row;
      for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i].add(cells[i], area);
    });
  }

  void finish_row() {
    std::transform(sums_.begin(), sums_.end(), pixels_.begin(),
                   [](const Sum& sum) { return sum.pixel(); });
    std::memcpy(bytes_ + static_cast<std::size_t>(row_) * stride_, pixels_.data(),
                pixels_.size() * sizeof(std::uint32_t));
    std::fill(sums_.begin(), sums_.end(), Sum{});
  }

 private:
  unsigned char* bytes_;
  std::size_t stride_;
  int height_;
  int row_ = 0;
  std::vector<std::uint32_t> pixels_;
  std::vector<Sum> sums_;
};

void squeeze_row(const CellPaints& paints, int y, std::vector<Sum>& sums) {
  std::fill(sums.begin(), sums.end(), Sum{});
  const int pixels = static_cast<int>(sums.size());
  for (int x = 0; x < paints.width(); ++x) {
    const Paint paint = paints[{x, y}];
    for_pixels_of(x, paints.width(), pixels, [&](int pixel, double length) {
      sums[static_cast<std::size_t>(pixel)].add(paint, length);
    });
  }
}

}  // namespace

CairoSurface map_image(const CellPaints& paints, int width, int height, bool y_up) {
  CairoSurface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  if (cairo_surface_status(image.get()) != CAIRO_STATUS_SUCCESS) return image;
  cairo_surface_flush(image.get());
  RowWriter writer(image.get(), width, height);
  std::vector<Sum> row(static_cast<std::size_t>(width));
  for (int n = 0; n < paints.height(); ++n) {
    squeeze_row(paints, y_up ? paints.height() - 1 - n : n, row);
    writer.add(row, n, paints.height());
  }
  writer.finish_row();
  cairo_surface_mark_dirty(image.get());
  return image;
}

}  // namespace wend
