// wend view: maps, and paths on them, as pictures.

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/input_files.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "cli/output/picture.hpp"
#include "cli/output/terminal.hpp"
#include "cli/watching/shown_layers.hpp"
#include "wend/io/text.hpp"
#include "wend/path/path_metrics.hpp"

namespace wend::cli {
namespace {

struct ViewArguments {
  MapArguments map;
  std::vector<std::string> paths;
  std::vector<std::string> beside;
  ShownLayers layers;
  PictureWhen when = PictureWhen::always;
  std::vector<StyleName> styles;
  OutputFiles output;
};

constexpr const char* kViewExamples = R"(Examples:
  wend view office.yaml
  wend view office.yaml plan.csv -o plan.pdf
  wend view office.yaml a.json b.json -o side_by_side.png
  wend view office.yaml plan.csv --style light,dark,print -o styles.png
  wend view office.yaml --show clearance -o clearance.png
  wend view a.map --beside b.map -o both.png

A path is a file of `wend plan -o` (.csv, .json; the smoothed path if there is
one), or a centreline in metres. Several paths, maps, layers or styles are shown
side by side. Exit codes: 0 shown, 1 a path leaves the map, 2 bad usage or
input.)";

/// The title of a panel that shows a file.
std::string name_of(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

Panel path_panel(const FreeSpace& space, const Coordinates& coordinates, const std::string& file) {
  Scene scene = scene_of(space, load_path_on(space, coordinates, file, PathStage::smoothed));
  const PathMetrics metrics = value_or_throw(measure(scene.path, space));
  return {name_of(file), std::move(scene),
          fmt::format("length {}, clearance {}", coordinates.length(metrics.length),
                      coordinates.length(metrics.smallest_clearance))};
}

Panel map_panel(const FreeSpace& space, const std::string& file) {
  return {name_of(file), Scene{.space = space}, size_text(space.map())};
}

/// Shows the panels on standard output as it makes them: of each path and layer, or of the map
/// alone, then of the maps beside it.
class Viewing {
 public:
  Viewing(const ViewArguments& arguments, FreeSpace space)
      : arguments_(arguments), space_(std::move(space)) {}

  void add_paths() {
    const Coordinates coordinates = arguments_.map.coordinates(space_.map());
    std::vector<Panel> loaded;  // all of them, before the first is shown
    loaded.reserve(arguments_.paths.size());
    for (const std::string& file : arguments_.paths) {
      loaded.push_back(path_panel(space_, coordinates, file));
    }
    for (Panel& panel : loaded) add(std::move(panel));
  }

  void add_layers() {
    const Scene scene{.space = space_};
    for (const LayerKind kind : arguments_.layers.kinds()) {
      const Layer layer = map_layer(kind, space_);
      panels_.push_back({layer_title(kind, space_.map().frame()), with_layer(scene, layer), {}});
      if (look_.when != PictureWhen::never) print(layer_text(scene, layer, screen_, look_));
    }
  }

  void add(Panel panel) {
    const std::string drawn = picture(panel.scene, screen_, look_);
    const std::string caption = panel.caption.empty() ? "" : " (" + panel.caption + ")";
    if (!drawn.empty())
      print(folded(visible(panel.title + caption), screen_.columns) + "\n" + drawn);
    panels_.push_back(std::move(panel));
  }

  StyleName style() const { return look_.style; }
  const std::vector<Panel>& panels() const { return panels_; }

 private:
  const ViewArguments& arguments_;
  FreeSpace space_;
  Screen screen_ = detect_screen();
  PictureArguments look_{arguments_.when,
                         arguments_.styles.empty() ? StyleName::light : arguments_.styles.front()};
  std::vector<Panel> panels_;
};

/// Each panel in each style.
std::vector<Panel> in_styles(const std::vector<Panel>& panels,
                             const std::vector<StyleName>& styles) {
  std::vector<Panel> styled;
  for (const Panel& panel : panels) {
    for (const StyleName style : styles) {
      styled.push_back(panel);
      styled.back().style = style_of(style);
    }
  }
  return styled;
}

void check(const ViewArguments& arguments) {
  arguments.output.check();
  std::vector<std::string> read{arguments.map.file};
  read.insert(read.end(), arguments.paths.begin(), arguments.paths.end());
  read.insert(read.end(), arguments.beside.begin(), arguments.beside.end());
  check_read_once(read);
  for (const LayerKind kind : arguments.layers.kinds()) {
    if (source_of(kind) == LayerSource::map) continue;
    throw InputError(
        fmt::format("--show {}: view does not search; use `wend plan --show`", choice_name(kind)));
  }
}

/// Throws InputError for flags that were given and change nothing.
void check_idle(const Parser& view, const ViewArguments& arguments) {
  if (arguments.when == PictureWhen::never && arguments.output.files().empty()) {
    throw InputError("--picture never leaves nothing to show: add -o FILE.png, or leave it out");
  }
  const auto& layers = arguments.layers.kinds();
  if (std::ranges::find(layers, LayerKind::terrain) == layers.end()) {
    refuse_idle(view, {"--clearance-distance", "--clearance-cost"},
                "it changes cell costs only: add --show terrain");
  }
}

int run(const ViewArguments& arguments) {
  check(arguments);
  std::vector<LoadedMap> maps{arguments.map.load_map()};
  for (const std::string& file : arguments.beside) {
    maps.push_back(read_map(file));
    complain_of_notes(file, maps.back());
  }
  for (const LoadedMap& loaded : maps) arguments.output.check_not_among(loaded.files);
  for (const std::string& path : arguments.paths) arguments.output.check_not_among({path});

  const FreeSpace space = arguments.map.free_space(maps.front().map);
  Viewing viewing(arguments, space);
  viewing.add_paths();
  viewing.add_layers();
  if (viewing.panels().empty()) viewing.add(map_panel(space, arguments.map.file));
  for (std::size_t i = 0; i < arguments.beside.size(); ++i) {
    viewing.add(map_panel(arguments.map.free_space(maps[i + 1].map), arguments.beside[i]));
  }
  const bool many = arguments.styles.size() > 1;
  arguments.output.write(picture_writers(
      many ? in_styles(viewing.panels(), arguments.styles) : viewing.panels(), viewing.style()));
  return success;
}

}  // namespace

Command add_view(Parser& app) {
  Parser view = app.add_subcommand("view", "Show a map and paths on it");
  const auto arguments = std::make_shared<ViewArguments>();
  arguments->map.add_to(view);
  arguments->map.add_clearance_cost_to(view);
  view.add_option("PATH", arguments->paths,
                  wrapped("Paths to draw on the map, as written by `wend plan -o` (.csv, .json)"))
      .type_name(kFileType);
  add_texts(view, "--beside", arguments->beside,
            "Another map to show beside the first; may be given several times")
      .type_name(kFileType);
  arguments->layers.add_to(view);
  add_choice<PictureWhen>(
      view, "--picture", arguments->when,
      {{"auto", PictureWhen::automatic},
       {"always", PictureWhen::always},
       {"never", PictureWhen::never}},
      "Show the map on standard output: always (the default), on a terminal only (auto), or never");
  add_styles(view, arguments->styles);
  arguments->output.add_to(view, picture_extensions(),
                           "Write the picture as .png, .svg or .pdf; may be given several times");
  view.footer(kViewExamples);
  return {view, [view, arguments] {
            check_idle(view, *arguments);
            return run(*arguments);
          }};
}

}  // namespace wend::cli
