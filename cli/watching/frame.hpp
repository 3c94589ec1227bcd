#pragma once

// A frame: a search as it stands, with layers of it, fitted to the terminal so that nothing
// scrolls. Small maps are text, side by side where there is room; what is too high for the terminal
// is drawn smaller, as a picture.

#include <functional>
#include <string>
#include <vector>

#include "cli/output/picture.hpp"
#include "cli/output/terminal.hpp"
#include "cli/watching/shown_layers.hpp"

namespace wend::cli {

/// Text of at most `rows` lines, shown beside the map, or below it if it does not fit.
using BesideMap = std::function<std::string(int rows)>;

/// `rows_below` rows of the terminal stay free for what is written below. Without a
/// terminal there is room for everything.
std::string frame_text(const Scene& scene, const std::vector<Layer>& layers, const Screen& screen,
                       StyleName style, int rows_below, const BesideMap& beside = {});

}  // namespace wend::cli
