#include "wend/render/picture/map_image.hpp"

#include <algorithm>
#include <cmath>
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

/// Rows of cells come in, from the top; rows of pixels come out.
class RowWriter {
 public:
  explicit RowWriter(Grid<std::uint32_t>& image)
      : image_(image), sums_(static_cast<std::size_t>(image.width())) {}

  void add(const std::vector<Sum>& cells, int index, int count) {
    for_pixels_of(index, count, image_.height(), [&](int row, double area) {
      if (row != row_) finish_row();
      row_ = row;
      for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i].add(cells[i], area);
    });
  }

  void finish_row() {
    std::transform(sums_.begin(), sums_.end(), image_.row(row_).begin(),
                   [](const Sum& sum) { return sum.pixel(); });
    std::fill(sums_.begin(), sums_.end(), Sum{});
  }

 private:
  Grid<std::uint32_t>& image_;
  int row_ = 0;
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

Grid<std::uint32_t> map_image(const CellPaints& paints, int width, int height, bool y_up) {
  Grid<std::uint32_t> image(width, height);
  RowWriter writer(image);
  std::vector<Sum> row(static_cast<std::size_t>(width));
  for (int n = 0; n < paints.height(); ++n) {
    squeeze_row(paints, y_up ? paints.height() - 1 - n : n, row);
    writer.add(row, n, paints.height());
  }
  writer.finish_row();
  return image;
}

}  // namespace wend
