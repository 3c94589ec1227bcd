#include "picture.hpp"

#include <algorithm>

#include "flags.hpp"
#include "wend/render/text_picture.hpp"

namespace wend::cli {
namespace {

constexpr int kSmallColumns = 80;
constexpr int kSmallRows = 40;
constexpr int kRowsForSummary = 10;  // below the picture
constexpr int kFewestRows = 8;

}  // namespace

void add_picture(CLI::App& app, PictureWhen& when) {
  add_choice<PictureWhen>(app, "--picture", when,
                          {{"auto", PictureWhen::automatic},
                           {"always", PictureWhen::always},
                           {"never", PictureWhen::never}},
                          "Show the map: auto, the default, shows small ones (up to 80 x 40 cells) "
                          "always and large ones on a terminal only");
}

bool is_small(const GridMap& map, const Screen& screen) {
  const int columns = screen.is_terminal ? std::min(screen.columns, kSmallColumns) : kSmallColumns;
  return fits_as_text(map, columns, kSmallRows);
}

std::string picture(const Scene& scene, const Screen& screen, PictureWhen when) {
  if (when == PictureWhen::never) return {};
  if (is_small(scene.space.map(), screen)) {
    const bool colours = screen.terminal.colours != TerminalColours::none;
    return text_picture(scene, {.colours = colours, .legend = true});
  }
  if (when == PictureWhen::automatic && !screen.is_terminal) return {};
  const int rows = std::max(screen.rows - kRowsForSummary, kFewestRows);
  return terminal_picture(scene, screen.columns, rows, screen.terminal);
}

}  // namespace wend::cli
