#include "wend/io/query/stop_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <optional>

#include "wend/base/parse.hpp"
#include "wend/io/files.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

std::vector<std::string> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t end = line.find(separator);
    fields.emplace_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

/// Rows of a file with a header, of which some columns are read.
class StopTable {
 public:
  StopTable(std::string_view text, const std::string& file) : lines_(text), file_(file) {
    const std::string_view header = lines_.next().value_or("");
    separator_ = header.find(';') == std::string_view::npos ? ',' : ';';
    names_ = fields_of(header, separator_);
  }

  std::optional<std::size_t> column(std::string_view name) const {
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
  }

  Error without_columns(const std::string& columns) const {
    return file_error(file_, 1,
                      fmt::format("the first line must name the columns {}, not {}", columns,
                                  quote(fmt::format("{}", fmt::join(names_, ",")))));
  }

  /// The fields of the next row that is not blank; nothing at the end.
  Expected<std::optional<std::vector<std::string>>, Error> next() {
    while (const auto line = lines_.next()) {
      if (is_blank(*line)) continue;
      auto fields = fields_of(*line, separator_);
      if (fields.size() == names_.size()) return fields;
      return Unexpected<Error>(error(
          fmt::format("{} columns, expected {} as in the header", fields.size(), names_.size())));
    }
    return std::nullopt;
  }

  /// About the row that was read last.
  Error error(const std::string& what) const { return file_error(file_, lines_.number(), what); }

 private:
  LineReader lines_;
  const std::string& file_;
  char separator_ = ',';
  std::vector<std::string> names_;
};

template <class Rows>
Expected<Rows, Error> loaded(const std::filesystem::path& file,
                             Expected<Rows, Error> (*parse)(std::string_view, const std::string&)) {
  const auto text = read_file(file, kLargestStopFile);
  if (!text) return Unexpected<Error>(text.error());
  try {
    return parse(*text, file.string());
  } catch (const std::bad_alloc&) {
    return file_failure(file.string(), 0, "not enough memory for these rows");
  }
}

}  // namespace

Expected<std::vector<std::string>, Error> parse_stop_csv(std::string_view text,
                                                         const std::string& file) {
  StopTable table(text, file);
  const auto x = table.column("x");
  const auto y = table.column("y");
  const auto heading = table.column("heading");
  if (!x || !y) return Unexpected<Error>(table.without_columns("x and y"));
  std::vector<std::string> stops;
  for (;;) {
    const auto row = table.next();
    if (!row) return Unexpected<Error>(row.error());
    if (!*row) return stops;
    const std::vector<std::string>& fields = **row;
    std::string& stop = stops.emplace_back(fields[*x] + "," + fields[*y]);
    if (heading && !fields[*heading].empty()) stop += "," + fields[*heading];
  }
}

Expected<std::vector<std::pair<int, int>>, Error> parse_stop_pair_csv(std::string_view text,
                                                                      const std::string& file) {
  StopTable table(text, file);
  const auto first = table.column("first");
  const auto second = table.column("second");
  if (!first || !second) return Unexpected<Error>(table.without_columns("first and second"));
  std::vector<std::pair<int, int>> pairs;
  for (;;) {
    const auto row = table.next();
    if (!row) return Unexpected<Error>(row.error());
    if (!*row) return pairs;
    const auto before = parse_integer<int>((**row)[*first]);
    const auto after = parse_integer<int>((**row)[*second]);
    if (!before || !after || *before < 0 || *after < 0) {
      return Unexpected<Error>(
          table.error("first and second must be rows of the stops, counted from 0"));
    }
    pairs.emplace_back(*before, *after);
  }
}

Expected<std::vector<std::string>, Error> load_stop_csv(const std::filesystem::path& file) {
  return loaded(file, parse_stop_csv);
}

Expected<std::vector<std::pair<int, int>>, Error> load_stop_pair_csv(
    const std::filesystem::path& file) {
  return loaded(file, parse_stop_pair_csv);
}

}  // namespace wend
