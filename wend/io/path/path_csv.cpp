#include "wend/io/path/path_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "wend/base/parse.hpp"
#include "wend/geometry/heading.hpp"
#include "wend/io/files.hpp"

namespace wend {
namespace {

std::string cells_csv(const Path& path, const Frame& frame) {
  std::string text(kPathCsvHeader);
  text += '\n';
  for (const Cell cell : path.cells()) {
    const Point metres = frame.to_metres(centre_of(cell));
    fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", cell.x, cell.y,
                   format_number(metres.x), format_number(metres.y));
  }
  return text;
}

std::string heading_text(double radians, bool y_up) {
  const auto heading = exact_heading(radians, y_up);
  return heading ? std::string(to_string(*heading)) : format_number(radians);
}

std::string poses_csv(const Path& path, const Frame& frame) {
  std::string text(kDrivenPathCsvHeader);
  text += '\n';
  for (const Pose& pose : path.poses()) {
    const Pose metres = frame.to_metres(pose);
    // {fmt} writes the shortest text too, and a million not as 1e+06.
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", pose.x, pose.y,
                   heading_text(pose.heading, frame.y_up), format_number(metres.x),
                   format_number(metres.y), format_number(metres.heading));
  }
  return text;
}

std::string waypoints_csv(const Path& path, const Frame& frame) {
  std::string text(kWaypointCsvHeader);
  text += '\n';
  for (const Pose& pose : path.poses()) {
    const Pose metres = frame.to_metres(pose);
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", pose.x, pose.y,
                   format_number(metres.x), format_number(metres.y), format_number(metres.heading));
  }
  return text;
}

}  // namespace

std::string path_csv(const Path& path, const Frame& frame) {
  if (path.driven()) return poses_csv(path, frame);
  return path.waypoints().empty() ? cells_csv(path, frame) : waypoints_csv(path, frame);
}

std::string no_path_csv(const FailedPlan& plan) {
  std::string comment = fmt::format("{}{}: {}", kNoPathComment, plan.status, plan.reason);
  std::replace_if(
      comment.begin(), comment.end(), [](char letter) { return letter == '\n' || letter == '\r'; },
      ' ');
  return fmt::format("{}\n{}\n", comment, kPathCsvHeader);
}

Expected<void, IoError> save_path_csv(const Path& path, const Frame& frame,
                                      const std::filesystem::path& file) {
  return write_file(file, path_csv(path, frame));
}

}  // namespace wend
