#pragma once

// Display: pictures that change, on standard output. On a terminal each may take the place of the
// one before; elsewhere they follow each other.

#include <string>

namespace wend::cli {

class Display {
 public:
  /// In place: each picture takes the place of the one before.
  explicit Display(bool in_place);
  /// Shows the cursor again and leaves the last picture standing.
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// Lines of text, each with its end.
  void show(const std::string& picture);

  /// Takes the last picture away, where it is to stand in place.
  void clear();

  bool in_place() const { return in_place_; }

 private:
  bool in_place_;
};

}  // namespace wend::cli
