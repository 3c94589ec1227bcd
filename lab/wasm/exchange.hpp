#pragma once

// How a module and the page talk. Text and arrays go in through a buffer; JSON and arrays come out as an address and a
// size. One Lab for each instance of the module, and so for each worker.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lab/wasm/lab.hpp"

#define WEND_LAB_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace wend::lab {

inline Lab& lab() {
  static Lab the_lab;
  return the_lab;
}

inline std::vector<std::uint64_t>& input() {  // aligned for every type that comes in
  static std::vector<std::uint64_t> buffer;
  return buffer;
}

inline std::string& output() {
  static std::string text;
  return text;
}

inline const std::uint8_t* input_bytes() {
  return reinterpret_cast<const std::uint8_t*>(input().data());
}

inline std::string_view input_text(std::size_t from, std::size_t size) {
  return {reinterpret_cast<const char*>(input().data()) + from, size};
}

}  // namespace wend::lab
