// What holds of the text pictures of all yards and drives.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "wend/render/car_scene_test.hpp"
#include "wend/render/terminal/glyphs.hpp"
#include "wend/render/terminal/text_picture.hpp"

namespace wend {
namespace {

/// The characters of a picture, each a string; all rows of the same length.
Grid<std::string> characters_of(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::vector<std::string>> rows;
  std::size_t width = 0;
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    for (const char byte : line) {
      const bool continues = (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
      if (!continues) rows.back().emplace_back();
      rows.back().back() += byte;
    }
    width = std::max(width, rows.back().size());
  }
  Grid<std::string> grid(static_cast<int>(width), static_cast<int>(rows.size()), " ");
  for (int y = 0; y < grid.height(); ++y) {
    const auto& row = rows[static_cast<std::size_t>(y)];
    std::copy(row.begin(), row.end(), grid.row(y).begin());
  }
  return grid;
}

/// The same upside down.
Grid<std::string> mirrored(const Grid<std::string>& grid) {
  static const std::map<std::string, std::string> kMirrored = [] {
    std::map<std::string, std::string> both;
    for (const auto& [a, b] : std::vector<std::pair<std::string, std::string>>{{"↑", "↓"},
                                                                               {"╭", "╰"},
                                                                               {"╮", "╯"},
                                                                               {"┬", "┴"},
                                                                               {"╔", "╚"},
                                                                               {"╗", "╝"},
                                                                               {"╦", "╩"},
                                                                               {"▘", "▖"},
                                                                               {"▝", "▗"},
                                                                               {"▀", "▄"},
                                                                               {"▛", "▙"},
                                                                               {"▜", "▟"},
                                                                               {"▞", "▚"}}) {
      both[a] = b;
      both[b] = a;
    }
    return both;
  }();
  Grid<std::string> mirror(grid.width(), grid.height());
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const auto& character = grid[{x, y}];
      const auto found = kMirrored.find(character);
      mirror[{x, grid.height() - 1 - y}] = found == kMirrored.end() ? character : found->second;
    }
  }
  return mirror;
}

/// Which neighbours a line's character leads to; nothing of any other character.
std::vector<Cell> joins(const std::string& character) {
  static const std::map<std::string, std::string> kJoins{
      {"─", "rl"},  {"│", "ud"},  {"╭", "rd"},  {"╮", "ld"},  {"╯", "lu"},   {"╰", "ru"},
      {"├", "rud"}, {"┤", "lud"}, {"┬", "rld"}, {"┴", "rlu"}, {"┼", "rlud"}, {"═", "rl"},
      {"║", "ud"},  {"╔", "rd"},  {"╗", "ld"},  {"╝", "lu"},  {"╚", "ru"},   {"╠", "rud"},
      {"╣", "lud"}, {"╦", "rld"}, {"╩", "rlu"}, {"╬", "rlud"}};
  const auto found = kJoins.find(character);
  std::vector<Cell> steps;
  if (found == kJoins.end()) return steps;
  for (const char way : found->second) {
    steps.push_back(way == 'r'   ? Cell{1, 0}
                    : way == 'l' ? Cell{-1, 0}
                    : way == 'u' ? Cell{0, -1}
                                 : Cell{0, 1});
  }
  return steps;
}

bool is_arrow(const std::string& character) {
  return character == "→" || character == "↓" || character == "←" || character == "↑";
}

/// A random yard, and a random drive that may leave it.
Scene random_drive(bool y_up) {
  const int width = *rc::gen::inRange(1, 12);
  const int height = *rc::gen::inRange(1, 12);
  Grid<CellState> cells(width, height);
  Grid<double> terrain(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int kind = *rc::gen::inRange(0, 12);
      if (kind == 0) cells[{x, y}] = CellState::occupied;
      if (kind == 1) terrain[{x, y}] = *rc::gen::inRange(2, 10);
    }
  }
  const auto numbers = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, kCarMoves));
  std::vector<CarMove> moves;
  for (const int number : numbers) moves.push_back(static_cast<CarMove>(number));
  const CornerPose from{{*rc::gen::inRange(0, width + 1), *rc::gen::inRange(0, height + 1)},
                        static_cast<Heading>(*rc::gen::inRange(0, kHeadings))};
  return car_on(*make_free_space(*make_grid_map(cells, {.y_up = y_up}, terrain)),
                driven(from, moves));
}

RC_GTEST_PROP(LatticePicture, IsUpsideDownForAMapUpsideDown, ()) {
  const Scene drive = random_drive(false);
  const int columns = *rc::gen::inRange(1, 70);
  Scene upside_down = drive;
  const GridMap& map = drive.space.map();
  Grid<CellState> cells(map.width(), map.height());
  Grid<double> terrain(map.width(), map.height(), 1);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      cells[{x, y}] = map.state({x, y});
      terrain[{x, y}] = map.terrain({x, y});
    }
  }
  upside_down.space = *make_free_space(*make_grid_map(cells, {.y_up = true}, terrain));
  RC_ASSERT(mirrored(characters_of(text_picture(drive, {.columns = columns}))) ==
            characters_of(text_picture(upside_down, {.columns = columns})));
}

/// The poses as long as they lie on the map.
Path poses_inside(const Scene& scene) {
  Path inside;
  for (const Pose& pose : scene.path.poses()) {
    if (pose.x < 0 || pose.y < 0 || pose.x > scene.space.width()) break;
    if (pose.y > scene.space.height()) break;
    inside.drive_to(pose);
  }
  return inside;
}

/// Every line goes on to a line that comes from there, or to a pose.
RC_GTEST_PROP(LatticePicture, DrawsWholeLines, ()) {
  Scene drive = random_drive(*rc::gen::arbitrary<bool>());
  drive.path = poses_inside(drive);
  const auto picture = characters_of(text_picture(drive, {.columns = *rc::gen::inRange(1, 70)}));
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      for (const Cell step : joins(picture[{x, y}])) {
        const Cell next{x + step.x, y + step.y};
        const auto back = joins(picture[next]);
        const bool goes_on = std::ranges::find(back, Cell{-step.x, -step.y}) != back.end();
        RC_ASSERT(goes_on || is_arrow(picture[next]));
      }
    }
  }
}

RC_GTEST_PROP(LatticePicture, IsAsciiOfTheSameSizeWhereThatIsWanted, ()) {
  Scene drive = random_drive(*rc::gen::arbitrary<bool>());
  drive.start = drive.path.poses().front();
  const int columns = *rc::gen::inRange(1, 70);
  const TextStyle ascii{.legend = true, .columns = columns, .ascii = true};
  const std::string text = text_picture(drive, ascii);
  RC_ASSERT(std::ranges::all_of(text, [](char byte) { return byte > 0; }));
  const auto plain = characters_of(text_picture(drive, {.columns = columns}));
  const auto picture = characters_of(text_picture(drive, {.columns = columns, .ascii = true}));
  RC_ASSERT(picture.height() == plain.height());
  for (int y = 0; y < plain.height(); ++y) {
    for (int x = 0; x < plain.width(); ++x) {
      if (is_arrow(plain[{x, y}])) RC_ASSERT((picture[{x, y}]) == ascii_of(plain[{x, y}]));
    }
  }
}

RC_GTEST_PROP(LatticePicture, StaysWithinItsColumnsAndRowsAndNumbersCornersApart, ()) {
  Scene scene{.space = *make_free_space(*make_grid_map(
                  Grid<CellState>(*rc::gen::inRange(1, 150), *rc::gen::inRange(1, 60))))};
  scene.places = corners_of(scene.space, *rc::gen::inRange(1, 12));
  const int columns = *rc::gen::inRange(1, 120);
  const int rows = *rc::gen::inRange(1, 60);
  RC_PRE(fits_as_text(scene, columns, rows));
  const std::string text = text_picture(scene, {.columns = columns});
  const auto picture = characters_of(text);
  RC_ASSERT(picture.width() <= columns);
  RC_ASSERT(picture.height() <= rows);
  std::istringstream line(text.substr(0, text.find('\n')));
  const std::vector<int> numbers{std::istream_iterator<int>(line), {}};
  const int last = scene.space.width() / scene.places.spacing * scene.places.spacing;
  const int step = numbers.size() > 1 ? numbers[1] : last + 1;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    RC_ASSERT(numbers[i] == static_cast<int>(i) * step);
  }
  RC_ASSERT(numbers.back() + step > last);
}

}  // namespace
}  // namespace wend
