// What the command line makes of its arguments, from outside: optional values, flags that change
// nothing, and how --help shows them.

#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/command_line/run_program.hpp"
#include "wend/robot/robot_fields.hpp"
#include "wend/session/request_fields.hpp"

namespace wend::test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Arguments : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(in_folder("generate random --size 12x9 --density 0 -o grid.txt").code, 0);
    ASSERT_EQ(in_folder("plan grid.txt --start 1,1 --goal 10,7 -o path.csv").code, 0);
  }

  Outcome in_folder(const std::string& command) const {
    return shell("cd " + (folder_ / "").string() + " && $WEND " + command);
  }

  TemporaryFolder folder_;
};

TEST_F(Arguments, WithAnOptionalValueLeaveTheNextOneAlone) {
  for (const std::string command :
       {"plan --smooth grid.txt --start 1,1 --goal 10,7",
        "plan --simplify grid.txt --start 1,1 --goal 10,7",
        "plan --smooth=0.2,0.2 grid.txt --start 1,1 --goal 10,7",
        "smooth --simplify grid.txt path.csv", "smooth --simplify=0.5 grid.txt path.csv",
        "follow --compare grid.txt --path path.csv",
        "follow --compare=p,pid grid.txt --path path.csv"}) {
    const Outcome outcome = in_folder(command);
    EXPECT_EQ(outcome.code, 0) << command << '\n' << outcome.err;
  }
}

TEST_F(Arguments, WithAnOptionalValueSayHowItIsTyped) {
  struct Case {
    std::string command;
    std::string message;
  };
  for (const Case& wrong : {
           Case{"plan grid.txt --start 1,1 --goal 10,7 --smooth 0.2,0.2",
                "unexpected argument '0.2,0.2'; the value of --smooth needs an equals sign, "
                "--smooth=VALUE"},
           Case{"plan --smooth 0.2,0.2 grid.txt --start 1,1 --goal 10,7", "--smooth=VALUE"},
           Case{"smooth grid.txt path.csv --simplify 0.5", "--simplify=VALUE"},
           Case{"follow grid.txt --path path.csv --compare p,pid", "--compare=VALUE"},
       }) {
    const Outcome outcome = in_folder(wrong.command);
    EXPECT_EQ(outcome.code, 2) << wrong.command;
    EXPECT_THAT(outcome.err, HasSubstr(wrong.message));
  }
  EXPECT_THAT(in_folder("info grid.txt again.txt").err, Not(HasSubstr("equals sign")));
}

TEST_F(Arguments, WithoutTheirValueSayWhatItIs) {
  struct Case {
    std::string command;
    std::string message;
  };
  for (const Case& wrong : {
           Case{"plan grid.txt --start", "--start needs a value: X,Y[,HEADING]"},
           Case{"plan grid.txt --start --goal 10,7", "--start needs a value: X,Y[,HEADING]"},
           Case{"plan grid.txt --start --goal=10,7", "--start needs a value: X,Y[,HEADING]"},
           Case{"plan grid.txt --goal 10,7 --start 1,1 -o", "--output needs a value: FILE"},
           Case{"plan grid.txt --connectivity", "--connectivity needs a value: 4|8"},
           Case{"plan grid.txt --start 1,1 --start 2,2",
                "--start is given 2 times but takes one value"},
           Case{"info grid.txt --robot-radius 1 --robot-radius 2 --robot-radius 3",
                "--robot-radius is given 3 times but takes one value"},
       }) {
    const Outcome outcome = in_folder(wrong.command);
    EXPECT_EQ(outcome.code, 2) << wrong.command;
    EXPECT_THAT(outcome.err, HasSubstr("wend: " + wrong.message + "\n"));
  }
}

TEST_F(Arguments, OutOfRangeAreRefusedWithTheRange) {
  struct Case {
    std::string command;
    std::string message;
  };
  const std::string plan = "plan grid.txt --goal 10,7 ";
  for (const Case& wrong : {
           Case{plan + "--start 1,1 --robot-radius 1e308", "between 0 and 1e+09 metres"},
           Case{plan + "--start 1,1 --robot-radius 0,2", "did you mean 0.2?"},
           Case{plan + "--start 1,1 --footprint 0.2", "did you mean 'disc:0.2'?"},
           Case{plan + "--start 1,1 --footprint '1,1;2,2'", "3 to 4096 corners, not 2"},
           Case{plan + "--start 1,1 --footprint '1,1;2,2;2,1;1,2'",
                "corners 1 and 3 cross or touch"},
           Case{plan + "--start 1,1 --footprint rect:2", "write rect:LENGTHxWIDTH"},
           Case{plan + "--start 1,1,E", "--planner hybrid_astar, lattice or car"},
           Case{plan + "--start 1,1 --turning-radius 1", "add --planner hybrid_astar"},
           Case{plan + "--start 1,1 --footprint disc:1 --robot-radius 1", "cannot both be given"},
           Case{"generate maze --size 9x9 --seed -1", "--seed: '-1' is not a whole number"},
           Case{"compare grid.txt --random 0", "--random 0: must be at least 1"},
           Case{"bench grid.txt --sample 0", "--sample 0: must be at least 1"},
           Case{"bench grid.txt --repetitions 0", "--repetitions 0: must be from 1 to"},
           Case{"bench grid.txt --passes 0", "--passes 0: must be from 1 to"},
           Case{"index build grid.txt -o grid.idx --threads 0", "--threads 0: must be from 1 to"},
           Case{plan + "--queries queries.csv --threads 0", "--threads 0: must be from 1 to"},
       }) {
    const Outcome outcome = in_folder(wrong.command);
    EXPECT_EQ(outcome.code, 2) << wrong.command;
    EXPECT_THAT(outcome.err, HasSubstr(wrong.message)) << wrong.command;
  }
}

/// A flag as help shows it.
std::string flag_in_help(const FieldInfo& field) {
  if (field.name == "time_limit") return "\n  --limit-time ";
  if (field.name == "expansions") return "\n  --limit-expansions ";
  std::string flag(field.name);
  std::ranges::replace(flag, '_', '-');
  return "\n  --" + flag + " ";
}

TEST_F(Arguments, HaveAFlagForEveryFieldOfARequest) {
  for (const std::string command : {"plan", "follow"}) {
    std::set<std::string_view> without;
    const std::string help = in_folder(command + " --help-all").out;
    for (const RequestField& field : request_fields()) {
      if (help.find(flag_in_help(field.info)) == std::string::npos) without.insert(field.info.name);
    }
    // What the command line says in another way. A new field has a flag.
    EXPECT_THAT(without, testing::ElementsAre("explain", "from_field", "goal_heading_tolerance",
                                              "keep", "spacing", "straighten"))
        << command;
  }
}

TEST_F(Arguments, HaveAFlagForEveryFieldOfARobot) {
  const std::string help = in_folder("plan --help-all").out;
  for (const RobotField& field : robot_fields()) {
    EXPECT_THAT(help, HasSubstr(flag_in_help(field.info)));
  }
}

TEST_F(Arguments, HaveFormerNamesThatDoTheSame) {
  const std::string plan = "plan grid.txt --start 1,1 --goal 10,7 --format csv ";
  const std::string car = "plan grid.txt --start 1,1,E --goal 9,7 --planner car --format csv ";
  const std::string follow = "follow grid.txt --start 1,1 --goal 10,7 -o - ";
  struct Case {
    std::string command;
    std::string option;
    std::string former;
  };
  for (const Case& named : {
           Case{plan, "--clearance-distance 2", "--keep-away 2"},
           Case{plan + "--clearance-distance 2 ", "--clearance-cost 5", "--keep-away-cost 5"},
           Case{car, "--lattice-resolution 2", "--unit 2"},
           Case{car, "--lattice_resolution 2", "--planner car:unit=2"},
           Case{follow, "--min-speed 0.2", "--least-speed 0.2"},
       }) {
    std::string former = named.command;
    if (named.former.starts_with("--planner")) former.replace(car.find("--planner car"), 13, "");
    const Outcome now = in_folder(named.command + named.option);
    const Outcome before = in_folder(former + named.former);
    EXPECT_EQ(now.code, before.code) << before.err;
    EXPECT_NE(now.code, 2) << now.err;
    EXPECT_EQ(now.out, before.out) << named.former;
    EXPECT_EQ(now.err, before.err) << named.former;
    const std::string name = named.former.substr(0, named.former.find(' '));
    if (name == "--planner") continue;
    const Outcome wrong = in_folder(named.command + name + " nonsense");
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.err, AnyOf(HasSubstr(name + ":"), HasSubstr("'" + name.substr(2) + "'")));
    EXPECT_THAT(in_folder(named.command.substr(0, named.command.find(' ')) + " --help-all").out,
                Not(HasSubstr(name + " ")));
    EXPECT_THAT(in_folder("completion bash").out, Not(HasSubstr(name + " ")));
    const Outcome both = in_folder(named.command + named.option + " " + named.former);
    EXPECT_EQ(both.code, 2) << named.former;
    EXPECT_THAT(both.err, HasSubstr("give one of them"));
  }
}

TEST_F(Arguments, FarOutsideTheMapAreNamedAsTheyAreTyped) {
  ASSERT_EQ(in_folder("convert grid.txt grid.yaml").code, 0);
  const Outcome outcome = in_folder("plan grid.yaml --start 1e308,1 --goal 10,7");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("the start (1e+308,1) m is outside the map, which covers x"));
}

TEST_F(Arguments, ThatChangeNothingAreRefused) {
  const std::string plan = "plan grid.txt --start 1,1 --goal 10,7 ";
  const std::string follow = "follow grid.txt --path path.csv ";
  struct Case {
    std::string command;
    std::string message;
  };
  for (const Case& idle : {
           Case{plan + "--clearance-cost 5", "--clearance-cost changes nothing"},
           Case{plan + "--clearance-distance 0 --clearance-cost 5",
                "--clearance-cost changes nothing"},
           Case{plan + "--constant 3", "--constant changes nothing"},
           Case{plan + "--corner-rounding 0.1", "--corner-rounding changes nothing"},
           Case{plan + "--format csv --show g", "--show changes nothing"},
           Case{plan + "-o - --show g", "--show changes nothing"},
           Case{"plan grid.txt --queries queries.csv --picture always",
                "--picture changes nothing"},
           Case{"plan grid.txt --queries queries.csv --open-list", "--open-list changes nothing"},
           Case{"plan grid.txt --queries queries.csv --corner-rounding 1",
                "--corner-rounding changes nothing"},
           Case{"smooth grid.txt path.csv --turning-radius 2", "--turning-radius changes nothing"},
           Case{follow + "--wheelbase 0.4", "--wheelbase changes nothing"},
           Case{"generate maze --size 9x9 --force", "--force changes nothing"},
           Case{"generate maze --size 9x9 -o maze.map --force", "--force changes nothing"},
           Case{"convert grid.txt grid.map --force", "--force changes nothing"},
           Case{plan + "--speed 5", "--speed changes nothing"},
           Case{plan + "--trace-limit 5", "--trace-limit changes nothing"},
           Case{plan + "--unsafe", "--unsafe needs --smooth"},
           Case{plan + "--picture never --style dark", "--style changes nothing"},
           Case{plan + "--format json --style dark", "--style changes nothing"},
           Case{plan + "--format json --picture always", "--picture changes nothing"},
           Case{"check grid.txt path.csv --clearance-distance 1",
                "unknown option --clearance-distance"},
           Case{"smooth grid.txt path.csv --clearance-distance 1",
                "unknown option --clearance-distance"},
           Case{"explain grid.txt --start 1,1 --goal 9,7 --clearance-distance 1",
                "unknown option --clearance-distance"},
           Case{"smooth grid.txt path.csv --smoother none", "--smoother none changes nothing"},
           Case{"check grid.txt path.csv --format json --style dark", "--style changes nothing"},
           Case{"field grid.txt --goal 9,7 --grid", "--grid changes nothing"},
           Case{"compare grid.txt --start 1,1 --goal 9,7 --seed 2", "--seed changes nothing"},
           Case{"compare grid.txt --start 1,1 --goal 9,7 --style dark", "--style changes nothing"},
           Case{"view grid.txt --picture never", "--picture never leaves nothing to show"},
           Case{"view grid.txt --clearance-distance 2", "--clearance-distance changes nothing"},
           Case{follow + "--samples", "--samples changes nothing"},
           Case{follow + "--film-speed 2", "--film-speed changes nothing"},
           Case{follow + "--seed 2", "--seed changes nothing"},
           Case{follow + "--compare --controller pid", "--controller changes nothing"},
           Case{follow + "--margin 1", "--margin changes nothing"},
           Case{follow + "--nearest", "--nearest changes nothing"},
           Case{follow + "--closest", "--closest changes nothing"},
           Case{"plan grid.txt --start 1,1 --goal 9,7 --nearest-limit 1",
                "--nearest-limit changes nothing"},
           Case{follow + "--clearance-distance 1", "--clearance-distance changes nothing"},
       }) {
    const Outcome outcome = in_folder(idle.command);
    EXPECT_EQ(outcome.code, 2) << idle.command;
    EXPECT_THAT(outcome.err, HasSubstr(idle.message)) << idle.command;
    EXPECT_THAT(outcome.out, IsEmpty()) << idle.command;
  }
}

TEST_F(Arguments, ThatChangeSomethingAreTaken) {
  const std::string plan = "plan grid.txt --start 1,1 --goal 10,7 ";
  for (const std::string& command :
       {plan + "--clearance-distance 1 --clearance-cost 5", plan + "--speed 5 -o search.gif",
        plan + "--trace search.trace.json --trace-limit 5", plan + "--style dark",
        plan + "--heuristic constant --constant 3", plan + "--smooth --corner-rounding 0.1",
        plan + "--format csv --show g -o plan.json",
        std::string("generate maze --size 9x9 -o maze.map -o maze.yaml --force"),
        std::string("smooth grid.txt path.csv --smoother curvature --turning-radius 2"),
        std::string(
            "follow grid.txt --path path.csv --speed 0.2 --drivetrain bicycle --wheelbase 0.4"),
        plan + "--format json --style dark -o plan.png", plan + "--smoother gradient",
        std::string("view grid.txt --show terrain --clearance-distance 2"),
        std::string("field grid.txt --goal 9,7 --grid --format json"),
        std::string("compare grid.txt --random 3 --seed 2"),
        std::string("follow grid.txt --path path.csv --noise 0.001 --seed 2"),
        std::string("follow grid.txt --path path.csv --smooth --margin 0.1")}) {
    const Outcome outcome = in_folder(command);
    EXPECT_EQ(outcome.code, 0) << command << '\n' << outcome.err;
  }
}

TEST_F(Arguments, InHelpAreShownAsTheyAreTyped) {
  const std::string help = wend({"smooth", "--help-all"}).out;
  EXPECT_THAT(help, HasSubstr("\n  --in-place, --no-in-place"));
  EXPECT_THAT(help, HasSubstr("\n  --simplify[=collinear|sight|TOLERANCE]"));
  EXPECT_THAT(help, HasSubstr("\n  -o, --output FILE"));
  EXPECT_THAT(help, AllOf(Not(HasSubstr("{false}")), Not(HasSubstr("in_place"))));
  EXPECT_EQ(in_folder("smooth grid.txt path.csv --in_place --max_sweeps 3").code, 0)
      << "underscores are taken all the same";
}

TEST_F(Arguments, InHelpFitAnOrdinaryTerminal) {
  constexpr std::size_t kColumns = 80;
  for (const std::string command :
       {"", "plan", "smooth", "follow", "check", "field", "compare", "explain", "view", "info",
        "generate", "convert", "index", "index build", "index info", "generate scenario", "bench",
        "planners", "completion"}) {
    std::istringstream lines(in_folder(command + " --help").out);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), kColumns) << command << ": " << line;
    }
  }
}

}  // namespace
}  // namespace wend::test
