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

}  // namespace

Expected<Path, PathFileError> load_path(const std::filesystem::path& file, const Frame& frame,
                                        PathStage stage) {
  const auto text = read_file(file, kLargestPathFile);
  if (!text) return Unexpected<PathFileError>(text.error());
  return parse_path(*text, file.string(), frame, stage);
}

Expected<Path, PathFileError> parse_path(std::string_view text, const std::string& name,
                                         const Frame& frame, PathStage stage) {
  try {
    return is_json(name, text) ? parse_path_json(text, name, frame, stage)
                               : parse_path_csv(text, name, frame);
  } catch (const std::bad_alloc&) {
    return file_failure(name, 0, "not enough memory for this path");
  }
}

}  // namespace wend
