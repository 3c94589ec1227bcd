#pragma once

// Reading and writing whole files, standard input and pipes; opening indexes.
//
// Loaders that take a file name read only regular files. They reject a folder, a pipe or a device such
// as /dev/zero before it is opened, so that no loader waits or reads for ever. Streams, which can be read
// only once and in order, have their own functions:
//
//   if (wend::is_stream(name)) {
//     const auto bytes = wend::read_stream(name);
//     if (!bytes) return report(bytes.error().message);
//     const auto map = wend::parse_map(*bytes, wend::stream_name(name));
//   }

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/io/file_error.hpp"

namespace wend {

/// Larger files are rejected. Holds the largest map with one byte a cell, and room for line ends.
inline constexpr std::size_t kLargestFile = std::size_t{3} << 30;

/// The bytes of `file`, at most `largest` of them. Also fails if there is not enough memory.
WEND_API Expected<std::string, Error> read_file(const std::filesystem::path& file,
                                                std::size_t largest = kLargestFile);

/// A file read piece by piece, for files that are larger than the data made from them.
class WEND_API FilePieces {
 public:
  /// Fails with the errors of read_file().
  static Expected<FilePieces, Error> open(const std::filesystem::path& file,
                                          std::size_t largest = kLargestFile);

  /// The size of the file in bytes, when it was opened.
  std::size_t size() const { return size_; }

  /// The next bytes, valid until the next call. None at the end of the file or after a read error; in
  /// the second case failed() is true.
  std::string_view next();
  /// Reads the next bytes into a room, and returns how many there were.
  std::size_t read(std::span<char> room);
  /// Did a read fail?
  bool failed() const { return stream_.bad(); }

 private:
  FilePieces(std::ifstream stream, std::size_t size);

  std::ifstream stream_;
  std::size_t size_;
  std::string piece_;
};

/// Is the file standard input: "-" or /dev/stdin?
WEND_API bool is_standard_input(const std::filesystem::path& file);

/// Is the file standard input, an open file by its number (/dev/fd/63, as shells name `<(command)`), or
/// a named pipe?
WEND_API bool is_stream(const std::filesystem::path& file);

/// The name of a stream in error messages: "standard input", or the name of its file.
WEND_API std::string stream_name(const std::filesystem::path& file);

/// All bytes to the end of the stream. More than `largest` are an error, and so is a folder.
WEND_API Expected<std::string, Error> read_stream(const std::filesystem::path& file,
                                                  std::size_t largest = kLargestFile);

/// Writes a file atomically: the bytes go into a temporary file beside it, which takes its name when they are on the
/// disk. If writing fails, or the program is ended meanwhile by Ctrl-C, kill or a loss of power, the old file stays: on
/// Linux the temporary file has no name until it is complete (O_TMPFILE), if the file system allows that, and then one
/// that cannot be guessed. The new file has the permissions of the old one, and its owner where that is allowed. A
/// symbolic link stays one: its target is replaced, or made. A file that is not regular (a pipe, /dev/stdout) is
/// written directly.
WEND_API Expected<void, Error> write_file(const std::filesystem::path& file,
                                          std::string_view bytes);
/// The same for an index.
WEND_API Expected<void, Error> write_index(const std::filesystem::path& file,
                                           const IndexBytes& index);

/// Reads an index into memory, so that nobody who writes to the file later harms its users. The reader of the
/// bytes checks whether they are an index, and of what: one that was written to while it was read has a wrong
/// checksum. Also fails if there is not enough memory. O(bytes).
WEND_API Expected<IndexBytes, Error> open_index(const std::filesystem::path& file);

}  // namespace wend
