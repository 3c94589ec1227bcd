#pragma once

// Reading and writing whole files, standard input and pipes; mapping the files of indexes.
//
// Loaders that take the name of a file read only regular files: a folder, a pipe or a device such as
// /dev/zero is refused before it is opened, so that no loader waits or reads for ever. What can be read
// only once, from front to end, has functions of its own:
//
//   if (wend::is_stream(name)) {
//     const auto bytes = wend::read_stream(name);
//     if (!bytes) return report(bytes.error().message());
//     const auto map = wend::parse_map(*bytes, wend::stream_name(name));
//   }

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/io/io_error.hpp"

namespace wend {

/// Larger files are refused: the largest map with one byte a cell, and room for line ends.
inline constexpr std::size_t kLargestFile = std::size_t{3} << 30;

/// The bytes of `file`, at most `largest` of them; an error too if memory does not suffice.
Expected<std::string, IoError> read_file(const std::filesystem::path& file,
                                         std::size_t largest = kLargestFile);

/// A file read piece by piece, for what is larger than the memory it becomes.
class FilePieces {
 public:
  /// The errors of read_file().
  static Expected<FilePieces, IoError> open(const std::filesystem::path& file,
                                            std::size_t largest = kLargestFile);

  std::size_t size() const { return size_; }

  /// The next bytes, valid until the call after; none at the end of the file, and where it cannot
  /// be read further: then failed().
  std::string_view next();
  bool failed() const { return stream_.bad(); }

 private:
  FilePieces(std::ifstream stream, std::size_t size);

  std::ifstream stream_;
  std::size_t size_;
  std::string piece_;
};

/// "-" or /dev/stdin: what the program is given as its input.
bool is_standard_input(const std::filesystem::path& file);

/// Standard input, an open file by its number (/dev/fd/63, as shells name `<(command)`), or a named
/// pipe.
bool is_stream(const std::filesystem::path& file);

/// The name of a stream in error messages: "standard input", or the name of its file.
std::string stream_name(const std::filesystem::path& file);

/// All bytes to the end of the stream. More than `largest` are an error, and so is a folder.
Expected<std::string, IoError> read_stream(const std::filesystem::path& file,
                                           std::size_t largest = kLargestFile);

/// Writes a file whole or not at all: the bytes go into a temporary file beside it, which then takes its
/// name. A failure leaves what was there before, and so does a program that ends meanwhile, by Ctrl-C or
/// by kill: on Linux the temporary file has no name until it is whole (O_TMPFILE), where the file system
/// allows that. A symbolic link stays one: its target is replaced. What is not a regular file (a pipe,
/// /dev/stdout) is written directly.
Expected<void, IoError> write_file(const std::filesystem::path& file, std::string_view bytes);
Expected<void, IoError> write_index(const std::filesystem::path& file, const IndexBytes& index);

/// Maps an index: what a query does not touch is not read, and programs share the memory. Its reader says
/// whether it is an index, and of what. The file must not be written to while it is open; a new one that
/// takes its name does no harm.
Expected<IndexBytes, IoError> open_index(const std::filesystem::path& file);

}  // namespace wend
