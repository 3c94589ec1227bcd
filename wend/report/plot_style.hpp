#pragma once

// What plots of all kinds look like.

#include <array>
#include <cstdint>

namespace wend {

enum class PlotKind { png, svg, pdf };

/// Colours as 0xRRGGBB.
struct PlotColours {
  std::uint32_t page;
  std::uint32_t ink;
  std::uint32_t grid;
  std::array<std::uint32_t, 7> names;  // of what is compared
};

/// Okabe and Ito's colours, which colour-blind eyes can tell apart, as far as they show on the page.
inline constexpr PlotColours kLightPlot{
    0xFFFFFF, 0x3C4047, 0xE3E5E8, {0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9, 0}};
inline constexpr PlotColours kDarkPlot{
    0x1B1E24,
    0xD8DBE0,
    0x343941,
    {0x56B4E9, 0xE69F00, 0x009E73, 0xCC79A7, 0xF0E442, 0xD55E00, 0xFFFFFF}};
/// Dark grid lines and ink, for paper.
inline constexpr PlotColours kPrintPlot{
    0xFFFFFF, 0x000000, 0xC8C8C8, {0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9, 0}};

}  // namespace wend
