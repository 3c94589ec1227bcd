#pragma once

// Reading what can be read only once, from front to end: standard input and pipes. Loaders that
// take names of files refuse these (see read_file.hpp), so that none of them waits for ever; who
// wants them asks here.
//
//   if (wend::is_stream(name)) {
//     const auto bytes = wend::read_stream(name);
//     if (!bytes) return report(bytes.error().message());
//     const auto map = wend::parse_map(*bytes, wend::stream_name(name));
//   }

#include <cstddef>
#include <filesystem>
#include <string>

#include "wend/base/expected.hpp"
#include "wend/io/io_error.hpp"
#include "wend/io/read_file.hpp"

namespace wend {

/// "-" or /dev/stdin: what the program is given as its input.
bool is_standard_input(const std::filesystem::path& file);

/// Standard input, an open file by its number (/dev/fd/63, as shells name `<(command)`), or a named
/// pipe.
bool is_stream(const std::filesystem::path& file);

/// As errors call it: "standard input", else the name.
std::string stream_name(const std::filesystem::path& file);

/// All bytes to the end of the stream. More than `largest` are an error, and so is a folder.
Expected<std::string, IoError> read_stream(const std::filesystem::path& file,
                                           std::size_t largest = kLargestFile);

}  // namespace wend
