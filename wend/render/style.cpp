#include "wend/render/style.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace wend {
namespace {

constexpr double kInkInStripes = 0.6;  // where there are greys alone
constexpr double kRoughShare = 0.35;   // of the colour of a cell that has a role too

/// Walls are lighter than the floor: that keeps thin ones visible on a dark page.
Style dark() {
  return {.free = colour_from(0x23272F),
          .occupied = colour_from(0xC2C8D2),
          .yard_occupied = colour_from(0xE0484F),
          .unknown = colour_from(0x4A505B),
          .too_close = colour_from(0x40334F),
          .slightly_rough = colour_from(0x705408),
          .very_rough = colour_from(0xE6A817),
          .grid_lines = colour_from(0xC2C8D2),
          .expanded = colour_from(0x1D4F73),
          .frontier = colour_from(0x3B86C8),
          .current = colour_from(0xF25FB0),
          .start_component = colour_from(0x0B6E78),
          .goal_component = colour_from(0x80421A),
          .heat_colours = {colour_from(0x2B2A55), colour_from(0x4F3A86), colour_from(0x86489A),
                           colour_from(0xC0608F), colour_from(0xE08C7A)},
          .lines = {.planned = colour_from(0xF0585B),
                    .smoothed = colour_from(0x7FE39A),
                    .driven = colour_from(0x4F95FF)},
          .arrows = colour_from(0xE4E7EC),
          .path = colour_from(0x62BDF5),
          .reverse = colour_from(0xF4F6F9),
          .start = colour_from(0x2FD6A3),
          .goal = colour_from(0xFF8B45),
          .narrowest = colour_from(0xFFF06A),
          .halo = colour_from(0x14161A),
          .page = colour_from(0x191C22),
          .ink = colour_from(0xD5D9E0)};
}

/// Greys alone: every role has a lightness of its own, and the marks their shapes.
Style print() {
  constexpr Colour kBlack = colour_from(0x101010);
  return {.free = colour_from(0xFFFFFF),
          .occupied = colour_from(0x2E2E2E),
          .yard_occupied = colour_from(0x2E2E2E),
          .unknown = colour_from(0xACACAC),
          .too_close = colour_from(0xEBEBEB),
          .slightly_rough = colour_from(0xF4F4F4),
          .very_rough = colour_from(0x8C8C8C),
          .stripes_all_rough = true,
          .grid_lines = kBlack,
          .expanded = colour_from(0xC8C8C8),
          .frontier = colour_from(0x858585),
          .current = colour_from(0x606060),
          .start_component = colour_from(0xD8D8D8),
          .goal_component = colour_from(0x939393),
          .heat_colours = {colour_from(0xE8E8E8), colour_from(0xC0C0C0), colour_from(0x989898),
                           colour_from(0x747474), colour_from(0x525252)},
          .lines = {.planned = colour_from(0x4A4A4A),
                    .smoothed = colour_from(0x808080),
                    .driven = kBlack},
          .arrows = kBlack,
          .path = kBlack,
          .reverse = kBlack,
          .start = kBlack,
          .goal = kBlack,
          .narrowest = kBlack,
          .halo = colour_from(0xFFFFFF),
          .page = colour_from(0xFFFFFF),
          .ink = kBlack};
}

// A wall one cell wide must not fade away where eight cells share a pixel.
constexpr double kObstacleWeight = 3;
constexpr double kRoleWeight = 2;
constexpr double kFrontierWeight = 4;  // a thin rim

// The one cell that is expanded now shows among hundreds.
constexpr double kCurrentWeight = 40;

double weight_of(CellRole role) {
  if (role == CellRole::frontier) return kFrontierWeight;
  return role == CellRole::current ? kCurrentWeight : kRoleWeight;
}

// Only an assertion asks.
[[maybe_unused]] bool fits(const Scene& scene) {
  const auto as_large = [&](const auto& layer) {
    return layer.width() == scene.space.width() && layer.height() == scene.space.height();
  };
  return std::ranges::all_of(scene.marked, as_large, &MarkedCells::cells) &&
         (!scene.heatmap || as_large(scene.heatmap->values)) &&
         (!scene.arrows || as_large(*scene.arrows));
}

}  // namespace

std::uint32_t rgb_of(const Colour& colour) {
  const auto byte = [](double part) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255));
  };
  return byte(colour.red) << 16U | byte(colour.green) << 8U | byte(colour.blue);
}

Colour readable_on(const Colour& colour) {
  const double luma = 0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue;
  return colour_from(luma > 0.5 ? 0x000000 : 0xFFFFFF);
}

double roughness(double multiplier) { return std::min(1.0, std::log10(multiplier)); }

Colour Style::rough(double multiplier) const {
  return mixed(slightly_rough, very_rough, roughness(multiplier));
}

Colour Style::stripe(double multiplier) const {
  return stripes_all_rough ? mixed(rough(multiplier), ink, kInkInStripes) : rough(multiplier);
}

Colour Style::of(CellRole role, double multiplier) const {
  return mixed(of(role), rough(multiplier), kRoughShare);
}

Colour Style::heat(double share) const {
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(heat_colours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), heat_colours.size() - 2);
  return mixed(heat_colours[below], heat_colours[below + 1], at - static_cast<double>(below));
}

Colour Style::of(CellRole role) const {
  static constexpr std::array<Colour Style::*, kCellRoles> kColours{
      &Style::expanded, &Style::frontier, &Style::current, &Style::start_component,
      &Style::goal_component};
  return this->*kColours[static_cast<std::size_t>(role)];
}

Colour Style::of(LineRole role) const {
  const std::array<Colour, kLineRoles> colours{lines.planned, lines.smoothed, lines.driven, path};
  return colours[static_cast<std::size_t>(role)];
}

Style style_of(StyleName name) {
  return name == StyleName::dark ? dark() : name == StyleName::print ? print() : Style{};
}

Style style_for(const Scene& scene, const Style& style) {
  Style shown = style;
  if (scene.places.on_corners() && !scene.heatmap) shown.occupied = style.yard_occupied;
  return shown;
}

/// The colours of rough ground would be taken for heat.
bool is_rough(const Scene& scene, Cell cell) {
  const GridMap& map = scene.space.map();
  return !scene.heatmap && map.state(cell) != CellState::occupied && map.terrain(cell) != 1;
}

CellPaints::CellPaints(const Scene& scene, const Style& style) : scene_(scene), style_(style) {
  assert(fits(scene));
  if (scene.heatmap) range_ = range_of(*scene.heatmap);
}

std::optional<Colour> CellPaints::heat(Cell cell) const {
  const auto& heatmap = scene_.heatmap;
  if (!heatmap || !range_ || !scene_.motions.empty()) return std::nullopt;
  if (scene_.space.map().state(cell) == CellState::occupied) return std::nullopt;
  const double value = heatmap->values[cell];
  if (!std::isfinite(value)) return std::nullopt;
  return style_.heat(range_->share(value));
}

Paint CellPaints::operator[](Cell cell) const {
  const FreeSpace& space = scene_.space;
  const CellState state = space.map().state(cell);
  if (state == CellState::occupied) return {style_.occupied, kObstacleWeight};
  if (const auto role = role_of(scene_, cell)) {
    return {is_rough(scene_, cell) ? style_.of(*role, space.map().terrain(cell)) : style_.of(*role),
            weight_of(*role)};
  }
  if (const auto colour = heat(cell)) return {*colour};
  if (state == CellState::unknown) return {style_.unknown};
  if (!standable(scene_)[cell]) return {style_.too_close};
  if (!is_rough(scene_, cell)) return {style_.free};
  return {style_.rough(space.map().terrain(cell))};
}

std::optional<Stripes> CellPaints::stripes(Cell cell) const {
  if (!is_rough(scene_, cell)) return std::nullopt;
  const auto role = role_of(scene_, cell);
  if (!role && !style_.stripes_all_rough) return std::nullopt;
  const double multiplier = scene_.space.map().terrain(cell);
  return Stripes{role ? style_.of(*role) : style_.rough(multiplier), style_.stripe(multiplier)};
}

}  // namespace wend
