#include "bench/plot/drive_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "bench/plot/plot_page.hpp"
#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

constexpr double kRoom = 1.06;  // of an axis, for what it shows

// In pixels.
constexpr double kDrivePanelHeight = 235;
constexpr double kDriveRow = 285;  // from one panel to the next
constexpr double kDriveBottom = 105;
constexpr double kDriveLeft = 125;
constexpr double kRight = 45;

/// A quantity over time.
struct Curve {
  std::string_view label;
  double (*value)(const DriveSample&);
};

// From the top.
constexpr std::array<Curve, 3> kCurves{{
    {"speed, m/s", [](const DriveSample& sample) { return sample.velocity.linear; }},
    {"heading error, degrees",
     [](const DriveSample& sample) { return degrees_from(sample.heading_error); }},
    {"cross-track error, m", [](const DriveSample& sample) { return sample.cross_track; }},
}};

/// From 0, or lower if values are negative.
PlotAxis axis_of(std::span<const ControlledDrive> drives, const Curve& curve) {
  double least = 0;
  double greatest = 0;
  for (const ControlledDrive& driven : drives) {
    for (const DriveSample& sample : driven.drive.samples) {
      least = std::min(least, curve.value(sample));
      greatest = std::max(greatest, curve.value(sample));
    }
  }
  if (least == greatest) greatest = 1;
  return {.label = std::string(curve.label), .least = least * kRoom, .greatest = greatest * kRoom};
}

PlotAxis time_axis(std::span<const ControlledDrive> drives) {
  double longest = 0;
  for (const ControlledDrive& driven : drives) longest = std::max(longest, driven.drive.time);
  return {.label = "", .greatest = longest > 0 ? longest : 1};
}

std::vector<std::string> names_of(std::span<const ControlledDrive> drives) {
  std::vector<std::string> names;
  for (const ControlledDrive& driven : drives) names.push_back(driven.controller);
  return names;
}

void put_data(PlotPage& page, std::size_t index, const Drive& drive) {
  page.put("$drive{} << END\n", index);
  for (const DriveSample& sample : drive.samples) {
    page.put("{}", sample.time);
    for (const Curve& curve : kCurves) page.put(" {}", curve.value(sample));
    page.put("\n");
  }
  page.put("END\n");
}

}  // namespace

std::string drive_plot(std::span<const ControlledDrive> drives, PlotKind kind,
                       const PlotColours& colours) {
  const auto below = static_cast<double>(kCurves.size() - 1);
  PlotPage page(kind, colours, names_of(drives),
                kDriveBottom + below * kDriveRow + kDrivePanelHeight);
  page.put_page();
  for (std::size_t i = 0; i < drives.size(); ++i) put_data(page, i, drives[i].drive);
  page.put("unset key\nset multiplot\nset xzeroaxis\n");
  for (std::size_t row = 0; row < kCurves.size(); ++row) {
    const bool last = row + 1 == kCurves.size();
    PlotAxis time = time_axis(drives);
    if (last) time.label = "time, s";
    const double bottom = kDriveBottom + static_cast<double>(kCurves.size() - 1 - row) * kDriveRow;
    page.put_panel({kDriveLeft, bottom, PlotPage::kWidth - kDriveLeft - kRight, kDrivePanelHeight},
                   time, axis_of(drives, kCurves[row]));
    if (row == 0) page.put_legend("Drives along the path");
    page.put("plot NaN notitle");
    for (std::size_t i = 0; i < drives.size(); ++i) {
      page.put(", \\\n  $drive{} using 1:{} with lines {} notitle", i, row + 2, page.line_look(i));
    }
    page.put("\nunset label\n");
  }
  page.put("unset multiplot\n");
  return page.take();
}

}  // namespace wend
