#pragma once

// What the readers of paths as CSV share: the columns of a line.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/expected.hpp"

namespace wend {

/// The columns of lines that all have the same ones. Its memory is kept from line to line.
class PathColumns {
 public:
  /// `header` names them; its text must outlive this. Blanks around names and values do not count if
  /// `trims`.
  PathColumns(std::string_view header, char separator, bool trims);

  std::size_t count() const { return names_.size(); }
  std::string_view name(std::size_t column) const { return names_[column]; }

  /// Takes up a line; what is wrong if it has more or fewer columns.
  Expected<void, std::string> read(std::string_view line);

  /// Of the line taken up last.
  std::string_view operator[](std::size_t column) const { return texts_[column]; }

  /// Complains about the first column from `first` on that holds no finite number.
  Expected<void, std::string> check_numbers(std::size_t first) const;

 private:
  void split(std::string_view line, std::vector<std::string_view>& parts) const;

  std::string header_;
  char separator_;
  bool trims_;
  std::vector<std::string_view> names_;
  std::vector<std::string_view> texts_;
};

}  // namespace wend
