#include "wend/io/path_csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "wend/base/parse.hpp"
#include "wend/io/write_file.hpp"

namespace wend {

std::string path_csv(const Path& path, const Frame& frame) {
  std::string text(kPathCsvHeader);
  text += '\n';
  for (const Cell cell : path.cells()) {
    const Point metres = frame.to_metres(centre_of(cell));
    fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", cell.x, cell.y,
                   format_number(metres.x), format_number(metres.y));
  }
  return text;
}

Expected<void, IoError> save_path_csv(const Path& path, const Frame& frame,
                                      const std::filesystem::path& file) {
  return write_file(file, path_csv(path, frame));
}

}  // namespace wend
