// Numbers as text by the page's own functions: engine/number_text.ts. See wend/base/number_text.hpp.

#include "wend/base/number_text.hpp"

#include <array>
#include <cstddef>

#define WEND_LAB_IMPORT(name) __attribute__((import_module("lab"), import_name(#name)))

extern "C" {
/// Writes a number into `text`, of 48 bytes; returns the length. digits 0: the shortest text.
WEND_LAB_IMPORT(write_number) std::size_t lab_write_number(double value, int digits, char* text);
/// Reads a number into `value`. 0: it is one; 1: it is not; 2: it is one that a double does not hold.
WEND_LAB_IMPORT(read_number)
int lab_read_number(const char* text, std::size_t size, double* value);
}

namespace wend {

std::string shortest_text(double value) { return general_text(value, 0); }

std::string general_text(double value, int digits) {
  std::array<char, 48> text{};
  return {text.data(), lab_write_number(value, digits, text.data())};
}

std::errc read_number(std::string_view text, double& value) {
  switch (lab_read_number(text.data(), text.size(), &value)) {
    case 0:
      return std::errc{};
    case 1:
      return std::errc::invalid_argument;
    default:
      return std::errc::result_out_of_range;
  }
}

}  // namespace wend
