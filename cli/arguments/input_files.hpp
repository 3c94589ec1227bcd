#pragma once

// Maps, paths and queries that are read from files, standard input ("-") and pipes.

#include <string>
#include <vector>

#include "cli/arguments/coordinates.hpp"
#include "cli/arguments/parser.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/path/load_path.hpp"
#include "wend/io/query/query_csv.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {

/// Throws InputError if more than one of the names is standard input, which can be read only once.
void check_read_once(const std::vector<std::string>& names);

/// Throws InputError if it cannot be read.
LoadedMap read_map(const std::string& file, const LoadOptions& options = {});

/// Writes the notes on a map to standard error, a line each.
void complain_of_notes(const std::string& file, const LoadedMap& loaded);

/// Throws InputError if the file is not a list of queries. An invalid row is kept, with its error.
std::vector<QueryRow> read_queries(const std::string& file);

/// Throws NoPathError if the file holds the reason of a failed plan, InputError if it cannot be read.
Path read_path(const std::string& file, const Frame& frame, PathStage stage);

/// The positional PATH.
void add_path_file(Parser& app, std::string& file);

/// Throws InputError if it cannot be read, NoPathError if it says why there is no path.
Path load_path_for(const FreeSpace& space, const std::string& file, PathStage stage);

/// The same; also throws NoPathError if the path leaves the map.
Path load_path_on(const FreeSpace& space, const Coordinates& coordinates, const std::string& file,
                  PathStage stage);

}  // namespace wend::cli
