#pragma once

// The text picture of a scene with a unit: the corners that a car stands on and the cells between
// them. See text_picture.hpp.

#include <string>

#include "wend/render/scene.hpp"
#include "wend/render/terminal/text_picture.hpp"

namespace wend {

std::string lattice_picture(const Scene& scene, const TextStyle& style);

/// Does it, without its legend, fit into that many columns and rows with the narrowest cells?
bool lattice_fits(const Scene& scene, int columns, int rows);

}  // namespace wend
