#include "wend/io/load_path.hpp"

#include <new>

#include "wend/io/lower_case.hpp"
#include "wend/io/read_file.hpp"

namespace wend {
namespace {

constexpr std::size_t kLargestPathFile = std::size_t{256} << 20;

bool is_json(const std::filesystem::path& file, std::string_view text) {
  const std::string extension = lower_case(file.extension().string());
  if (extension == ".json" || extension == ".csv") return extension == ".json";
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

}  // namespace

Expected<Path, IoError> load_path(const std::filesystem::path& file, const Frame& frame,
                                  PathStage stage) {
  try {
    const auto text = read_file(file, kLargestPathFile);
    if (!text) return Unexpected<IoError>(text.error());
    return is_json(file, *text) ? parse_path_json(*text, file.string(), frame, stage)
                                : parse_path_csv(*text, file.string(), frame);
  } catch (const std::bad_alloc&) {
    return io_failure(file.string(), 0, "not enough memory for this path");
  }
}

}  // namespace wend
