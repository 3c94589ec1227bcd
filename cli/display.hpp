#pragma once

// Display: pictures that change, on standard output. On a terminal each takes the place of the one
// before; elsewhere they follow each other.

#include <string>

#include "terminal.hpp"

namespace wend::cli {

class Display {
 public:
  explicit Display(const Screen& screen);
  /// Shows the cursor again and leaves the last picture standing.
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// Lines of text, each with its end.
  void show(const std::string& picture);

 private:
  bool in_place_;
};

}  // namespace wend::cli
