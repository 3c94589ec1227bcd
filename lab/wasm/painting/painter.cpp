#include "lab/wasm/painting/painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lab/wasm/cells.hpp"

namespace wend::lab {
namespace {

constexpr double kGridFrom = 9;  // pixels a cell: from there on, lines part the cells

/// `share` of 256 of the second colour, the rest of the first.
std::uint32_t mixed(std::uint32_t first, std::uint32_t second, unsigned share) {
  constexpr std::uint32_t kRedBlue = 0x00FF00FF;
  const std::uint32_t rest = 256 - share;
  const std::uint32_t red_blue = ((first & kRedBlue) * rest + (second & kRedBlue) * share) >> 8U;
  const std::uint32_t green =
      (((first >> 8U) & 0xFFU) * rest + ((second >> 8U) & 0xFFU) * share) >> 8U;
  return (red_blue & kRedBlue) | ((green & 0xFFU) << 8U) | 0xFF000000U;
}

std::uint32_t ground_colour(std::uint8_t cell, const Palette& palette) {
  if (cell == kUnknownCell) return palette.unknown;
  if (cell <= 1) return palette.free;
  // From the least to ten times and more.
  const unsigned share = std::min(256U, (cell - 1U) * 256U / 9U);
  return mixed(palette.rough_least, palette.rough_most, share);
}

class Painter {
 public:
  Painter(const Picture& picture, const View& view, const Palette& palette)
      : picture_(picture),
        view_(view),
        palette_(palette),
        level_(picture.pyramid.level_for(view.cells)) {
    const bool blocks = level_ >= 0;
    columns_ = blocks ? picture.pyramid.level(level_).width : picture.width;
    rows_ = blocks ? picture.pyramid.level(level_).height : picture.height;
    side_ = blocks ? 2 << level_ : 1;
    if (picture.step > 0) current_ = picture.replay.expanded_at(picture.step);
    for (int x = 0; x < view.width; ++x) across_.push_back(column(x));
  }

  void row(int y, std::span<std::uint32_t> pixels) const {
    const int at = row_of(y);
    if (at < 0) {
      std::ranges::fill(pixels, palette_.page);
      return;
    }
    const bool line = begins_cell(y);
    if (!has_lines() && is_plain()) return plain_row(at, pixels);
    std::uint32_t last = palette_.page;
    for (std::size_t x = 0; x < pixels.size(); ++x) {
      const int column = across_[x];
      const bool begins = x == 0 || across_[x - 1] != column;
      if (begins) last = column < 0 ? palette_.page : colour(column, at);
      const bool drawn = column >= 0 && (line || (begins && has_lines()));
      pixels[x] = drawn ? mixed(last, palette_.grid, kLine) : last;
    }
  }

  /// Does a row of pixels look like the one above it?
  bool repeats(int y) const {
    return y > 0 && row_of(y) == row_of(y - 1) && begins_cell(y) == begins_cell(y - 1);
  }

 private:
  static constexpr unsigned kLine = 56;          // share of 256
  static constexpr unsigned kRoleOnRough = 150;  // the same

  bool begins_cell(int y) const { return has_lines() && row_of(y) != row_of(y - 1); }

  /// What the search did, on cells where the robot fits wherever it is free: most pictures, which are to be fast.
  bool is_plain() const {
    return picture_.values.of_cells.empty() && picture_.replay.width() != 0 &&
           (level_ >= 0 || picture_.fits.empty());
  }

  void plain_row(int row, std::span<std::uint32_t> pixels) const {
    const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    const Level* const level = level_ >= 0 ? &picture_.pyramid.level(level_) : nullptr;
    const Replay& replay = picture_.replay;
    const std::uint8_t* const ground =
        (level ? level->ground.data() : picture_.cells.data()) + first;
    const std::uint8_t* const walls = level ? level->obstacles.data() + first : nullptr;
    const std::uint32_t* const expansion =
        (level ? level->expansion : replay.expansion()).data() + first;
    const std::uint32_t* const generation =
        (level ? level->generation : replay.generation()).data() + first;
    const Palette palette = palette_;
    const std::uint32_t step = picture_.step;
    for (std::size_t x = 0; x < pixels.size(); ++x) {
      const int column = across_[x];
      if (column < 0) {
        pixels[x] = palette.page;
        continue;
      }
      const std::uint8_t cell = ground[column];
      if (walls == nullptr && cell == kObstacle) {
        pixels[x] = palette.obstacle;
        continue;
      }
      // 0 is never: as an unsigned number minus 1 it is the largest.
      const bool expanded = expansion[column] - 1 < step;
      const bool reached = expanded || generation[column] - 1 < step;
      std::uint32_t colour = expanded ? palette.expanded : palette.frontier;
      if (!reached) {
        colour = ground_colour(cell, palette);
      } else if (cell > 1 && cell != kUnknownCell) {
        colour = mixed(ground_colour(cell, palette), colour, kRoleOnRough);
      }
      if (walls != nullptr) {
        colour = with_walls(colour, walls[column]);
      } else if (first + static_cast<std::size_t>(column) == current_) {
        colour = palette.current;
      }
      pixels[x] = colour;
    }
  }

  /// The colour of a block with obstacles in it. A thin wall must not fade away: one cell counts like nearly half of
  /// the block.
  std::uint32_t with_walls(std::uint32_t colour, unsigned walls) const {
    return walls == 0 ? colour : mixed(colour, palette_.obstacle, std::min(256U, 110U + walls));
  }

  bool has_lines() const { return view_.cells * kGridFrom <= 1; }

  int column(int x) const {
    const double at = view_.left + (x + 0.5) * view_.cells;
    return at < 0 || at >= picture_.width ? -1
                                          : std::min(static_cast<int>(at) / side_, columns_ - 1);
  }
  int row_of(int y) const {
    const double at = view_.top + (y + 0.5) * view_.cells;
    if (at < 0 || at >= picture_.height) return -1;
    const int drawn = static_cast<int>(at);
    return std::min((view_.y_up ? picture_.height - 1 - drawn : drawn) / side_, rows_ - 1);
  }

  std::uint32_t colour(int column, int row) const {
    const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                              static_cast<std::size_t>(column);
    return level_ < 0 ? cell_colour(index) : block_colour(index, column, row);
  }

  std::uint32_t cell_colour(std::size_t index) const {
    const std::uint8_t cell = picture_.cells[index];
    if (cell == kObstacle) return palette_.obstacle;
    const bool fits = picture_.fits.empty() || picture_.fits[index] != 0;
    std::uint32_t ground = ground_colour(cell, palette_);
    if (!fits && cell != kUnknownCell) ground = palette_.too_close;
    const bool known = picture_.replay.width() != 0;
    return over(ground, cell, index, known ? picture_.replay.expansion()[index] : 0,
                known ? picture_.replay.generation()[index] : 0);
  }

  std::uint32_t block_colour(std::size_t index, int column, int row) const {
    const Level& level = picture_.pyramid.level(level_);
    const std::size_t first = static_cast<std::size_t>(std::min(row * side_, picture_.height - 1)) *
                                  static_cast<std::size_t>(picture_.width) +
                              static_cast<std::size_t>(column * side_);
    const std::uint8_t cell = level.ground[index];
    const bool known = !level.expansion.empty();
    const std::uint32_t ground =
        over(ground_colour(cell, palette_), cell, first, known ? level.expansion[index] : 0,
             known ? level.generation[index] : 0);
    return with_walls(ground, level.obstacles[index]);
  }

  /// The ground with what the search did there, or a value.
  std::uint32_t over(std::uint32_t ground, std::uint8_t cell, std::size_t index,
                     std::uint32_t expansion, std::uint32_t generation) const {
    const bool expanded = expansion != 0 && expansion <= picture_.step;
    const bool reached = generation != 0 && generation <= picture_.step;
    if (level_ < 0 && picture_.step > 0 && index == current_) return palette_.current;
    const Values& values = picture_.values;
    if (!values.of_cells.empty() && (!values.of_search || reached)) {
      const float value = values.of_cells[index];
      if (value == value) return palette_.ramp[ramp_index(value)];
    }
    if (!reached && !expanded) return ground;
    const std::uint32_t role = expanded ? palette_.expanded : palette_.frontier;
    return cell > 1 && cell != kUnknownCell ? mixed(ground, role, kRoleOnRough) : role;
  }

  std::size_t ramp_index(float value) const {
    const Values& values = picture_.values;
    const float range = values.greatest - values.least;
    const float share = range > 0 ? (value - values.least) / range : 0;
    return static_cast<std::size_t>(std::clamp(share, 0.0F, 1.0F) * 255.0F);
  }

  const Picture& picture_;
  const View& view_;
  const Palette& palette_;
  int level_;  // of the pyramid; -1: the cells themselves
  int columns_ = 0;
  int rows_ = 0;
  int side_ = 1;  // cells
  std::size_t current_ = ~std::size_t{0};
  std::vector<int> across_;  // the column of every pixel of a row; -1: beside the map
};

}  // namespace

void paint(const Picture& picture, const View& view, const Palette& palette,
           std::span<std::uint32_t> pixels) {
  const Painter painter(picture, view, palette);
  const auto width = static_cast<std::size_t>(view.width);
  for (int y = 0; y < view.height; ++y) {
    const std::size_t begin = static_cast<std::size_t>(y) * width;
    if (painter.repeats(y)) {
      std::ranges::copy(pixels.subspan(begin - width, width),
                        pixels.begin() + static_cast<std::ptrdiff_t>(begin));
    } else {
      painter.row(y, pixels.subspan(begin, width));
    }
  }
}

}  // namespace wend::lab
