#pragma once

// Maps and paths that are read: files, standard input ("-") and pipes.

#include <string>
#include <vector>

#include "wend/io/load_map.hpp"
#include "wend/io/load_path.hpp"
#include "wend/io/query_csv.hpp"

namespace wend::cli {

/// Throws InputError if more than one of the names is standard input, which can be read only once.
void check_read_once(const std::vector<std::string>& names);

/// Throws InputError if it cannot be read.
LoadedMap read_map(const std::string& file, const LoadOptions& options = {});

/// Throws InputError if it is no list of queries, not for a row of it that is none.
std::vector<QueryRow> read_queries(const std::string& file);

/// Throws NoPathError for a file that says why there is no path, InputError if it cannot be read.
Path read_path(const std::string& file, const Frame& frame, PathStage stage);

}  // namespace wend::cli
