// wend info: what a map file holds.

#include <fmt/format.h>

#include <memory>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/map_arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "wend/io/files.hpp"
#include "wend/report/map_info.hpp"

namespace wend::cli {
namespace {

struct InfoArguments {
  MapArguments map;
  Format format = Format::text;
};

constexpr const char* kInfoExamples = R"(Examples:
  wend info office.yaml
  wend info office.yaml --robot-radius 0.25
  wend info arena.map --format json

Exit codes: 0 the map is valid, 2 it is not (standard error gives the reason).)";

int run(const InfoArguments& arguments) {
  LoadedMap loaded = arguments.map.load_silently();
  if (arguments.format == Format::text && !loaded.image_note.empty()) {
    // Another file than the one named is no content of the map: a warning, as in all commands.
    complain(fmt::format("{}: {}", stream_name(arguments.map.file), loaded.image_note));
    std::erase(loaded.notes, loaded.image_note);
  }
  const FreeSpaceOptions robot = arguments.map.options(loaded.map);
  arguments.map.check_memory(loaded.map, survey_bytes(loaded.map, robot));
  const auto info = map_info(stream_name(arguments.map.file), loaded, robot);
  if (!info) throw InputError(info.error().message);
  print(arguments.format == Format::json ? map_info_json(*info) : map_info_text(*info));
  return success;
}

}  // namespace

Command add_info(Parser& app) {
  Parser info = app.add_subcommand("info", "Describe a map file");
  const auto arguments = std::make_shared<InfoArguments>();
  arguments->map.add_to(info);
  arguments->map.add_clearance_cost_to(info);
  add_format(info, arguments->format);
  info.footer(kInfoExamples);
  return {info, [arguments] { return run(*arguments); }};
}

}  // namespace wend::cli
