// wend convert: a map in another format.

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/map_saving.hpp"
#include "cli/output/output.hpp"
#include "wend/io/map/losses.hpp"
#include "wend/io/map/map_format.hpp"
#include "wend/io/map/save_map.hpp"
#include "wend/io/text.hpp"
#include "wend/report/json.hpp"

namespace wend::cli {
namespace {

namespace fs = std::filesystem;

struct ConvertArguments {
  MapFileArguments input;
  std::string output;
  bool strict = false;
  bool force = false;
  Format format = Format::text;

  bool prints() const { return output == kStandardOutput; }
};

constexpr const char* kConvertExamples = R"(Examples:
  wend convert arena.map arena.yaml
  wend convert grid.txt grid.png
  wend convert grid.txt grid.map --strict

Standard error lists what the new format cannot hold, one loss per line.

Exit codes: 0 written, 1 not written because of --strict and a loss, 2 bad usage
or input.)";

struct Conversion {
  LoadedMap loaded;
  MapFormat format;  // of the new file
  std::vector<std::string> losses;
};

/// Throws InputError if a file to be written is one that the map was read from.
void check_files(const ConvertArguments& arguments, const LoadedMap& loaded) {
  for (const fs::path& file : saved_files(arguments.output)) {
    const bool beside = file != arguments.output;
    check_not_among(loaded.files, file,
                    beside ? fmt::format("{}, the image of {}", file.string(), arguments.output)
                           : arguments.output);
  }
}

Conversion prepare(const ConvertArguments& arguments) {
  const auto format = arguments.prints() ? MapFormat::text_grid : saved_format(arguments.output);
  if (!format) throw InputError(format.error().message);
  LoadedMap loaded = arguments.input.load();
  check_files(arguments, loaded);
  if (!arguments.force) check_picture(arguments.output, arguments.output);
  std::vector<std::string> lost = losses(loaded.map, *format);
  return {std::move(loaded), *format, std::move(lost)};
}

std::string json_of(const ConvertArguments& arguments, const Conversion& conversion, bool saved) {
  std::vector<std::string> files;
  if (saved) files = files_of_maps({arguments.output});
  const GridMap& map = conversion.loaded.map;
  return wend::text_of({{"from", to_string(conversion.loaded.format)},
                        {"to", to_string(conversion.format)},
                        {"width", map.width()},
                        {"height", map.height()},
                        {"losses", conversion.losses},
                        {"notes", conversion.loaded.notes},
                        {"files", files}});
}

std::string text_of(const ConvertArguments& arguments, const Conversion& conversion) {
  const GridMap& map = conversion.loaded.map;
  return fmt::format(
      "{}: {} x {} cells, {} to {}\n",
      visible(fmt::format("{}", fmt::join(files_of_maps({arguments.output}), " and "))),
      map.width(), map.height(), to_string(conversion.loaded.format), to_string(conversion.format));
}

void save(const GridMap& map, const ConvertArguments& arguments) {
  if (arguments.prints()) {
    const auto text = encode_map(map, MapFormat::text_grid);
    if (!text) throw InputError(text.error().message);
    return print(text->bytes);
  }
  const auto done = save_map(map, arguments.output);
  if (!done) throw InputError(done.error().message);
}

int run(const ConvertArguments& arguments) {
  const Conversion conversion = prepare(arguments);
  for (const std::string& loss : conversion.losses) {
    complain(fmt::format("{}: {}", arguments.output, loss));
  }
  const bool saved = !arguments.strict || conversion.losses.empty();
  if (saved) {
    save(nearest_map(conversion.loaded.map, conversion.format), arguments);
  } else {
    complain(fmt::format("{} was not written because of --strict", arguments.output));
  }
  if (arguments.prints()) return saved ? success : no_plan;
  if (arguments.format == Format::json) {
    print(json_of(arguments, conversion, saved));
  } else if (saved) {
    print(text_of(arguments, conversion));
  }
  return saved ? success : no_plan;
}

}  // namespace

Command add_convert(Parser& app) {
  Parser convert = app.add_subcommand("convert", "Convert a map to another format");
  const auto arguments = std::make_shared<ConvertArguments>();
  arguments->input.add_to(convert, "IN");
  convert
      .add_option("OUT", arguments->output,
                  wrapped("Output file; the extension sets the format: " +
                          map_formats_text(MapUse::save) + "; - prints a text grid"))
      .required()
      .type_name(kFileType);
  convert.add_flag("--strict", arguments->strict,
                   wrapped("Write nothing if the new format would lose information"));
  add_force(convert, arguments->force);
  add_format(convert, arguments->format);
  convert.footer(kConvertExamples);
  return {convert, [convert, arguments] {
            check_force(convert, {arguments->output});
            return run(*arguments);
          }};
}

}  // namespace wend::cli
