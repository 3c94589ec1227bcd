#pragma once

// A scene on standard output: a small map as text with a character a cell, a large one as a
// picture.

#include <CLI/App.hpp>
#include <string>

#include "terminal.hpp"
#include "wend/render/scene.hpp"

namespace wend::cli {

/// When to show a large map. Small ones always are.
enum class PictureWhen { automatic, always, never };

/// --picture auto|always|never
void add_picture(CLI::App& app, PictureWhen& when);

/// Is the map small enough for one character a cell?
bool is_small(const GridMap& map, const Screen& screen);

/// The map as text or as a picture; empty where it is not to be shown.
std::string picture(const Scene& scene, const Screen& screen, PictureWhen when);

}  // namespace wend::cli
