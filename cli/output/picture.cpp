#include "cli/output/picture.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/output/terminal.hpp"
#include "wend/render/terminal/text_picture.hpp"

namespace wend::cli {
namespace {

constexpr int kSmallColumns = 80;
constexpr int kSmallRows = 40;
constexpr int kSmallLatticeRows = 50;  // two a cell
constexpr int kRowsForSummary = 9;     // below picture and legend
constexpr int kFewestRows = 2;
constexpr int kRowsForPrompt = 3;     // the command, and the one after it
constexpr int kRowsWorthSeeing = 14;  // of a picture above a long text, which then scrolls

int small_columns(const Screen& screen) {
  return screen.is_terminal ? std::min(screen.columns, kSmallColumns) : kSmallColumns;
}

/// A panel that has nothing to say besides its scene is a picture of its own.
Expected<std::string, Error> drawn(const std::vector<Panel>& panels, PictureKind kind,
                                   const Style& style) {
  const Panel& first = panels.front();
  const bool alone = panels.size() == 1 && first.title.empty() && first.caption.empty();
  return alone ? draw_picture(first.scene, kind, first.style.value_or(style))
               : draw_panels(panels, kind, style);
}

}  // namespace

void PictureArguments::add_to(Parser& app) {
  add_choice<PictureWhen>(app, "--picture", when,
                          {{"auto", PictureWhen::automatic},
                           {"always", PictureWhen::always},
                           {"never", PictureWhen::never}},
                          "Show the map: with auto (the default) small maps (up to 80 x 40 cells) "
                          "always, large maps on a terminal only");
  add_style(
      app, style,
      "Colours of pictures: light (the default), dark, or print (for black-and-white printers)");
  app.further({"--picture", "--style"});
}

void PictureArguments::check(const Parser& command, bool drawn, bool shown) const {
  if (!shown) refuse_idle(command, {"--picture"}, "leave out --format json to see the map");
  if (!drawn && (!shown || when == PictureWhen::never)) {
    refuse_idle(command, {"--style"}, "there is no picture; add -o FILE.png");
  }
}

void add_style(Parser& app, StyleName& style, const std::string& help) {
  NamedValues<StyleName> styles;
  for (const auto& choice : choice_names(StyleName{})) {
    styles.emplace_back(choice.name, choice.value);
  }
  add_choice<StyleName>(app, "--style", style, styles, help);
}

void add_styles(Parser& app, std::vector<StyleName>& styles) {
  const auto add = [&styles](const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      std::vector<std::string> known;
      for (const auto& choice : choice_names(StyleName{})) {
        known.emplace_back(choice.name);
        if (choice.name == name) styles.push_back(choice.value);
      }
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        refuse_value("--style", option_text::unknown_choice(name, known));
      }
    }
  };
  app.add_list("--style", add,
               wrapped("Colours: light (the default), dark or print; several, separated by commas, "
                       "are shown side by side"))
      .separated_by_commas()
      .type_name(kStyleType);
}

bool is_small(const GridMap& map, const Screen& screen) {
  return fits_as_text(map, small_columns(screen), kSmallRows);
}

bool is_small(const Scene& scene, const Screen& screen) {
  return fits_as_text(scene, small_columns(screen),
                      scene.places.on_corners() ? kSmallLatticeRows : kSmallRows);
}

SmallPicture small_picture(const Scene& scene, const Screen& screen) {
  TextStyle style;
  style.colours = screen.terminal.colours != TerminalColours::none;
  style.ascii = !screen.terminal.unicode;
  style.columns = screen.columns;
  const std::string map = text_picture(scene, style);
  style.legend = true;
  return {map, text_picture(scene, style).substr(map.size())};
}

std::string picture(const Scene& scene, const Screen& screen, const PictureArguments& arguments) {
  if (!is_small(scene, screen)) return large_picture(scene, screen, arguments);
  if (arguments.when == PictureWhen::never) return {};
  const SmallPicture small = small_picture(scene, screen);
  return small.map + small.legend;
}

std::string picture_above(const std::string& text, const Scene& scene, const Screen& screen,
                          const PictureArguments& arguments) {
  if (is_small(scene, screen)) return picture(scene, screen, arguments) + text;
  const int rows = std::max(screen.rows - rows_on_screen(text, screen.columns) - kRowsForPrompt,
                            kRowsWorthSeeing);
  return large_picture(scene, screen, arguments, rows) + text;
}

std::string large_picture(const Scene& scene, const Screen& screen,
                          const PictureArguments& arguments) {
  return large_picture(scene, screen, arguments, screen.rows - kRowsForSummary);
}

std::string large_picture(const Scene& scene, const Screen& screen,
                          const PictureArguments& arguments, int rows) {
  const bool seen = arguments.when == PictureWhen::always ||
                    (arguments.when == PictureWhen::automatic && screen.is_terminal);
  if (!seen) return {};
  const Style style = style_of(arguments.style);
  const std::string legend = terminal_legend(scene, screen.columns, screen.terminal, style);
  const auto legend_rows = static_cast<int>(std::count(legend.begin(), legend.end(), '\n'));
  int picture_rows = std::max(rows - legend_rows, kFewestRows);
  std::string shortage = terminal_shortage(scene, screen.columns, picture_rows, screen.terminal);
  if (!shortage.empty()) {
    shortage = folded(shortage, screen.columns) + "\n";
    const auto lines = static_cast<int>(std::count(shortage.begin(), shortage.end(), '\n'));
    picture_rows = std::max(picture_rows - lines, kFewestRows);
  }
  return terminal_picture(scene, screen.columns, picture_rows, screen.terminal, style) + legend +
         shortage;
}

std::vector<std::string> picture_extensions() { return {".png", ".svg", ".pdf"}; }

std::map<std::string, FileWriter> picture_writers(std::vector<Panel> panels, StyleName style) {
  const auto shared = std::make_shared<const std::vector<Panel>>(std::move(panels));
  const auto writer_of = [&](PictureKind kind) {
    return [shared, style, kind](const std::string& file) {
      return write_picture(file, drawn(*shared, kind, style_of(style)));
    };
  };
  return {{".png", writer_of(PictureKind::png)},
          {".svg", writer_of(PictureKind::svg)},
          {".pdf", writer_of(PictureKind::pdf)}};
}

std::string write_picture(const std::string& file, const Expected<std::string, Error>& picture) {
  return picture ? write_bytes(file, *picture) : file + ": " + picture.error().message;
}

}  // namespace wend::cli
