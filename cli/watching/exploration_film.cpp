#include "cli/watching/exploration_film.hpp"

#include <utility>

#include "cli/watching/films.hpp"
#include "wend/render/animation/gif.hpp"
#include "wend/render/picture/drawing.hpp"

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

Expected<std::string, Error> ExplorationFilm::gif(const Scene& last, const Style& style) const {
  const auto pixels_of = [&](const Scene& scene) {
    return draw_pixels(scene, kFilmWidth, kFilmHeight, style);
  };
  const Grid<std::uint32_t> end = pixels_of(last);
  std::vector<Grid<std::uint32_t>> samples{end};
  if (!frames_.empty()) {
    samples.push_back(pixels_of(frames_.front()));
    samples.push_back(pixels_of(frames_[frames_.size() / 2]));
  }
  GifAnimation animation(end.width(), end.height(), palette_of(samples));
  for (const Scene& frame : frames_) animation.add(pixels_of(frame), kStepHundredths);
  animation.add(end, kArrivalHundredths);
  return animation.finish();
}

}  // namespace wend::cli
