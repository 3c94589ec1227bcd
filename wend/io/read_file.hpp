#pragma once

// Reading a file whole. Only regular files: a folder, a pipe or a device such as /dev/zero is
// refused before it is opened, so that no loader waits or reads for ever.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "wend/base/expected.hpp"
#include "wend/io/io_error.hpp"

namespace wend {

/// Larger files are refused: the largest map with one byte a cell, and room for line ends.
inline constexpr std::size_t kLargestFile = std::size_t{3} << 30;

/// The bytes of `file`, at most `largest` of them.
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

}  // namespace wend
