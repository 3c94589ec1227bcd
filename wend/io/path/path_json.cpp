
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "wend/io/path/load_path.hpp"
#include "wend/io/path/path_coordinates.hpp"

namespace wend {
namespace {

using Json = nlohmann::json;

/// A list of [x,y], and the errors in it.
struct PointList {
  std::vector<Point> points;
  std::string no_cell;  // the error if these are cells
  std::string no_pose;  // the error if these are poses or waypoints
};

/// Takes the paths and "headings" of a plan from the parser while it reads, without storing the document.
/// Only at the end is it known which numbers are valid coordinates: those of poses have fractions.
class PlanReader : public nlohmann::json_sax<Json> {
 public:
  PlanReader(std::string_view text, bool y_up, PathStage stage)
      : text_(text), y_up_(y_up), stage_(stage) {}

  bool null() override { return no_number("null"); }
  bool boolean(bool value) override {
    if (depth_ == 1 && key_ == "waypoints") has_waypoints_ = value;
    return no_number(value ? "true" : "false");
  }
  bool number_integer(number_integer_t value) override {
    const bool of_cell = may_be_coordinate_of_cell(value);
    return number(static_cast<double>(value), of_cell, std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    const bool of_cell = value < static_cast<number_unsigned_t>(kCoordinateEnd);
    return number(static_cast<double>(value), of_cell, std::to_string(value));
  }
  bool number_float(number_float_t value, const string_t& text) override {
    return number(value, false, text);
  }
  bool binary(binary_t&) override { return no_number("bytes"); }

  bool string(string_t& value) override {
    if (depth_ == 1 && key_ == "status") failed_.status = value;
    if (depth_ == 1 && key_ == "reason") failed_.reason = value;
    if (!in_list("headings", 2)) return no_number(value);
    const auto radians = radians_of_letter(value, y_up_);
    if (!radians) return no_number(value);
    headings_.push_back(*radians);
    return true;
  }

  bool start_object(std::size_t) override { return enter("{"); }
  bool end_object() override { return leave(); }

  bool key(string_t& name) override {
    if (depth_ != 1) return true;
    key_ = name;
    const bool known = is_path(name) || name == "headings" || name == "status";
    if (known && !seen_.insert(name).second)
      return complain(fmt::format("duplicate key '{}'", name));
    return true;
  }

  bool start_array(std::size_t) override {
    const bool wanted = in_points(1) || in_points(2) || in_list("headings", 1);
    if (!wanted || depth_ == 0) return enter("[");
    ++depth_;
    count_ = 0;
    return true;
  }

  bool end_array() override {
    if (in_points(3)) {
      if (count_ != 2) return complain(no_point(fmt::format("{} numbers", count_)));
      list().points.push_back(point_);
    }
    return leave();
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception&) override {
    line_ = line_at(position);
    return complain(position >= text_.size() ? "the JSON ends too early"
                                             : fmt::format("invalid JSON at {}", quote(token)));
  }

  Expected<Path, PathFileError> path(const std::string& file) {
    const bool smoothed = takes_smoothed();
    const PointList& wanted = smoothed ? smoothed_ : planned_;
    const bool driven = !smoothed && seen_.count("headings") > 0;
    const bool of_points = driven || smoothed || has_waypoints_;
    const std::string& fault = of_points ? wanted.no_pose : wanted.no_cell;
    // If the parser stopped early, headings could still have followed.
    const bool is_sure = wrong_.empty() || !wanted.no_pose.empty();
    if (is_sure && !fault.empty()) return file_failure(file, 0, fault);
    if (!wrong_.empty()) return file_failure(file, line_, wrong_);
    if (!failed_.status.empty() && failed_.status != "found") {
      return no_path_failure(file, failed_plan(failed_.status, failed_.reason));
    }
    const std::string_view name = smoothed ? kSmoothed : kPlanned;
    if (seen_.count(std::string(name)) == 0) {
      return file_failure(file, 0, "the key 'path' is missing, a list of [x,y]");
    }
    if (driven && headings_.size() != wanted.points.size()) {
      return file_failure(
          file, 0,
          fmt::format(
              "'headings' has {} entries, 'path' has {} points: expected one for each point",
              headings_.size(), wanted.points.size()));
    }
    if (wanted.points.empty()) {
      return file_failure(file, 0, fmt::format("'{}' is empty, expected at least one [x,y]", name));
    }
    if (smoothed || (has_waypoints_ && !driven)) return Path::along(wanted.points);
    return driven ? driven_path() : path_of_cells();
  }

 private:
  static constexpr const char* kNoPlan = "the top level must be an object with a list 'path'";
  static constexpr std::string_view kPlanned = "path";
  static constexpr std::string_view kSmoothed = "path_smoothed";

  static bool is_path(std::string_view name) { return name == kPlanned || name == kSmoothed; }

  bool takes_smoothed() const {
    const bool has_planned = seen_.count(std::string(kPlanned)) > 0;
    const bool has_smoothed = seen_.count(std::string(kSmoothed)) > 0;
    return has_smoothed && (stage_ == PathStage::smoothed || !has_planned);
  }

  /// The list that is being read.
  PointList& list() { return key_ == kSmoothed ? smoothed_ : planned_; }
  const PointList& list() const { return key_ == kSmoothed ? smoothed_ : planned_; }

  bool in_points(std::size_t depth) const { return depth_ == depth && is_path(key_); }

  /// Is the parser inside the value of this top-level key, at this depth? 1 is the value itself.
  bool in_list(std::string_view name, std::size_t depth) const {
    return depth_ == depth && key_ == name;
  }

  bool enter(const std::string& bracket) {
    if ((depth_ > 0 || bracket == "[") && !no_number(bracket)) return false;
    ++depth_;
    return true;
  }

  bool leave() {
    --depth_;
    return true;
  }

  bool complain(std::string what) {
    wrong_ = std::move(what);
    return false;
  }

  std::string no_point(const std::string& found) const {
    return fmt::format("{}[{}] must be [x,y], not {}", key_, list().points.size(), found);
  }

  bool number(double value, bool of_cell, const std::string& text) {
    if (in_list("headings", 2)) {
      if (!may_be_heading(value)) return no_number(text);
      headings_.push_back(value);
      return true;
    }
    if (!in_points(3)) return no_number(text);
    return coordinate(value, of_cell, may_be_coordinate_of_pose(value), text);
  }

  /// A value that is not a number: an error only where a number is expected.
  bool no_number(const std::string& found) {
    if (depth_ == 0) return complain(kNoPlan);
    if (in_points(1))
      return complain("'" + key_ + "' must be a list of [x,y], not " + quote(found));
    if (in_points(2)) return complain(no_point(quote(found)));
    if (in_points(3)) return coordinate(0, false, false, found);
    if (in_list("headings", 1)) return complain("'headings' must be a list, not " + quote(found));
    if (!in_list("headings", 2)) return true;
    return complain(wrong_heading(fmt::format("headings[{}]", headings_.size()), quote(found)));
  }

  bool coordinate(double value, bool of_cell, bool of_pose, const std::string& text) {
    PointList& points = list();
    const auto name = [&] { return fmt::format("{}[{}][{}]", key_, points.points.size(), count_); };
    if (!of_cell && points.no_cell.empty()) points.no_cell = wrong_coordinate(name(), quote(text));
    if (!of_pose && points.no_pose.empty()) {
      points.no_pose = wrong_pose_coordinate(name(), quote(text));
    }
    (count_ == 0 ? point_.x : point_.y) = value;
    ++count_;
    return true;
  }

  Path path_of_cells() const {
    Path path;
    for (const Point point : planned_.points) {
      path.append({static_cast<int>(point.x), static_cast<int>(point.y)});
    }
    return path;
  }

  Path driven_path() const {
    Path path;
    for (std::size_t i = 0; i < planned_.points.size(); ++i) {
      path.drive_to({planned_.points[i].x, planned_.points[i].y, headings_[i]});
    }
    return path;
  }

  /// The line of the byte where the parser stopped.
  std::size_t line_at(std::size_t position) const {
    const std::string_view before = text_.substr(0, position > 0 ? position - 1 : 0);
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  }

  std::string_view text_;
  bool y_up_;
  PathStage stage_;
  std::size_t depth_ = 0;  // lists and objects that are open
  std::string key_;        // the last one of the top level
  std::set<std::string> seen_;
  bool has_waypoints_ = false;
  FailedPlan failed_;  // where there is no path
  Point point_;
  std::size_t count_ = 0;  // coordinates of the point so far
  PointList planned_;
  PointList smoothed_;
  std::vector<double> headings_;
  std::string wrong_;  // an error for either kind, at which the parser stopped
  std::size_t line_ = 0;
};

}  // namespace

Expected<Path, PathFileError> parse_path_json(std::string_view text, const std::string& file,
                                              const Frame& frame, PathStage stage) {
  PlanReader reader(text, frame.y_up, stage);
  Json::sax_parse(text.begin(), text.end(), &reader);
  return reader.path(file);
}

}  // namespace wend
