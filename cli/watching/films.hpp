#pragma once

// Searches and simulated drives, picture by picture: for the terminal and for GIFs.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/output/picture.hpp"
#include "cli/output/terminal.hpp"
#include "wend/analysis/search_recorder.hpp"
#include "wend/base/expected.hpp"
#include "wend/control/simulation.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend::cli {

inline constexpr int kFramesPerSecond = 20;

/// The scene with what was expanded, what was open and what was being expanded.
Scene with_snapshot(Scene scene, const SearchSnapshot& snapshot);

/// For each frame, the number of expansions that it shows, of a search of `expansions`. `speed` is
/// expansions a second; without one the film takes a few seconds. At most `most` frames (2 or
/// more), at the cost of the speed.
std::vector<std::size_t> frame_times(std::size_t expansions, std::optional<double> speed,
                                     std::size_t most);

/// Plays a search on the terminal; `outcome` is the last picture. Ctrl-C ends it.
void play(const Scene& outcome, const SearchRecorder& recorder, const Screen& screen,
          const PictureArguments& pictures, std::optional<double> speed);

/// The scene as a picture after that many expansions, with what the search had driven by then if it is one over
/// continuous poses, else as with_snapshot().
Scene scene_after(const Scene& base, const SearchRecorder& recorder, std::size_t expansions);

/// The same as a GIF; of a search over continuous poses, the tree of its motions grows.
Expected<std::string, Error> gif_of(const Scene& outcome, const SearchRecorder& recorder,
                                    std::optional<double> speed, const Style& style);

/// A GIF of one picture, where there was no search.
Expected<std::string, Error> gif_of(const Scene& scene, const Style& style);

/// A GIF: the scene with the robot on its way, and behind it what it drove. `speed` is how many times
/// as fast as the robot; without one the film takes a few seconds.
Expected<std::string, Error> gif_of_drive(const Scene& scene, const Drive& drive,
                                          std::optional<double> speed, const Style& style);

}  // namespace wend::cli
