// The JSON of Nav2's state lattice planner: load_primitives.hpp says what is in it.

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/io/primitives/load_primitives.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

using Json = nlohmann::json;

/// Reads values and keeps the first error.
class JsonReader {
 public:
  const std::string& wrong() const { return wrong_; }

  void complain(std::string what) {
    if (wrong_.empty()) wrong_ = std::move(what);
  }

  /// A member of an object; null with an error if it is missing.
  const Json& member(const Json& object, const char* key) {
    static const Json none;
    const auto found = object.is_object() ? object.find(key) : object.end();
    if (object.is_object() && found != object.end()) return *found;
    complain(fmt::format("'{}' is missing", key));
    return none;
  }

  double number(const Json& value, std::string_view what) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (!std::isfinite(number)) complain(fmt::format("{} is not a finite number", what));
    return std::isfinite(number) ? number : 0;
  }

  int index(const Json& object, const char* key) {
    const double value = number(member(object, key), fmt::format("'{}'", key));
    constexpr double kMost = 1e6;
    if (value == std::floor(value) && std::abs(value) <= kMost) return static_cast<int>(value);
    complain(fmt::format("'{}' is {}, not an index", key, format_number(value)));
    return 0;
  }

  const Json& list(const Json& object, const char* key) {
    const Json& value = member(object, key);
    if (!value.is_array()) complain(fmt::format("'{}' is not a list", key));
    return value;
  }

 private:
  std::string wrong_;
};

/// [x, y, heading] in metres.
Pose read_pose(JsonReader& reader, const Json& value, double resolution) {
  if (!value.is_array() || value.size() != 3) {
    reader.complain("a pose is not a list of three numbers");
    return {};
  }
  return {reader.number(value[0], "x of a pose") / resolution,
          reader.number(value[1], "y of a pose") / resolution,
          reader.number(value[2], "the heading of a pose")};
}

MotionPrimitive read_primitive(JsonReader& reader, const Json& value, double resolution,
                               const std::vector<double>& headings) {
  MotionPrimitive primitive;
  primitive.number = reader.index(value, "trajectory_id");
  primitive.from = reader.index(value, "start_angle_index");
  primitive.to = reader.index(value, "end_angle_index");
  const auto from = static_cast<std::size_t>(primitive.from);
  if (primitive.from < 0 || from >= headings.size()) {
    reader.complain(fmt::format("'start_angle_index' {} is not from 0 to {}", primitive.from,
                                headings.size() - 1));
    return primitive;
  }
  const Json& poses = reader.list(value, "poses");
  if (poses.size() > MotionPrimitives::kMostPoses) {
    reader.complain(
        fmt::format("{} poses, the most are {}", poses.size(), MotionPrimitives::kMostPoses));
  }
  if (!reader.wrong().empty()) return primitive;
  primitive.poses.push_back({0, 0, headings[from]});
  for (const Json& pose : poses) primitive.poses.push_back(read_pose(reader, pose, resolution));
  const Pose& last = primitive.poses.back();
  const double x = std::round(last.x);
  const double y = std::round(last.y);
  if (std::abs(x) > MotionPrimitives::kFarthest || std::abs(y) > MotionPrimitives::kFarthest) {
    reader.complain(
        fmt::format("it leads more than {} cells away", int{MotionPrimitives::kFarthest}));
    return primitive;
  }
  primitive.by = {static_cast<int>(x), static_cast<int>(y)};
  return primitive;
}

MotionPrimitives::Parts read_parts(JsonReader& reader, const Json& json) {
  MotionPrimitives::Parts parts;
  const Json& metadata = reader.member(json, "lattice_metadata");
  const double resolution =
      reader.number(reader.member(metadata, "grid_resolution"), "'grid_resolution'");
  if (reader.wrong().empty() && !(resolution > 0)) {
    reader.complain("'grid_resolution' must be above 0, in metres per cell");
  }
  const Json& headings = reader.list(metadata, "heading_angles");
  if (headings.size() > MotionPrimitives::kMostHeadings) reader.complain("too many headings");
  if (reader.wrong().empty() && headings.empty()) reader.complain("'heading_angles' is empty");
  const Json& primitives = reader.list(json, "primitives");
  if (!reader.wrong().empty()) return parts;
  parts.resolution = resolution;
  for (const Json& heading : headings) {
    parts.headings.push_back(reader.number(heading, "a heading"));
  }
  for (std::size_t i = 0; i < primitives.size() && reader.wrong().empty(); ++i) {
    JsonReader one;
    parts.primitives.push_back(read_primitive(one, primitives[i], resolution, parts.headings));
    if (!one.wrong().empty()) reader.complain(fmt::format("primitive {}: {}", i, one.wrong()));
  }
  return parts;
}

}  // namespace

Expected<MotionPrimitives, Error> parse_lattice_json(std::string_view text,
                                                     const std::string& name) {
  constexpr bool kNoExceptions = false;
  const Json json = Json::parse(without_byte_order_mark(text), nullptr, kNoExceptions);
  if (json.is_discarded()) return file_failure(name, 0, "the text is not valid JSON");
  JsonReader reader;
  MotionPrimitives::Parts parts = read_parts(reader, json);
  if (!reader.wrong().empty()) return file_failure(name, 0, reader.wrong());
  auto made = MotionPrimitives::make(std::move(parts));
  if (made) return *std::move(made);
  const Error& error = made.error();
  return file_failure(name, 0, (error.where.empty() ? "" : error.where + ": ") + error.message);
}

}  // namespace wend
