#include "cli/watching/drive_frames.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "wend/render/animation/gif.hpp"
#include "wend/render/picture/drawing.hpp"

namespace wend::cli {
namespace {

constexpr double kDriveSeconds = 8;  // that a film takes unless somebody wants another speed
constexpr double kDriveFramesPerSecond = 20;
constexpr std::size_t kMostFrames = 400;
constexpr int kFrameWidth = 800;  // pixels at most
constexpr int kHeight = 680;
constexpr int kDriveFrameHundredths = 5;
constexpr int kDriveOutcomeHundredths = 250;

/// The samples that are shown, one a frame, the last one not among them.
std::vector<std::size_t> frames_of(const Drive& drive, std::optional<double> speed) {
  const double faster = speed.value_or(std::max(1.0, drive.time / kDriveSeconds));
  const double step =
      std::max(faster / kDriveFramesPerSecond, drive.time / static_cast<double>(kMostFrames - 1));
  std::vector<std::size_t> frames;
  double next = 0;
  for (std::size_t i = 0; i + 1 < drive.samples.size(); ++i) {
    if (drive.samples[i].time < next) continue;
    frames.push_back(i);
    next = drive.samples[i].time + step - 1e-9;
  }
  return frames;
}

/// The scene after so many samples.
Scene scene_at(Scene scene, const Drive& drive, std::size_t sample) {
  SceneLine driven{LineRole::driven, {}};
  for (std::size_t i = 0; i <= sample; ++i) driven.points.push_back(drive.samples[i].pose.point());
  scene.lines.push_back(std::move(driven));
  scene.robot = drive.samples[sample].pose;
  return scene;
}

}  // namespace

Expected<std::string, RenderError> gif_of_drive(const Scene& scene, const Drive& drive,
                                                std::optional<double> speed, const Style& style) {
  const auto pixels_at = [&](const Scene& base, std::size_t sample) {
    return draw_pixels(scene_at(base, drive, sample), kFrameWidth, kHeight, style,
                       PixelLegend::below);
  };
  const std::size_t last = drive.samples.size() - 1;
  Scene outcome = scene;
  outcome.collision = drive.first_collision;
  // Their legends must be equally high.
  const Grid<std::uint32_t> end = pixels_at(outcome, last);
  const std::vector<Grid<std::uint32_t>> samples{end, pixels_at(outcome, 0),
                                                 pixels_at(outcome, last / 2)};
  GifAnimation animation(end.width(), end.height(), palette_of(samples));
  for (const std::size_t sample : frames_of(drive, speed)) {
    animation.add(pixels_at(outcome, sample), kDriveFrameHundredths);
  }
  animation.add(end, kDriveOutcomeHundredths);
  return animation.finish();
}

}  // namespace wend::cli
