#pragma once

// Searches and simulated drives, picture by picture: for the terminal and for GIFs.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/output/picture.hpp"
#include "cli/output/terminal.hpp"
#include "wend/analysis/search_recorder.hpp"
#include "wend/base/expected.hpp"
#include "wend/control/simulation.hpp"
#include "wend/render/animation/film_canvas.hpp"
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

/// Pictures one after the other.
struct Film {
  std::size_t frames = 1;
  std::function<std::vector<FilmPanel>(std::size_t frame)> panels_at;
  int hundredths = 5;  // how long a frame is shown
  int last_hundredths = 250;
  int width = 800;  // pixels, at most
  int height = 640;
};

/// A GIF with one legend for all frames.
Expected<std::string, Error> gif_of_frames(const Film& film, const Style& style);

/// A search of one planner.
struct FilmedSearch {
  std::string name;
  Scene outcome;                   // the last picture
  const SearchRecorder* recorder;  // must live as long as the search is filmed
};

/// Searches beside each other as a GIF, expansion by expansion; of one over continuous poses, the tree of its motions
/// grows. Each has its name and the number of its expansions. At least one search.
Expected<std::string, Error> gif_of(std::span<const FilmedSearch> searches,
                                    std::optional<double> speed, const Style& style);

/// A GIF of one picture, where there was no search.
Expected<std::string, Error> gif_of(const std::string& title, const Scene& scene,
                                    const Style& style);

/// A GIF: the scene with the robot on its way, behind it what it drove, and the time. `speed` is how many times
/// as fast as the robot; without one the film takes a few seconds.
Expected<std::string, Error> gif_of_drive(const std::string& controller, const Scene& scene,
                                          const Drive& drive, std::optional<double> speed,
                                          const Style& style);

}  // namespace wend::cli
