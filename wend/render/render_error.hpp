#pragma once

// RenderError: which picture could not be written, and why.

#include <string>

namespace wend {

struct RenderError {
  std::string file;
  std::string what;  // "No such file or directory"

  /// "out/plan.png: No such file or directory"
  std::string message() const { return file + ": " + what; }
};

}  // namespace wend
