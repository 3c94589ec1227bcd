#pragma once

// Numbers as people read them in pictures and text grids.

#include <string>

#include "wend/map/grid.hpp"

namespace wend {

/// One number, short: "8321", "0.25", "1.25e6".
std::string short_number(double number);

/// The finite numbers of a grid with as many decimals as are needed, at most two: "0", "1.41".
class NumberText {
 public:
  explicit NumberText(const Grid<double>& numbers);

  std::string operator()(double number) const;

  /// How many characters the longest one takes; 0 if none is finite.
  int columns() const { return columns_; }

 private:
  int decimals_ = 0;
  int columns_ = 0;
};

}  // namespace wend
