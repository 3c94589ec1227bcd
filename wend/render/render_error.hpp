#pragma once

// RenderError: why a picture could not be drawn.

#include <string>

namespace wend {

struct RenderError {
  std::string what;  // "out of memory"

  const std::string& message() const { return what; }
};

}  // namespace wend
