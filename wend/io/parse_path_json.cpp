#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "wend/io/load_path.hpp"
#include "wend/io/path_cells.hpp"
#include "wend/io/quote.hpp"

namespace wend {
namespace {

using Json = nlohmann::json;

/// Takes the cells of a plan's "path" from the parser as it goes, without keeping the document.
class PlanReader : public nlohmann::json_sax<Json> {
 public:
  explicit PlanReader(std::string_view text) : text_(text) {}

  bool null() override { return no_number("null"); }
  bool boolean(bool value) override { return no_number(value ? "true" : "false"); }
  bool number_integer(number_integer_t value) override { return number(value); }
  bool number_unsigned(number_unsigned_t value) override {
    return value < static_cast<number_unsigned_t>(kCoordinateEnd)
               ? number(static_cast<number_integer_t>(value))
               : no_number(std::to_string(value));
  }
  bool number_float(number_float_t, const string_t& text) override { return no_number(text); }
  bool binary(binary_t&) override { return no_number("bytes"); }

  bool string(string_t& value) override {
    if (depth_ == 1 && key_ == "status") status_ = value;
    return no_number(value);
  }

  bool start_object(std::size_t) override {
    if (depth_ > 0 && !no_number("{")) return false;
    ++depth_;
    return true;
  }
  bool end_object() override { return leave(); }

  bool key(string_t& name) override {
    if (depth_ != 1) return true;
    key_ = name;
    const bool known = name == "path" || name == "status";
    if (known && !seen_.insert(name).second) return complain(fmt::format("two keys '{}'", name));
    return true;
  }

  bool start_array(std::size_t) override {
    if (depth_ == 0) return complain(kNoPlan);
    if (in_path() && depth_ == 3) return no_number("[");
    ++depth_;
    if (in_path() && depth_ == 2) has_path_ = true;
    if (in_path() && depth_ == 3) count_ = 0;
    return true;
  }

  bool end_array() override {
    if (in_path() && depth_ == 3) {
      if (count_ != 2) return complain(no_cell(fmt::format("{} numbers", count_)));
      cells_.push_back(cell_);
    }
    return leave();
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception&) override {
    line_ = line_at(position);
    return complain(position >= text_.size() ? "the JSON is cut short"
                                             : fmt::format("no JSON from {} on", quote(token)));
  }

  Expected<Path, IoError> path(const std::string& file) {
    if (!wrong_.empty()) return io_failure(file, line_, wrong_);
    if (!status_.empty() && status_ != "found") {
      return io_failure(file, 0,
                        fmt::format("there is no path: the plan's status is {}", quote(status_)));
    }
    if (!has_path_) return io_failure(file, 0, "'path' is missing, a list of cells [x,y]");
    if (cells_.empty()) return io_failure(file, 0, "'path' has no cells, at least one expected");
    return Path(std::move(cells_));
  }

 private:
  static constexpr const char* kNoPlan = "the top level must be an object, with a list 'path'";

  /// Inside of the value of "path": at depth 2 in its list, at 3 in one of its cells.
  bool in_path() const { return depth_ > 0 && key_ == "path"; }

  bool leave() {
    --depth_;
    return true;
  }

  bool complain(std::string what) {
    wrong_ = std::move(what);
    return false;
  }

  std::string no_cell(const std::string& found) const {
    return fmt::format("path[{}] must be a cell [x,y], not {}", cells_.size(), found);
  }

  bool number(number_integer_t value) {
    if (!in_path() || depth_ < 3) return no_number(std::to_string(value));
    if (value < 0 || value >= kCoordinateEnd) return no_number(std::to_string(value));
    (count_ == 0 ? cell_.x : cell_.y) = static_cast<int>(value);
    ++count_;
    return true;
  }

  /// A value that is no coordinate: fine but where one belongs.
  bool no_number(const std::string& found) {
    if (depth_ == 0) return complain(kNoPlan);
    if (!in_path()) return true;
    if (depth_ == 1) return complain("'path' must be a list of cells [x,y], not " + quote(found));
    if (depth_ == 2) return complain(no_cell(quote(found)));
    const std::string name = fmt::format("path[{}][{}]", cells_.size(), count_);
    return complain(wrong_coordinate(name, quote(found)));
  }

  /// The line of the byte that the parser stopped at.
  std::size_t line_at(std::size_t position) const {
    const std::string_view before = text_.substr(0, position > 0 ? position - 1 : 0);
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  }

  std::string_view text_;
  std::size_t depth_ = 0;  // lists and objects that are open
  std::string key_;        // the last one of the top level
  std::set<std::string> seen_;
  std::string status_;
  bool has_path_ = false;
  Cell cell_;
  std::size_t count_ = 0;  // coordinates of the cell so far
  std::vector<Cell> cells_;
  std::string wrong_;
  std::size_t line_ = 0;
};

}  // namespace

Expected<Path, IoError> parse_path_json(std::string_view text, const std::string& file) {
  PlanReader reader(text);
  Json::sax_parse(text.begin(), text.end(), &reader);
  return reader.path(file);
}

}  // namespace wend
