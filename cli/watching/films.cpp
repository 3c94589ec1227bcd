#include "cli/watching/films.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "cli/interrupt.hpp"
#include "cli/output/picture.hpp"
#include "cli/watching/console.hpp"
#include "cli/watching/frame.hpp"
#include "cli/watching/narrator.hpp"
#include "wend/analysis/layer.hpp"
#include "wend/render/animation/gif.hpp"
#include "wend/render/legend.hpp"

namespace wend::cli {
namespace {

constexpr double kSeconds = 6;                   // length of a film unless a speed is given
constexpr std::size_t kMostFilmFrames = 36'000;  // half an hour
constexpr int kRowsBelow = 9;                    // for the summary, and the prompt after it
constexpr std::size_t kMostGifFrames = 400;
constexpr int kGifWidth = 800;  // pixels at most
constexpr int kGifHeight = 640;
constexpr int kWideGif = 1200;  // of several searches
constexpr int kHighGif = 900;
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

Expected<std::string, Error> gif_of_frames(const Film& film, const Style& style) {
  const std::size_t last = film.frames - 1;
  std::vector<std::size_t> sampled{last};
  for (std::size_t i = 0; i < kPaletteSamples; ++i) sampled.push_back(last * i / kPaletteSamples);
  std::vector<Scene> scenes;
  for (const std::size_t frame : sampled) {
    for (FilmPanel& panel : film.panels_at(frame)) scenes.push_back(std::move(panel.scene));
  }
  FilmCanvas canvas(film.panels_at(last), legend_of(scenes, style), film.width, film.height, style);
  std::vector<Grid<std::uint32_t>> samples;
  samples.reserve(sampled.size());
  for (const std::size_t frame : sampled) samples.push_back(canvas.draw(film.panels_at(frame)));
  if (samples.front().empty()) return failure(Status::memory_limit, "not enough memory for a film");
  GifAnimation animation(samples.front().width(), samples.front().height(), palette_of(samples));
  for (std::size_t frame = 0; frame < last; ++frame) {
    animation.add(canvas.draw(film.panels_at(frame)), film.hundredths);
  }
  animation.add(samples.front(), film.last_hundredths);
  return animation.finish();
}

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

Expected<std::string, Error> gif_of(std::span<const FilmedSearch> searches,
                                    std::optional<double> speed, const Style& style) {
  std::size_t total = 0;
  for (const FilmedSearch& search : searches) {
    total = std::max(total, search.recorder->expansions().size());
  }
  const std::vector<std::size_t> times = frame_times(total, speed, kMostGifFrames);
  const auto panels_at = [&](std::size_t frame) {
    std::vector<FilmPanel> panels;
    for (const FilmedSearch& search : searches) {
      // The last picture shows the outcomes; that of a search which ends earlier is shown from then on.
      const std::size_t all = search.recorder->expansions().size();
      const std::size_t expansions = std::min(frame < times.size() ? times[frame] : total, all);
      const bool ended = frame >= times.size() || (expansions == all && all < total);
      panels.push_back({search.name, fmt::format("{} expanded", expansions),
                        scene_after(ended ? search.outcome : without_path(search.outcome),
                                    *search.recorder, expansions)});
    }
    return panels;
  };
  const bool alone = searches.size() == 1;
  return gif_of_frames({.frames = times.size() + 1,
                        .panels_at = panels_at,
                        .hundredths = kFrameHundredths,
                        .last_hundredths = kOutcomeHundredths,
                        .width = alone ? kGifWidth : kWideGif,
                        .height = alone ? kGifHeight : kHighGif},
                       style);
}

Expected<std::string, Error> gif_of(const std::string& title, const Scene& scene,
                                    const Style& style) {
  return gif_of_frames(
      {.frames = 1,
       .panels_at = [&](std::size_t) { return std::vector<FilmPanel>{{title, "", scene}}; },
       .hundredths = kOutcomeHundredths,
       .last_hundredths = kOutcomeHundredths,
       .width = kGifWidth,
       .height = kGifHeight},
      style);
}

Expected<std::string, Error> gif_of_drive(const std::string& controller, const Scene& scene,
                                          const Drive& drive, std::optional<double> speed,
                                          const Style& style) {
  Scene outcome = scene;
  outcome.collision = drive.first_collision;
  std::vector<std::size_t> frames = frames_of(drive, speed);
  frames.push_back(drive.samples.size() - 1);
  const auto panels_at = [&](std::size_t frame) {
    const std::size_t sample = frames[frame];
    return std::vector<FilmPanel>{{controller, fmt::format("{:.1f} s", drive.samples[sample].time),
                                   scene_at(outcome, drive, sample)}};
  };
  return gif_of_frames({.frames = frames.size(),
                        .panels_at = panels_at,
                        .hundredths = kDriveFrameHundredths,
                        .last_hundredths = kDriveOutcomeHundredths,
                        .width = kFrameWidth,
                        .height = kHeight},
                       style);
}

}  // namespace wend::cli
