#include "wend/io/query/query_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "wend/io/files.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

/// Removes a quoted field from the beginning of the line and returns it.
Expected<std::string, Error> take_quoted(std::string_view& line) {
  std::string field;
  do {
    line.remove_prefix(1);
    const std::size_t end = line.find('"');
    if (end == std::string_view::npos) {
      return failure(Status::invalid_file, "unterminated quoted field");
    }
    field += line.substr(0, end);
    line.remove_prefix(end + 1);
    if (line.starts_with('"')) field += '"';
  } while (line.starts_with('"'));
  return field;
}

/// The fields of a line, or the error in its quotes.
Expected<std::vector<std::string>, Error> query_fields(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (;;) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    std::string quoted;
    const bool in_quotes = line.starts_with('"');
    if (in_quotes) {
      auto field = take_quoted(line);
      if (!field) return Unexpected<Error>(field.error());
      quoted = *std::move(field);
    }
    const std::size_t end = line.find(separator);
    const std::string_view plain = trimmed(line.substr(0, end));
    if (in_quotes && !plain.empty()) {
      return failure(Status::invalid_file, fmt::format("{} after a quoted field", quote(plain)));
    }
    fields.push_back(in_quotes ? std::move(quoted) : std::string(plain));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

/// The columns that make up one end of a query, in the order of "X,Y,HEADING".
using EndColumns = std::vector<std::size_t>;

class QueryHeader {
 public:
  /// Reads the header line. Returns an error text, empty on success.
  std::string read(std::string_view line) {
    separator_ = line.find(';') == std::string_view::npos ? ',' : ';';
    auto names = query_fields(line, separator_);
    if (!names) return names.error().message;
    names_ = *std::move(names);
    for (auto it = names_.begin(); it != names_.end(); ++it) {
      if (std::find(names_.begin(), it, *it) != it && is_of_query(*it)) {
        return fmt::format("duplicate column {}", quote(*it));
      }
    }
    for (const auto& [name, columns] : {std::pair{"start", &start_}, {"goal", &goal_}}) {
      std::string wrong = find_end(name, *columns);
      if (!wrong.empty()) return wrong;
    }
    return {};
  }

  QueryRow row(std::string_view line, std::size_t number) const {
    QueryRow row{number, {}, {}, {}};
    const auto fields = query_fields(line, separator_);
    if (!fields) {
      row.wrong = fields.error().message;
    } else if (fields->size() != names_.size()) {
      row.wrong =
          fmt::format("{} columns, expected {} as in the header", fields->size(), names_.size());
    } else {
      row.start = end_of(start_, *fields);
      row.goal = end_of(goal_, *fields);
    }
    return row;
  }

 private:
  static bool is_of_query(std::string_view name) {
    return name.starts_with("start") || name.starts_with("goal");
  }

  std::optional<std::size_t> column(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
  }

  std::string find_end(const std::string& name, EndColumns& columns) const {
    if (const auto whole = column(name)) {
      columns = {*whole};
      return {};
    }
    const auto x = column(name + "_x");
    const auto y = column(name + "_y");
    if (!x || !y) {
      return fmt::format("the first line must name the columns {0}_x and {0}_y, or {0}, not {1}",
                         name, quote(fmt::format("{}", fmt::join(names_, ","))));
    }
    columns = {*x, *y};
    if (const auto heading = column(name + "_heading")) columns.push_back(*heading);
    return {};
  }

  /// "1,1,E"; "1,1" without a heading.
  static std::string end_of(const EndColumns& columns, const std::vector<std::string>& fields) {
    std::string text;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::string& field = fields[columns[i]];
      if (i == 2 && field.empty()) break;
      text += (i == 0 ? "" : ",") + field;
    }
    return text;
  }

  char separator_ = ',';
  std::vector<std::string> names_;
  EndColumns start_;
  EndColumns goal_;
};

}  // namespace

Expected<std::vector<QueryRow>, Error> parse_query_csv(std::string_view text,
                                                       const std::string& file) {
  LineReader lines(text);
  QueryHeader header;
  const std::string wrong = header.read(lines.next().value_or(""));
  if (!wrong.empty()) return file_failure(file, 1, wrong);
  std::vector<QueryRow> rows;
  while (const auto line = lines.next()) {
    if (!is_blank(*line)) rows.push_back(header.row(*line, lines.number()));
  }
  return rows;
}

Expected<std::vector<QueryRow>, Error> load_query_csv(const std::filesystem::path& file) {
  const auto text = read_file(file, kLargestQueryFile);
  if (!text) return Unexpected<Error>(text.error());
  try {
    return parse_query_csv(*text, file.string());
  } catch (const std::bad_alloc&) {
    return file_failure(file.string(), 0, "not enough memory for these queries");
  }
}

}  // namespace wend
