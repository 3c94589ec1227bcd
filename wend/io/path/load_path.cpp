#include "wend/io/path/load_path.hpp"

#include <new>

#include "wend/io/files.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

bool is_json(const std::filesystem::path& file, std::string_view text) {
  const std::string extension = lower_case(file.extension().string());
  if (extension == ".json" || extension == ".csv") return extension == ".json";
  text = without_byte_order_mark(text);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

Expected<Path, IoError> parse(const std::filesystem::path& file, std::string_view text,
                              const Frame& frame, PathStage stage) {
  return is_json(file, text) ? parse_path_json(text, file.string(), frame, stage)
                             : parse_path_csv(text, file.string(), frame);
}

}  // namespace

Expected<Path, IoError> load_path(const std::filesystem::path& file, const Frame& frame,
                                  PathStage stage) {
  try {
    const auto text = read_file(file, kLargestPathFile);
    if (!text) return Unexpected<IoError>(text.error());
    return parse(file, *text, frame, stage);
  } catch (const std::bad_alloc&) {
    return io_failure(file.string(), 0, "not enough memory for this path");
  }
}

Expected<Path, IoError> parse_path(std::string_view text, const std::string& name,
                                   const Frame& frame, PathStage stage) {
  try {
    return parse(name, text, frame, stage);
  } catch (const std::bad_alloc&) {
    return io_failure(name, 0, "not enough memory for this path");
  }
}

}  // namespace wend
