#include "wend/report/drive_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "wend/geometry/angle.hpp"
#include "wend/report/json.hpp"
#include "wend/report/text_table.hpp"

namespace wend {
namespace {

/// A measure for the comparison of drives.
struct DriveMeasure {
  std::string_view title;
  std::string_view unit;
  int decimals;
  double (*value)(const Drive&);
  std::string_view heading;  // of its column in a comparison; empty: no column
};

constexpr std::array<DriveMeasure, 8> kDriveMeasures{{
    {"time", "s", 2, [](const Drive& drive) { return drive.time; }, "time\ns"},
    {"distance", "m", 2, [](const Drive& drive) { return drive.distance; }, "driven\nm"},
    {"turned", "degrees", 0, [](const Drive& drive) { return degrees_from(drive.turned); },
     "turned\ndeg"},
    {"rms cross-track", "m", 3, [](const Drive& drive) { return drive.cross_track_rms; },
     "cross-\ntrack\nrms m"},
    {"largest cross-track", "m", 3, [](const Drive& drive) { return drive.cross_track_largest; },
     "cross-\ntrack\nmax m"},
    {"final error", "m", 3, [](const Drive& drive) { return drive.final_error; }, ""},
    {"final heading error", "degrees", 1,
     [](const Drive& drive) { return degrees_from(std::abs(drive.final_heading_error)); }, ""},
    {"collisions", "", 0, [](const Drive& drive) { return static_cast<double>(drive.collisions); },
     "hits"},
}};

bool reached(const Drive& drive) { return drive.outcome == DriveOutcome::reached; }

std::string table_of_one(const ControlledDrive& driven) {
  TextTable table({{""}, {""}});
  table.add({"controller", driven.controller});
  table.add({"outcome", std::string(describe(driven.drive.outcome))});
  for (const DriveMeasure& measure : kDriveMeasures) {
    const std::string number =
        fmt::format("{:.{}f}", measure.value(driven.drive), measure.decimals);
    table.add({std::string(measure.title),
               measure.unit.empty() ? number : fmt::format("{} {}", number, measure.unit)});
  }
  const std::string text = table.text();
  return text.substr(text.find('\n') + 1);  // no titles
}

/// The heading of a column, with room for marks if the column has any.
std::string heading_of(const DriveMeasure& measure, bool marked) {
  const std::string end = marked ? " " : "";
  std::string lines;
  for (const char letter : measure.heading) {
    if (letter == '\n') lines += end;
    lines += letter;
  }
  return lines + end;
}

struct MarkedColumn {
  std::string title;
  std::vector<std::string> fields;
};

MarkedColumn column_of(std::span<const ControlledDrive> drives, const DriveMeasure& measure,
                       bool& any_mark) {
  std::vector<double> competing;
  for (const ControlledDrive& driven : drives) {
    competing.push_back(reached(driven.drive) ? measure.value(driven.drive) : std::nan(""));
  }
  const std::vector<bool> best = best_of(competing, false);
  const bool marked = std::ranges::find(best, true) != best.end();
  any_mark = any_mark || marked;
  MarkedColumn column{heading_of(measure, marked), {}};
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const char* const mark = !marked ? "" : best[i] ? "*" : " ";
    column.fields.push_back(
        fmt::format("{:.{}f}{}", measure.value(drives[i].drive), measure.decimals, mark));
  }
  return column;
}

std::string table_of_many(std::span<const ControlledDrive> drives, std::size_t width) {
  bool marked = false;
  constexpr std::size_t kLongestName = 16;
  std::vector<TextTable::Column> titles{{"controller", Align::left, kLongestName}, {"outcome"}};
  std::vector<MarkedColumn> columns;
  for (const DriveMeasure& measure : kDriveMeasures) {
    if (measure.heading.empty()) continue;
    columns.push_back(column_of(drives, measure, marked));
    titles.push_back({columns.back().title, Align::right});
  }
  TextTable table(std::move(titles));
  for (std::size_t i = 0; i < drives.size(); ++i) {
    std::vector<std::string> fields{drives[i].controller,
                                    std::string(choice_name(drives[i].drive.outcome))};
    for (const MarkedColumn& column : columns) fields.push_back(column.fields[i]);
    table.add(std::move(fields));
  }
  return table.text(width) + (marked ? "* best of those that reached the goal\n" : "");
}

Json json_of(const std::vector<DriveSample>& samples, const Frame& frame) {
  const auto column = [&samples](const auto& value) {
    Json numbers = Json::array();
    for (const DriveSample& sample : samples) numbers.push_back(value(sample));
    return numbers;
  };
  const auto pose = [&frame](const DriveSample& sample) { return frame.to_metres(sample.pose); };
  using Sample = const DriveSample&;
  return {{"time_s", column([](Sample sample) { return sample.time; })},
          {"x_m", column([&](Sample sample) { return pose(sample).x; })},
          {"y_m", column([&](Sample sample) { return pose(sample).y; })},
          {"yaw", column([&](Sample sample) { return pose(sample).heading; })},
          {"linear_m_s", column([](Sample sample) { return sample.velocity.linear; })},
          {"angular_rad_s", column([](Sample sample) { return sample.velocity.angular; })},
          {"heading_error_degrees",
           column([](Sample sample) { return degrees_from(sample.heading_error); })},
          {"cross_track_m", column([](Sample sample) { return sample.cross_track; })}};
}

Json json_of(const ControlledDrive& driven, const Frame& frame, DriveSamples samples) {
  const Drive& drive = driven.drive;
  Json json{{"controller", driven.controller},
            {"outcome", choice_name(drive.outcome)},
            {"time_s", drive.time},
            {"distance_m", drive.distance},
            {"turned_degrees", degrees_from(drive.turned)},
            {"cross_track_rms_m", drive.cross_track_rms},
            {"cross_track_largest_m", drive.cross_track_largest},
            {"final_error_m", drive.final_error},
            {"final_heading_error_degrees", degrees_from(drive.final_heading_error)},
            {"swings", drive.swings},
            {"collisions", drive.collisions},
            {"first_collision", Json()},
            {"first_collision_m", Json()}};
  if (drive.first_collision) {
    json["first_collision"] = json_of(*drive.first_collision);
    json["first_collision_m"] = json_of_fractions(frame.to_metres(*drive.first_collision));
  }
  if (samples == DriveSamples::all) json["samples"] = json_of(drive.samples, frame);
  return json;
}

}  // namespace

std::string drive_table(std::span<const ControlledDrive> drives, std::size_t width) {
  return drives.size() == 1 ? table_of_one(drives.front()) : table_of_many(drives, width);
}

std::string drive_csv(std::span<const ControlledDrive> drives, const Frame& frame) {
  std::string text =
      "controller,time_s,x_m,y_m,yaw,linear_m_s,angular_rad_s,heading_error_rad,cross_track_m\n";
  for (const ControlledDrive& driven : drives) {
    const std::string name = csv_field(driven.controller);
    for (const DriveSample& sample : driven.drive.samples) {
      const MapPose pose = frame.to_metres(sample.pose);
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n", name, sample.time,
                     pose.x, pose.y, pose.heading, sample.velocity.linear, sample.velocity.angular,
                     sample.heading_error, sample.cross_track);
    }
  }
  return text;
}

std::string drive_json(const RefinedPath& path, std::span<const ControlledDrive> drives,
                       const Frame& frame, DriveSamples samples) {
  Json json;
  put_paths(json, path, frame);
  json["drives"] = Json::array();
  for (const ControlledDrive& driven : drives) {
    json["drives"].push_back(json_of(driven, frame, samples));
  }
  return text_of(json);
}

}  // namespace wend
