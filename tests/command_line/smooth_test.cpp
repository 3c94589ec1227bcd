// `wend smooth`, and `wend plan --simplify --smooth --resample`, from outside.

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/command_line/corridor_grid.hpp"
#include "tests/command_line/run_program.hpp"

namespace wend::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class SmoothCommand : public testing::Test {
 protected:
  Outcome smooth(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"smooth", map_, plan_});
    return wend(std::move(more));
  }

  Outcome plan(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"plan", map_, "--start", "0,0", "--goal", "9,4"});
    return wend(std::move(more));
  }

  TemporaryFolder folder_;
  std::string map_ = folder_.write("grid.txt", kCorridorGrid);
  std::string plan_ = folder_.write(
      "plan.csv",
      "x,y,x_m,y_m\n0,0,0,0\n1,0,0,0\n2,0,0,0\n3,0,0,0\n4,0,0,0\n5,0,0,0\n6,1,0,0\n7,2,0,0\n"
      "8,2,0,0\n9,3,0,0\n9,4,0,0\n");
};

TEST_F(SmoothCommand, ShowsThePathBeforeAndAfter) {
  const Outcome outcome = smooth();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("○ planned   ● smoothed"),
                    HasSubstr("planned  smoothed\npoints                               "
                              "11        11\n"),
                    HasSubstr("smoother  gradient\n"), HasSubstr("held      ")));
}

/// Of a path that is not free, the written file says why: that must not replace the path.
TEST_F(SmoothCommand, NeverWritesOverItsOwnPath) {
  const std::string before = bytes_of(plan_);
  for (const std::string& output : {plan_, (folder_ / "./plan.csv").string()}) {
    const Outcome refused = smooth({"-o", output});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("this file is also an input and would be overwritten"));
    EXPECT_THAT(refused.out, IsEmpty());
  }
  EXPECT_EQ(bytes_of(plan_), before);
}

TEST_F(SmoothCommand, SaysHowCornersAreRounded) {
  EXPECT_THAT(smooth().out, AllOf(HasSubstr("smallest turning radius, cells     0.00      0.00\n"),
                                  HasSubstr("  corners rounded by 0.1 cells   ")));
  const auto rounded = [&](const std::string& window) {
    return json::parse(
               smooth({"--smoother", "none", "--corner-rounding", window, "--format", "json"}).out)
        .at("path_metrics")
        .at("rounded_turning_radius_cells")
        .get<double>();
  };
  EXPECT_EQ(rounded("0"), 0);
  EXPECT_GT(rounded("0.1"), rounded("0.05"));
  EXPECT_THAT(wend({"check", map_, plan_, "--corner-rounding", "0.25"}).out,
              HasSubstr("  corners rounded by 0.25 cells  "));
}

TEST_F(SmoothCommand, BoundsTheTurningRadiusOfPlansToo) {
  const Outcome outcome =
      plan({"--smoother", "curvature", "--turning-radius", "0.5", "--format", "json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json found = json::parse(outcome.out);
  EXPECT_EQ(found.at("smoothing").at("within_bound"), true);
  EXPECT_GE(found.at("path_smoothed_metrics").at("rounded_turning_radius_cells"), 0.4999);
  EXPECT_EQ(json::parse(plan({"--smoother", "curvature:radius=0.5", "--format", "json"}).out)
                .at("path_smoothed"),
            found.at("path_smoothed"))
      << "the old name, in cells";
  EXPECT_THAT(plan({"--turning-radius", "0.5"}).err, HasSubstr("--planner car or --smoother"));
  EXPECT_THAT(plan({"--smooth", "--turning-radius", "0.5"}).err, HasSubstr("--smoother curvature"));
}

TEST_F(SmoothCommand, WritesAFreePathThatReadsBackAndIsShorter) {
  const std::string csv = folder_ / "smooth.csv";
  const std::string file = folder_ / "smooth.json";
  ASSERT_EQ(smooth({"-o", csv, "-o", file, "-o", folder_ / "smooth.svg"}).code, 0);
  EXPECT_THAT(bytes_of(csv), StartsWith("x_grid,y_grid,x_m,y_m,yaw\n0.5,0.5,0.5,0.5,"));
  const json checked = json::parse(wend({"check", map_, csv, "--format", "json"}).out);
  EXPECT_EQ(checked.at("free"), true);
  const json written = json::parse(bytes_of(file));
  EXPECT_EQ(checked.at("metrics"), written.at("path_smoothed_metrics"));
  EXPECT_LT(checked.at("metrics").at("length_cells"),
            written.at("path_metrics").at("length_cells"));
  EXPECT_EQ(json::parse(wend({"check", map_, file, "--format", "json"}).out), checked);
}

TEST_F(SmoothCommand, TakesTheOptionsOfTheSmoother) {
  const std::string held = smooth({"--beta", "0", "--format", "json"}).out;
  EXPECT_EQ(json::parse(held).at("path_smoothed").at(5), json::parse("[5.5,0.5]"));
  EXPECT_THAT(smooth({"--alpha", "1", "--beta", "1"}).err, HasSubstr("diverge"));
  EXPECT_EQ(smooth({"--alpha", "1", "--beta", "1"}).code, 2);
  EXPECT_EQ(smooth({"--alpha", "-1"}).code, 2);
  EXPECT_EQ(json::parse(smooth({"--max-sweeps", "1", "--format", "json"}).out)
                .at("smoothing")
                .at("converged"),
            false);
}

TEST_F(SmoothCommand, SimplifiesAndResamplesWithoutSmoothing) {
  const json taut =
      json::parse(smooth({"--smoother", "none", "--simplify", "--format", "json"}).out);
  EXPECT_TRUE(taut.at("smoothing").is_null());
  EXPECT_LT(taut.at("path_smoothed").size(), 6U);
  const json collinear =
      json::parse(smooth({"--smoother", "none", "--simplify=collinear", "--format", "json"}).out);
  EXPECT_EQ(collinear.at("path_smoothed").size(), 6U);
  const json spaced =
      json::parse(smooth({"--smoother", "none", "--resample", "0.5", "--format", "json"}).out);
  EXPECT_GT(spaced.at("path_smoothed").size(), 21U);
  const json near =
      json::parse(smooth({"--smoother", "none", "--simplify=0.8", "--format", "json"}).out);
  EXPECT_LT(near.at("path_smoothed").size(), 6U);
}

TEST_F(SmoothCommand, OnlySmoothsWhatIsFreeUnlessAskedTo) {
  const std::string blocked = folder_.write("plan.csv", "x,y,x_m,y_m\n0,1,0,0\n1,1,0,0\n2,1,0,0\n");
  const Outcome outcome = wend({"smooth", map_, blocked});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err,
              HasSubstr("only be smoothed with --unsafe: after 0.5 cells, at (1,1.5)"));
  EXPECT_EQ(wend({"smooth", map_, blocked, "--unsafe"}).code, 0);
}

TEST_F(SmoothCommand, SaysWhatIsNoSmootherOrSimplification) {
  EXPECT_THAT(smooth({"--smoother", "gradiant"}).err, HasSubstr("did you mean 'gradient'?"));
  EXPECT_THAT(smooth({"--simplify=sigt"}).err,
              HasSubstr("'sigt' is not collinear, sight, or a tolerance of at least 0"));
  EXPECT_EQ(smooth({"--smoother", "none", "--alpha", "0.1"}).code, 2);
  EXPECT_EQ(smooth({"--turning-radius", "3"}).code, 2);
}

TEST_F(SmoothCommand, PlansAndSmoothsInOne) {
  const std::string csv = folder_ / "plan.csv";
  const Outcome outcome = plan({"--smooth", "-o", csv});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("○ planned   ● smoothed"), HasSubstr("optimal"),
                                 HasSubstr("held      ")));
  EXPECT_THAT(bytes_of(csv), StartsWith("x_grid,y_grid,"));
  const json found = json::parse(plan({"--smooth=0.2,0.2", "--format", "json"}).out);
  EXPECT_EQ(found.at("path").front(), json::parse("[0,0]"));
  EXPECT_EQ(found.at("path_smoothed").front(), json::parse("[0.5,0.5]"));
  EXPECT_EQ(found.at("path_smoothed").size(), found.at("path").size());
  EXPECT_EQ(found.at("path_smoothed_m"), found.at("path_smoothed")) << "a metre a cell";
}

TEST_F(SmoothCommand, PlansAsBeforeWithoutIt) {
  const json found = json::parse(plan({"--format", "json"}).out);
  EXPECT_FALSE(found.contains("path_smoothed"));
  EXPECT_THAT(plan().out, Not(HasSubstr("smoothed")));
}

TEST_F(SmoothCommand, RefusesToPlanWhatCannotBeSmoothed) {
  EXPECT_THAT(plan({"--smooth=x"}).err, HasSubstr("--smooth: 'x' is not ALPHA,BETA"));
  EXPECT_THAT(plan({"--unsafe"}).err, HasSubstr("--unsafe needs --smooth"));
  EXPECT_THAT(
      wend({"plan", map_, "--planner", "car", "--start", "0,0,E", "--goal", "9,0", "--simplify"})
          .err,
      HasSubstr("consists of arcs"));
}

TEST_F(SmoothCommand, CountsInTheUnitsOfTheMap) {
  TemporaryFolder folder;
  const std::string map = folder / "office.yaml";
  ASSERT_EQ(wend({"generate", "office", "--size", "160x100", "--seed", "7", "-o", map}).code, 0);
  const json found =
      json::parse(wend({"plan", map, "--start", "1,1", "--goal", "15,9", "--robot-radius", "0.2",
                        "--nearest", "--smooth", "--resample", "0.25", "--format", "json"})
                      .out);
  const json& points = found.at("path_smoothed_m");
  const double x = points.at(1).at(0).get<double>() - points.at(0).at(0).get<double>();
  const double y = points.at(1).at(1).get<double>() - points.at(0).at(1).get<double>();
  EXPECT_NEAR(std::hypot(x, y), 0.25, 0.01);
  EXPECT_GE(found.at("path_smoothed_metrics").at("smallest_clearance_m").get<double>(), 0.2);
}

}  // namespace
}  // namespace wend::test
