#include "cli/arguments/input_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/flags.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "cli/output/plan_text.hpp"
#include "wend/io/files.hpp"
#include "wend/path/path_collision.hpp"

namespace wend::cli {
namespace {

Expected<LoadedMap, Error> load_map_or_stream(const std::string& file, const LoadOptions& options) {
  if (!is_stream(file)) return load_map(file, options);
  const auto bytes = read_stream(file);
  if (!bytes) return Unexpected<Error>(bytes.error());
  auto loaded = parse_map(*bytes, stream_name(file), options);
  // If standard input is redirected from a file, that file must not be overwritten.
  if (loaded) loaded->files.emplace_back(is_standard_input(file) ? "/dev/stdin" : file);
  return loaded;
}

Expected<Path, PathFileError> load_path_or_stream(const std::string& file, const Frame& frame,
                                                  PathStage stage) {
  if (!is_stream(file)) return load_path(file, frame, stage);
  const auto text = read_stream(file, kLargestPathFile);
  if (!text) return Unexpected<Error>(text.error());
  return parse_path(*text, stream_name(file), frame, stage);
}

Expected<std::vector<QueryRow>, Error> load_queries_or_stream(const std::string& file) {
  if (!is_stream(file)) return load_query_csv(file);
  const auto text = read_stream(file, kLargestQueryFile);
  if (!text) return Unexpected<Error>(text.error());
  return parse_query_csv(*text, stream_name(file));
}

}  // namespace

void check_read_once(const std::vector<std::string>& names) {
  const auto from_input = [](const std::string& name) { return is_standard_input(name); };
  if (std::count_if(names.begin(), names.end(), from_input) < 2) return;
  throw InputError("standard input can be read only once: use '-' for one file only");
}

LoadedMap read_map(const std::string& file, const LoadOptions& options) {
  return value_or_throw(load_map_or_stream(file, options));
}

void complain_of_notes(const std::string& file, const LoadedMap& loaded) {
  for (const std::string& note : loaded.notes) {
    complain(fmt::format("{}: {}", stream_name(file), note));
  }
}

std::vector<QueryRow> read_queries(const std::string& file) {
  return value_or_throw(load_queries_or_stream(file));
}

Path read_path(const std::string& file, const Frame& frame, PathStage stage) {
  auto path = load_path_or_stream(file, frame, stage);
  if (path) return *std::move(path);
  const auto& error = path.error();
  if (error.failed_plan) throw NoPathError(error.message, *error.failed_plan);
  throw InputError(error.message);
}

void add_path_file(Parser& app, std::string& file) {
  app.add_option("PATH", file,
                 wrapped("Path, as written by `wend plan -o` (.csv, .json), or points in metres "
                         "(.csv with columns x_m and y_m); - reads standard input"))
      .required()
      .type_name(kFileType);
}

Path load_path_for(const FreeSpace& space, const std::string& file, PathStage stage) {
  return read_path(file, space.map().frame(), stage);
}

Path load_path_on(const FreeSpace& space, const Coordinates& coordinates, const std::string& file,
                  PathStage stage) {
  Path path = load_path_for(space, file, stage);
  const auto exit = first_exit(path, space);
  if (!exit) return path;
  const std::string reason = not_free_text(*exit, coordinates);
  throw NoPathError(reason, {"not_free", reason});
}

}  // namespace wend::cli
