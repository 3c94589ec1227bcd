#include "cli/watching/exploration_film.hpp"

#include <fmt/format.h>

#include <utility>

#include "cli/watching/films.hpp"

namespace wend::cli {
namespace {

constexpr std::size_t kMostSteps = 160;
constexpr int kFilmWidth = 800;  // pixels at most
constexpr int kFilmHeight = 640;
constexpr int kStepHundredths = 100 / kFramesPerSecond;
constexpr int kArrivalHundredths = 250;

std::vector<Point> centres_of(std::span<const Cell> cells) {
  std::vector<Point> points;
  for (const Cell cell : cells) points.push_back(centre_of(cell));
  return points;
}

std::string steps_in_words(std::size_t steps) {
  return fmt::format("{} {}", steps, steps == 1 ? "step" : "steps");
}

}  // namespace

Scene scene_now(const Explorer& explorer) {
  Scene scene = scene_between(explorer.believed(), explorer.driven().front(), explorer.goal());
  if (explorer.ahead().size() > 1) {
    scene.lines.push_back({LineRole::planned, centres_of(explorer.ahead())});
  }
  scene.lines.push_back({LineRole::driven, centres_of(explorer.driven())});
  scene.robot = pose_at(explorer.cell());
  return scene;
}

void ExplorationFilm::take(const Explorer& explorer) {
  if (steps_++ % stride_ != 0) return;
  frames_.push_back(scene_now(explorer));
  if (frames_.size() < kMostSteps) return;
  std::vector<Scene> kept;
  for (std::size_t i = 0; i < frames_.size(); i += 2) kept.push_back(std::move(frames_[i]));
  frames_ = std::move(kept);
  stride_ *= 2;
}

Expected<std::string, Error> ExplorationFilm::gif(const std::string& planner, const Scene& last,
                                                  const Style& style) const {
  const auto panels_at = [&](std::size_t frame) {
    if (frame == frames_.size()) {
      return std::vector<FilmPanel>{{planner, steps_in_words(steps_), last}};
    }
    return std::vector<FilmPanel>{{planner, steps_in_words(1 + frame * stride_), frames_[frame]}};
  };
  return gif_of_frames({.frames = frames_.size() + 1,
                        .panels_at = panels_at,
                        .hundredths = kStepHundredths,
                        .last_hundredths = kArrivalHundredths,
                        .width = kFilmWidth,
                        .height = kFilmHeight},
                       style);
}

}  // namespace wend::cli
