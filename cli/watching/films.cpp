#include "cli/watching/films.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <thread>
#include <vector>

#include "cli/interrupt.hpp"
#include "cli/output/picture.hpp"
#include "cli/watching/console.hpp"
#include "cli/watching/frame.hpp"
#include "cli/watching/narrator.hpp"
#include "wend/analysis/layer.hpp"
#include "wend/render/animation/gif.hpp"
#include "wend/render/picture/drawing.hpp"

namespace wend::cli {
namespace {

constexpr double kSeconds = 6;                   // length of a film unless a speed is given
constexpr std::size_t kMostFilmFrames = 36'000;  // half an hour
constexpr int kRowsBelow = 9;                    // for the summary, and the prompt after it
constexpr std::size_t kMostGifFrames = 400;
constexpr int kGifWidth = 800;  // pixels at most
constexpr int kGifHeight = 640;
constexpr int kFrameHundredths = 100 / kFramesPerSecond;
constexpr int kOutcomeHundredths = 250;
constexpr std::size_t kPaletteSamples = 4;

std::string progress_line(const SearchSnapshot& snapshot, std::size_t expansions) {
  return fmt::format("expansion {}, frontier {}\n", expansions, snapshot.frontier.count());
}

Scene without_path(Scene scene) {
  scene.path = {};
  scene.lines.clear();
  return scene;
}

constexpr double kDriveSeconds = 8;  // length of a film unless a speed is given
constexpr double kDriveFramesPerSecond = 20;
constexpr std::size_t kMostFrames = 400;
constexpr int kFrameWidth = 800;  // pixels at most
constexpr int kHeight = 680;
constexpr int kDriveFrameHundredths = 5;
constexpr int kDriveOutcomeHundredths = 250;

/// The samples that are shown, one per frame, without the last one.
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

/// The scene after `sample` samples.
Scene scene_at(Scene scene, const Drive& drive, std::size_t sample) {
  SceneLine driven{LineRole::driven, {}};
  for (std::size_t i = 0; i <= sample; ++i) driven.points.push_back(drive.samples[i].pose.point());
  scene.lines.push_back(std::move(driven));
  scene.robot = drive.samples[sample].pose;
  return scene;
}

}  // namespace

Scene with_snapshot(Scene scene, const SearchSnapshot& snapshot) {
  scene.marked = {{CellRole::expanded, snapshot.expanded}, {CellRole::frontier, snapshot.frontier}};
  if (snapshot.current) {
    BitGrid current(scene.space.width(), scene.space.height());
    current.set(*snapshot.current, true);
    scene.marked.push_back({CellRole::current, std::move(current)});
  }
  return scene;
}

Scene scene_after(const Scene& base, const SearchRecorder& recorder, std::size_t expansions) {
  const MotionTree& motions = recorder.motions();
  if (motions.empty()) return with_snapshot(base, recorder.snapshot(expansions));
  Scene scene = base;
  const HeatRange range{1, static_cast<double>(motions.size())};
  const Grid<double> none(scene.space.width(), scene.space.height(),
                          std::numeric_limits<double>::quiet_NaN());
  scene.heatmap = {std::string(title_of(LayerKind::expansion)), none, range};
  scene.motions = motions.beginning(std::max<std::size_t>(expansions, 1));
  return scene;
}

std::vector<std::size_t> frame_times(std::size_t expansions, std::optional<double> speed,
                                     std::size_t most) {
  const auto total = static_cast<double>(expansions);
  const double a_frame = speed ? *speed / kFramesPerSecond : total / (kSeconds * kFramesPerSecond);
  // If no speed is given, a frame that shows nothing new would only take time.
  const double step =
      std::max({speed ? a_frame : std::max(a_frame, 1.0), total / static_cast<double>(most - 1)});
  std::vector<std::size_t> times;
  for (std::size_t i = 0; static_cast<double>(i) * step < total; ++i) {
    times.push_back(static_cast<std::size_t>(static_cast<double>(i) * step));
  }
  times.push_back(expansions);
  return times;
}

void play(const Scene& outcome, const SearchRecorder& recorder, const Screen& screen,
          const PictureArguments& pictures, std::optional<double> speed) {
  const Interruptible interruptible;  // to show the cursor again
  const auto frame = [&](const Scene& scene) {
    return frame_text(scene, {}, screen, pictures.style, kRowsBelow);
  };
  const Scene base = without_path(outcome);
  Display display(true);
  auto next = std::chrono::steady_clock::now();
  for (const std::size_t expansions :
       frame_times(recorder.expansions().size(), speed, kMostFilmFrames)) {
    if (Interruptible::cancelled()) break;
    const SearchSnapshot snapshot = recorder.snapshot(expansions);
    display.show(frame(with_snapshot(base, snapshot)) + progress_line(snapshot, expansions));
    next += std::chrono::milliseconds(1000 / kFramesPerSecond);
    std::this_thread::sleep_until(next);
  }
  display.show(frame(with_snapshot(outcome, recorder.snapshot())));
}

Expected<std::string, Error> gif_of(const Scene& outcome, const SearchRecorder& recorder,
                                    std::optional<double> speed, const Style& style) {
  const Scene base = without_path(outcome);
  const auto pixels_after = [&](std::size_t expansions) {
    return draw_pixels(scene_after(base, recorder, expansions), kGifWidth, kGifHeight, style);
  };
  const std::size_t total = recorder.expansions().size();
  const Grid<std::uint32_t> last =
      draw_pixels(scene_after(outcome, recorder, total), kGifWidth, kGifHeight, style);
  std::vector<Grid<std::uint32_t>> samples{last};
  for (std::size_t i = 0; i < kPaletteSamples; ++i) {
    samples.push_back(pixels_after(total * i / kPaletteSamples));
  }
  GifAnimation animation(last.width(), last.height(), palette_of(samples));
  for (const std::size_t expansions : frame_times(total, speed, kMostGifFrames)) {
    animation.add(pixels_after(expansions), kFrameHundredths);
  }
  animation.add(last, kOutcomeHundredths);
  return animation.finish();
}

Expected<std::string, Error> gif_of(const Scene& scene, const Style& style) {
  const Grid<std::uint32_t> pixels = draw_pixels(scene, kGifWidth, kGifHeight, style);
  GifAnimation animation(pixels.width(), pixels.height(), palette_of(std::span(&pixels, 1)));
  animation.add(pixels, kOutcomeHundredths);
  return animation.finish();
}

Expected<std::string, Error> gif_of_drive(const Scene& scene, const Drive& drive,
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
