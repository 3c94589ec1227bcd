#pragma once

// A scene on standard output: a small map as text with a character a cell, a large one as a
// picture.

#include <map>
#include <string>
#include <vector>

#include "cli/arguments/parser.hpp"
#include "cli/output/output.hpp"
#include "cli/output/terminal.hpp"
#include "wend/render/picture/panels.hpp"
#include "wend/render/scene.hpp"
#include "wend/render/style.hpp"

namespace wend::cli {

/// When to show a large map. Small ones always are.
enum class PictureWhen { automatic, always, never };

struct PictureArguments {
  PictureWhen when = PictureWhen::automatic;
  StyleName style = StyleName::light;

  /// --picture auto|always|never and --style light|dark|print
  void add_to(Parser& app);

  /// Throws InputError if one of the two was given and changes nothing: no picture is drawn into a
  /// file, or none is shown, because the results are for programs, say.
  void check(const Parser& command, bool drawn, bool shown) const;
};

/// --style light|dark|print
void add_style(Parser& app, StyleName& style, const std::string& help);

/// --style light,dark,print: one or more.
void add_styles(Parser& app, std::vector<StyleName>& styles);

/// Is the map small enough for one character a cell?
bool is_small(const GridMap& map, const Screen& screen);

/// Is it, or a car's lattice on it, small enough to be shown as text?
bool is_small(const Scene& scene, const Screen& screen);

struct SmallPicture {
  std::string map;     // a line a row
  std::string legend;  // lines
};

/// A small map as text.
SmallPicture small_picture(const Scene& scene, const Screen& screen);

/// The map as text or as a picture; empty where it is not to be shown.
std::string picture(const Scene& scene, const Screen& screen, const PictureArguments& arguments);

/// The same above a text, so that a terminal shows both.
std::string picture_above(const std::string& text, const Scene& scene, const Screen& screen,
                          const PictureArguments& arguments);

/// The map as a picture, however small it is; empty where it is not to be shown.
std::string large_picture(const Scene& scene, const Screen& screen,
                          const PictureArguments& arguments);

/// The same in at most `rows` rows, including the legend's.
std::string large_picture(const Scene& scene, const Screen& screen,
                          const PictureArguments& arguments, int rows);

/// The extensions of picture files.
std::vector<std::string> picture_extensions();

/// Writers that draw the panels side by side; they copy what they are given.
std::map<std::string, FileWriter> picture_writers(std::vector<Panel> panels, StyleName style);

/// Writes a picture if it could be drawn. Returns the error message, empty on success.
std::string write_picture(const std::string& file, const Expected<std::string, Error>& picture);

}  // namespace wend::cli
