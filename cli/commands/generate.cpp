// wend generate: a map made from a seed.

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/option_flags.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/map_saving.hpp"
#include "cli/output/output.hpp"
#include "wend/base/parse.hpp"
#include "wend/generate/generators.hpp"
#include "wend/generate/kept_cells.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/io/map/save_map.hpp"
#include "wend/io/text.hpp"
#include "wend/report/json.hpp"
#include "wend/session/units.hpp"

namespace wend::cli {
namespace {

struct GenerateArguments {
  std::string kind;
  std::string size;
  std::uint64_t seed = 1;
  std::vector<std::string> keep;  // "X,Y" or "X,Y,X,Y", in cells
  bool force = false;
  OptionFlags options{"generator"};
  Format format = Format::text;
  OutputFiles output;
};

constexpr const char* kGenerateExamples = R"(Examples:
  wend generate office --size 160x100 --seed 7 -o office.yaml
  wend generate maze --size 41x21 --seed 3
  wend generate random --size 512x512 --density 0.35 -o random.map -o random.png
  wend generate random --size 20x20 --density 0.3 --keep 0,0 --keep 19,19
  wend generate car --size 20x20 --obstacles 25 --rough 25 --seed 3 -o yard.txt
  wend generate parking --size 60x40 --occupied 0.8 -o parking.yaml
  wend generate car_park --size 480x330 --seed 7 -o car_park.yaml
  wend generate scenario random.map --buckets 10 --seed 1 -o random.map.scen

The same kind, size, options and seed give the same map everywhere.)";

/// Where a format cannot hold the terrain.
constexpr const char* kWayOut = "; `wend convert` rounds it and lists what is lost";

constexpr const char* kNoCells = " is not a cell X,Y, or several, as in 1,1,18,18";

struct Size {
  int width;
  int height;
};

Size parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto width = parse_integer<int>(std::string_view(text).substr(0, cross));
  const auto height = cross == std::string::npos
                          ? std::nullopt
                          : parse_integer<int>(std::string_view(text).substr(cross + 1));
  if (!width || !height) {
    throw InputError(fmt::format("--size: {} is not WIDTHxHEIGHT, as in 160x100", quote(text)));
  }
  return {*width, *height};
}

/// The parser cannot ask for it, because `wend generate scenario` has none.
void check_kind(const GenerateArguments& arguments) {
  if (arguments.kind.empty()) {
    throw InputError(
        "generate needs a KIND of map or `scenario`; `wend generate --help` lists the kinds");
  }
}

GridMap generate(const GenerateArguments& arguments) {
  const GeneratorInfo* generator = generators().find(arguments.kind);
  if (generator == nullptr) throw InputError(generators().unknown("generator", arguments.kind));
  const Size size = arguments.size.empty()
                        ? Size{generator->default_width, generator->default_height}
                        : parse_size(arguments.size);
  return value_or_throw(generator->make(size.width, size.height, arguments.seed,
                                        arguments.options.values_for(generator->name)));
}

/// The cells of "1,1,18,18".
std::vector<Cell> parse_cells(const std::string& text) {
  std::vector<int> numbers;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const auto number = parse_integer<int>(word);
    if (!number) throw InputError("--keep: " + quote(text) + kNoCells);
    numbers.push_back(*number);
  }
  if (numbers.empty() || numbers.size() % 2 != 0 || text.ends_with(',')) {
    throw InputError("--keep: " + quote(text) + kNoCells);
  }
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < numbers.size(); i += 2) cells.push_back({numbers[i], numbers[i + 1]});
  return cells;
}

/// The cells of --keep. Throws InputError for one that is not on the map.
std::vector<Cell> kept_cells(const GenerateArguments& arguments, const GridMap& map) {
  std::vector<Cell> cells;
  for (const std::string& text : arguments.keep) {
    for (const Cell cell : parse_cells(text)) {
      cells.push_back(cell);
      if (map.contains(cell)) continue;
      throw InputError(fmt::format("--keep: the cell {} is outside the map of {} x {} cells",
                                   cell_text(cell), map.width(), map.height()));
    }
  }
  return cells;
}

/// The map with the cells of --keep free and joined. A note says how many more that took.
GridMap with_kept_cells(const GenerateArguments& arguments, GridMap map) {
  const std::vector<Cell> cells = kept_cells(arguments, map);
  if (cells.empty()) return map;
  KeptCells kept = value_or_throw(keep_cells(map, cells));
  if (const std::size_t opened = kept.opened.size(); opened > 0) {
    complain(fmt::format("--keep: {} more cell{} freed, so that a path joins the kept ones", opened,
                         opened == 1 ? " was" : "s were"));
  }
  return std::move(kept.map);
}

double free_share(const GridMap& map) {
  const std::size_t blocked = map.occupied().count() + map.unknown().count();
  return 1 - static_cast<double>(blocked) / static_cast<double>(map.size());
}

std::string json_of(const GenerateArguments& arguments, const GridMap& map) {
  return wend::text_of({{"kind", arguments.kind},
                        {"width", map.width()},
                        {"height", map.height()},
                        {"seed", arguments.seed},
                        {"free_share", free_share(map)},
                        {"files", files_of_maps(arguments.output.files())}});
}

std::string text_grid_of(const GridMap& map) {
  auto text = encode_map(map, MapFormat::text_grid);
  if (!text) throw InputError(fmt::format("{}; -o FILE.yaml can", text.error().message));
  return std::move(text->bytes);
}

std::string text_of(const GenerateArguments& arguments, const GridMap& map) {
  if (arguments.output.files().empty()) return text_grid_of(map);
  return fmt::format(
      "{}: {} x {} cells, seed {}, {:.1f} % free\nwritten: {}\n", arguments.kind, map.width(),
      map.height(), arguments.seed, 100 * free_share(map),
      visible(fmt::format("{}", fmt::join(files_of_maps(arguments.output.files()), ", "))));
}

int run(const GenerateArguments& arguments) {
  check_kind(arguments);
  arguments.output.check();
  for (const std::string& file : arguments.output.files()) {
    if (!arguments.force) check_picture(file, "-o " + file);
  }
  const GridMap map = with_kept_cells(arguments, generate(arguments));
  arguments.output.write_all([&map](const std::string& file) {
    if (file == kStandardOutput) {
      print(text_grid_of(map));
      return std::string();
    }
    const auto saved = save_map(map, file);
    if (saved) return std::string();
    return saved.error().message + (map.uniform_terrain() ? "" : kWayOut);
  });
  if (arguments.output.print()) return success;
  print(arguments.format == Format::json ? json_of(arguments, map) : text_of(arguments, map));
  return success;
}

std::string default_sizes() {
  std::string text = "Size in columns and rows, as in 160x100 (default";
  const GeneratorInfo& first = *generators().begin();
  const auto is_usual = [&](const GeneratorInfo& kind) {
    return kind.default_width == first.default_width && kind.default_height == first.default_height;
  };
  for (const GeneratorInfo& kind : generators()) {
    if (is_usual(kind)) continue;
    text += fmt::format(" {}x{} for {},", kind.default_width, kind.default_height, kind.name);
  }
  return text + fmt::format(" {}x{} for others)", first.default_width, first.default_height);
}

}  // namespace

Command add_generate(Parser& app) {
  Parser generate = app.add_subcommand("generate", "Generate a map, or a scenario for a map");
  const auto arguments = std::make_shared<GenerateArguments>();
  std::string kinds;
  for (const GeneratorInfo& kind : generators()) {
    if (!kinds.empty()) kinds += '\n';
    kinds += wrapped(kind.name + ": " + kind.summary);
    arguments->options.collect(kind.name, kind.options);
  }
  generate.add_option("KIND", arguments->kind, kinds).type_name(kGeneratorType);
  generate.add_option("--size", arguments->size, wrapped(default_sizes())).type_name("WxH");
  add_count(generate, "--seed", arguments->seed, "Seed of the map (default 1)");
  add_texts(
      generate, "--keep", arguments->keep,
      "Cells that stay free and joined by a path of a point, as in 1,1,18,18 for a start and a "
      "goal; may be given several times. Where no path joins them, as few more cells as "
      "possible are freed, and a note says how many")
      .type_name("X,Y[,X,Y]");
  add_format(generate, arguments->format);
  arguments->output.add_to(
      generate, map_extensions(MapUse::save),
      "Write the map: " + map_formats_text(MapUse::save) +
          "; may be given several times. Without -o the map is printed as a text grid",
      "the text grid");
  add_force(generate, arguments->force);
  arguments->options.add_to(generate, "KIND");
  generate.footer(kGenerateExamples);
  const Command scenario = add_generate_scenario(generate);
  return {generate, [generate, arguments, scenario] {
            if (scenario.parser.parsed()) return scenario.run();
            check_force(generate, arguments->output.files());
            return run(*arguments);
          }};
}

}  // namespace wend::cli
