#include "wend/io/primitives/load_primitives.hpp"

#include <new>

#include "wend/io/files.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

bool begins_with_brace(std::string_view text) {
  text = without_byte_order_mark(text);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

}  // namespace

Expected<MotionPrimitives, Error> load_primitives(const std::filesystem::path& file) {
  const auto text = read_file(file, kLargestPrimitivesFile);
  if (!text) return Unexpected<Error>(text.error());
  return parse_primitives(*text, file.string());
}

Expected<MotionPrimitives, Error> parse_primitives(std::string_view text, const std::string& name) {
  try {
    return begins_with_brace(text) ? parse_lattice_json(text, name) : parse_mprim(text, name);
  } catch (const std::bad_alloc&) {
    return file_failure(name, 0, "not enough memory for the motion primitives");
  }
}

}  // namespace wend
