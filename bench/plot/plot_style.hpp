#pragma once

// What plots of all kinds look like. What is compared keeps its colour from plot to plot.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace wend {

enum class PlotKind { png, svg, pdf };

/// Colours as 0xRRGGBB.
struct PlotColours {
  std::uint32_t page;
  std::uint32_t ink;
  std::uint32_t grid;
  std::array<std::uint32_t, 22> names;  // of what is compared
};

/// Okabe and Ito's colours, which colour-blind eyes can tell apart, as far as they show on the page;
/// then darker ones. Shapes of points differ too.
inline constexpr PlotColours kLightPlot{
    0xFFFFFF, 0x3C4047, 0xE3E5E8, {0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9,
                                   0x000000, 0x882255, 0x999933, 0x332288, 0x8C564B, 0x117733,
                                   0xAA4499, 0x44AA99, 0x6A3D9A, 0x1F9FC9, 0xB33A00, 0x556B2F,
                                   0xC2185B, 0x3D5AFE, 0x00838F, 0x7F7F7F}};
inline constexpr PlotColours kDarkPlot{
    0x1B1E24, 0xD8DBE0, 0x343941, {0x56B4E9, 0xE69F00, 0x009E73, 0xCC79A7, 0xF0E442, 0xD55E00,
                                   0xFFFFFF, 0xB284BE, 0xBDBD5A, 0x8F8FFF, 0xC49C94, 0x7FD88A,
                                   0xFF9E9E, 0x9AE6DA, 0xD0B3F0, 0x8FD8F2, 0xFFB38A, 0xC5E07A,
                                   0xFF7FB0, 0x9FB4FF, 0x26C6DA, 0xA0A4AA}};
/// Dark grid lines and ink, for paper.
inline constexpr PlotColours kPrintPlot{0xFFFFFF, 0x000000, 0xC8C8C8, kLightPlot.names};

/// The colour number of each name that a plot compares. A planner or controller has its own colour in
/// every plot. A name that is unknown or repeated with other options takes the first free colour.
/// Colours repeat after the last one.
std::vector<std::size_t> plot_colours_of(std::span<const std::string> names);

}  // namespace wend
