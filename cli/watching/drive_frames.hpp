#pragma once

// A drive as it went, as a film.

#include <optional>
#include <string>

#include "wend/base/expected.hpp"
#include "wend/control/simulation.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend::cli {

/// A GIF: the scene with the robot on its way, and behind it what it drove. `speed` is how many times
/// as fast as the robot; without one the film takes a few seconds.
Expected<std::string, RenderError> gif_of_drive(const Scene& scene, const Drive& drive,
                                                std::optional<double> speed, const Style& style);

}  // namespace wend::cli
