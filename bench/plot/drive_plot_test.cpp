#include "bench/plot/drive_plot.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "wend/geometry/angle.hpp"

namespace wend {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

ControlledDrive drive_of(std::string controller, double time) {
  Drive drive;
  drive.samples = {{0, {1, 1, 0}, {0, 0}, 0, 0},
                   {time, {3, 1, kPi / 2}, {0.5, -1}, kPi / 2, -0.25}};
  return {std::move(controller), std::move(drive)};
}

TEST(DrivePlot, HasAPanelForEachErrorAndALineForEachController) {
  const std::vector<ControlledDrive> drives{drive_of("p", 12), drive_of("pid", 3),
                                            drive_of("pure_pursuit", 10)};
  const std::string script = drive_plot(drives, PlotKind::svg);
  EXPECT_THAT(script, StartsWith("set encoding utf8\nset terminal svg "));
  for (const char* label : {"'speed, m/s'", "'heading error, degrees'", "'cross-track error, m'",
                            "'time, s'", "'pure_pursuit'"}) {
    EXPECT_THAT(script, HasSubstr(label));
  }
  EXPECT_THAT(script, HasSubstr("$drive1 << END\n0 0 0 0\n3 0.5 90 -0.25\nEND\n"));
  EXPECT_THAT(script, HasSubstr("$drive2 using 1:4 with lines"));
  EXPECT_THAT(script, Not(HasSubstr("$drive3")));
}

}  // namespace
}  // namespace wend
