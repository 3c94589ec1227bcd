// The suite finds planners that break their guarantees: each fault is found by the check that is for it.

#include "conformance/suite.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "conformance/suite_report.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What a faulty planner does instead of passing everything on to a good one. Null: it passes it on.
struct Fault {
  std::function<Status(Planner& good, const Query&, Plan&, int queries_before)> plan = {};
  std::function<std::optional<Status>(Planner& good, Plan&)> step = {};
  bool ignores_updates = false;
  std::shared_ptr<const Fault> of_clones = {};
};

class FaultyPlanner final : public Planner {
 public:
  FaultyPlanner(std::unique_ptr<Planner> good, Fault fault)
      : Planner(good->free_space()), good_(std::move(good)), fault_(std::move(fault)) {}

 private:
  std::optional<Status> do_check(const Query&) override { return std::nullopt; }
  Status do_plan(const Query& query, Plan& out) override {
    const int before = queries_++;
    return fault_.plan ? fault_.plan(*good_, query, out, before) : good_->plan(query, out);
  }
  bool do_anytime() const override { return good_->anytime(); }
  std::optional<Status> do_begin(const Query& query, Plan& out) override {
    return good_->begin(query, out);
  }
  std::optional<Status> do_step(Plan& out) override {
    return fault_.step ? fault_.step(*good_, out) : good_->step(out);
  }
  std::unique_ptr<Planner> do_clone() const override {
    return std::make_unique<FaultyPlanner>(good_->clone(),
                                           fault_.of_clones ? *fault_.of_clones : fault_);
  }
  std::optional<Error> do_update(const SpaceChange& change) override {
    if (fault_.ignores_updates) return std::nullopt;
    auto updated = good_->update(free_space(), change);
    if (updated) return std::nullopt;
    return updated.error();
  }

  std::unique_ptr<Planner> good_;
  Fault fault_;
  int queries_ = 0;
};

/// Declares what `declared` does, and passes queries on to `good`.
PlannerInfo faulty_info(const std::string& declared, const std::string& good, const Fault& fault) {
  PlannerInfo info = *planners().find(declared);
  info.make = [good, fault](const FreeSpace& space, const OptionValues& options) -> PlannerResult {
    auto made = make_planner(good, space, options);
    if (!made) return Unexpected<Error>(made.error());
    return std::make_unique<FaultyPlanner>(*std::move(made), fault);
  };
  return info;
}

std::vector<CheckReport> reports_of(const PlannerInfo& info, std::uint64_t maps = 60) {
  std::vector<CheckReport> reports;
  for (const ConformanceCheck& check : conformance_checks()) {
    reports.push_back(run_check(check, info, {.maps = maps}));
  }
  return reports;
}

std::vector<std::string> failed_checks(const PlannerInfo& info) {
  std::vector<std::string> failed;
  for (const CheckReport& report : reports_of(info)) {
    if (!report.passed()) failed.push_back(report.check);
  }
  return failed;
}

std::vector<std::string> failed_checks(const Fault& fault,
                                       const std::string& planner = "dijkstra") {
  return failed_checks(faulty_info(planner, planner, fault));
}

bool is_found_by(const std::string& check, const PlannerInfo& info) {
  return !run_check(*find_check(check), info, {.maps = 60}).passed();
}

bool is_found_by(const std::string& check, const Fault& fault,
                 const std::string& planner = "dijkstra") {
  return is_found_by(check, faulty_info(planner, planner, fault));
}

/// The fault changes plans that were found.
Fault changing(const std::function<void(Plan&)>& change) {
  return {.plan = [change](Planner& good, const Query& query, Plan& out, int) {
    const Status status = good.plan(query, out);
    if (status == Status::found) change(out);
    return status;
  }};
}

TEST(Suite, PassesAPlannerThatOnlyPassesQueriesOn) {
  EXPECT_THAT(failed_checks(Fault{}, "dijkstra"), IsEmpty());
  EXPECT_THAT(failed_checks(Fault{}, "car"), IsEmpty());
}

TEST(Suite, FindsAPathThroughAWall) {
  const Fault fault{.plan = [](Planner& good, const Query& query, Plan& out, int) {
    const Status status = good.plan(query, out);
    if (status != Status::unreachable) return status;
    Cell cell = cell_at(query.start.point());
    const Cell goal = cell_at(query.goals.front().point);
    out.path.append(cell);
    out.cost = 0;
    while (cell.x != goal.x || cell.y != goal.y) {
      cell.x += (goal.x > cell.x) - (goal.x < cell.x);
      cell.y += (goal.y > cell.y) - (goal.y < cell.y);
      out.path.append(cell);
      ++out.cost;
    }
    return Status::found;
  }};
  EXPECT_TRUE(is_found_by("answers", fault));
  EXPECT_TRUE(is_found_by("nine_cells", fault));
}

TEST(Suite, FindsACostThatIsNotThatOfThePath) {
  EXPECT_TRUE(is_found_by("answers", changing([](Plan& plan) { plan.cost *= 0.9; })));
  EXPECT_TRUE(is_found_by("answers", changing([](Plan& plan) { plan.cost *= 1.001; })));
}

TEST(Suite, FindsALongerPathThatClaimsToBeOptimal) {
  const PlannerInfo info =
      faulty_info("dijkstra", "greedy", changing([](Plan& plan) { plan.bound = 1; }));
  EXPECT_TRUE(is_found_by("answers", info));
}

TEST(Suite, FindsAPlannerThatDeclaresMoreThanItsPlansSay) {
  EXPECT_TRUE(is_found_by("answers", changing([](Plan& plan) { plan.bound = 2; })));
}

TEST(Suite, FindsABoundThatIsNotTrueOnTheWay) {
  const Fault fault = {.plan = [](Planner& good, const Query& query, Plan& out, int) {
    Query told = query;
    told.on_solution = [&](const Plan& plan) {
      Plan claimed = plan;
      claimed.bound = 1;
      if (query.on_solution) query.on_solution(claimed);
    };
    return good.plan(told, out);
  }};
  EXPECT_TRUE(is_found_by("anytime", fault, "ara_star"));
}

TEST(Suite, FindsACostThatRises) {
  const Fault fault = {.plan = [](Planner& good, const Query& query, Plan& out, int) {
    Query silent = query;
    silent.on_solution = {};
    const Status status = good.plan(silent, out);
    if (status == Status::found && query.on_solution) {
      Plan cheaper = out;
      cheaper.cost -= 1;
      query.on_solution(cheaper);  // the answer costs more again
    }
    return status;
  }};
  EXPECT_TRUE(is_found_by("anytime", fault, "ara_star"));
}

TEST(Suite, FindsMoreStepsThanTheFewest) {
  const PlannerInfo info = faulty_info("bfs", "dfs", Fault{});
  EXPECT_TRUE(is_found_by("answers", info));
}

TEST(Suite, FindsAPlannerThatGivesUp) {
  const Fault fault{.plan = [](Planner& good, const Query& query, Plan& out, int) {
    const Status status = good.plan(query, out);
    if (status != Status::found || out.path.size() < 4) return status;
    out = {};
    out.cost = kInfinite;
    return Status::unreachable;
  }};
  EXPECT_TRUE(is_found_by("answers", fault));
}

TEST(Suite, FindsAPlannerThatForgetsItsLimits) {
  const auto forgetting = [](auto forget) {
    return Fault{.plan = [forget](Planner& good, Query query, Plan& out, int) {
      forget(query.limits);
      return good.plan(query, out);
    }};
  };
  for (const std::string planner : {"dijkstra", "car", "lattice"}) {
    EXPECT_TRUE(
        is_found_by("limits", forgetting([](Limits& of) { of.cancel = nullptr; }), planner));
    EXPECT_TRUE(is_found_by(
        "limits", forgetting([](Limits& of) { of.expansions = Limits::kUnlimited; }), planner));
    EXPECT_TRUE(is_found_by("limits", forgetting([](Limits& of) { of.seconds = 1e9; }), planner));
  }
}

TEST(Suite, FindsAnswersThatDependOnEarlierQueries) {
  const Fault fault{.plan = [](Planner& good, const Query& query, Plan& out, int before) {
    const Status status = good.plan(query, out);
    if (before == 7) ++out.metrics.max_frontier;
    return status;
  }};
  EXPECT_TRUE(is_found_by("reused", fault, "bfs"));  // astar learns: its work may become less
  EXPECT_TRUE(is_found_by("reused", fault, "lattice"));
}

TEST(Suite, FindsAnUpdateThatIsForgotten) {
  const Fault fault{.ignores_updates = true};
  EXPECT_TRUE(is_found_by("updated", fault));
  EXPECT_TRUE(is_found_by("updated", fault, "car"));
  EXPECT_TRUE(is_found_by("terrain", fault, "jps"));
}

TEST(Suite, FindsACloneThatAnswersDifferently) {
  Fault fault;
  fault.of_clones = std::make_shared<Fault>(changing([](Plan& plan) { plan.cost += 1; }));
  EXPECT_TRUE(is_found_by("cloned", fault));
  EXPECT_TRUE(is_found_by("cloned", fault, "car"));
}

TEST(Suite, FindsSteppingThatAnswersDifferently) {
  const Fault different{.step = [](Planner& good, Plan& out) {
    const auto outcome = good.step(out);
    if (outcome == Status::found) out.cost += 1;
    return outcome;
  }};
  EXPECT_TRUE(is_found_by("stepped", different));
  const Fault endless{.step = [](Planner&, Plan&) { return std::optional<Status>(); }};
  EXPECT_TRUE(is_found_by("stepped", endless));
  EXPECT_TRUE(is_found_by("stepped", endless, "lattice"));
}

/// Plans for tolerances that were changed.
Fault with_tolerances(const std::function<void(Goal&)>& change) {
  return {.plan = [change](Planner& good, Query query, Plan& out, int) {
    for (Goal& goal : query.goals) change(goal);
    return good.plan(query, out);
  }};
}

TEST(Suite, FindsAPlannerThatDoesNotKeepToTolerances) {
  const Fault careless = with_tolerances([](Goal& goal) { goal.tolerance += 2; });
  const Fault forgetful = with_tolerances([](Goal& goal) { goal.tolerance = 0; });
  const Fault too_few = with_tolerances([](Goal& goal) { goal.tolerance *= 0.9; });
  for (const Fault& fault : {careless, forgetful, too_few}) {
    EXPECT_TRUE(is_found_by("answers", fault));
  }
  EXPECT_TRUE(is_found_by("poses", careless, "car"));
  EXPECT_TRUE(is_found_by("poses", careless, "lattice"));
  EXPECT_TRUE(is_found_by("poses", with_tolerances([](Goal& goal) { goal.heading_tolerance += 2; }),
                          "car"));
}

TEST(Suite, FindsAPlannerThatGoesToTheFirstOfSeveralGoals) {
  const Fault first{.plan = [](Planner& good, Query query, Plan& out, int) {
    if (query.goals.size() > 1) query.goals.resize(1, query.goals.front());
    return good.plan(query, out);
  }};
  EXPECT_TRUE(is_found_by("answers", first));
}

TEST(Suite, FindsAWrongStatus) {
  const auto saying = [](Status instead_of, Status wrong) {
    return Fault{.plan = [=](Planner& good, const Query& query, Plan& out, int) {
      const Status status = good.plan(query, out);
      return status == instead_of ? wrong : status;
    }};
  };
  for (const std::string planner : {"dijkstra", "car", "lattice"}) {
    for (const Status status : {Status::start_outside, Status::goal_outside, Status::start_blocked,
                                Status::goal_blocked, Status::unreachable}) {
      EXPECT_TRUE(is_found_by("status", saying(status, Status::memory_limit), planner))
          << planner << ", " << to_string(status);
    }
  }
}

TEST(Suite, FindsWhatAFailureLeavesInThePlan) {
  const Fault fault{.plan = [](Planner& good, const Query& query, Plan& out, int) {
    const Status status = good.plan(query, out);
    if (status != Status::found) out.cost = 0;
    return status;
  }};
  EXPECT_TRUE(is_found_by("answers", fault));
  EXPECT_TRUE(is_found_by("poses", fault, "car"));
}

TEST(Suite, FindsPosesThatAreNotWhereThePlanSays) {
  for (const std::string planner : {"car", "lattice"}) {
    EXPECT_TRUE(is_found_by(
        "poses", changing([](Plan& plan) { plan.goal_snapping_error.turn += 0.1; }), planner));
    EXPECT_TRUE(is_found_by("poses", changing([](Plan& plan) { plan.moves.emplace_back("more"); }),
                            planner));
  }
}

TEST(Suite, FindsADriveThroughAWall) {
  // It turns the path's inner poses into one jump from the first to the last.
  const Fault fault = changing([](Plan& plan) {
    const auto poses = plan.path.driven_poses();
    plan.path = Path::through({poses.front(), poses.back()});
    plan.moves.clear();
  });
  EXPECT_TRUE(is_found_by("poses", fault, "lattice"));
  EXPECT_TRUE(is_found_by("poses", fault, "car"));
}

TEST(Suite, ShowsTheSmallestMapAndTheSeedThatMakesItAgain) {
  const PlannerInfo info =
      faulty_info("dijkstra", "dijkstra", changing([](Plan& plan) { plan.cost += 1; }));
  const ConformanceCheck& answers = *find_check("answers");
  const CheckReport all = run_check(answers, info, {.maps = 60});
  ASSERT_TRUE(all.smallest);
  const CheckReport again = run_check(answers, info, {.maps = 1, .seed = all.smallest->seed});
  ASSERT_TRUE(again.smallest);
  EXPECT_EQ(again.smallest->trial, all.smallest->trial);
  EXPECT_EQ(again.smallest->query, all.smallest->query);
  EXPECT_EQ(again.smallest->came, all.smallest->came);
  EXPECT_LT(all.smallest->cells, 10U);
}

TEST(Suite, UsesFixedOptionsInEveryTrial) {
  PlannerInfo info = *planners().find("astar");
  std::vector<OptionValues> used;
  const auto make = info.make;
  info.make = [&](const FreeSpace& space, const OptionValues& options) {
    used.push_back(options);
    return make(space, options);
  };
  const OptionValues fixed{{"weight", "2"}};
  for (const ConformanceCheck& check : conformance_checks()) {
    const CheckReport report = run_check(check, info, {.maps = 12, .options = fixed});
    EXPECT_TRUE(report.passed()) << check.name;
  }
  EXPECT_FALSE(used.empty());
  EXPECT_THAT(used, ::testing::Each(fixed));
}

TEST(Suite, EndsWhenItIsToldTo) {
  std::uint64_t calls = 0;
  SuiteOptions options;
  options.go_on = [&](std::uint64_t) { return ++calls <= 3; };
  EXPECT_EQ(run_check(*find_check("stepped"), *planners().find("bfs"), options).maps, 3U);
}

TEST(SuiteReport, ShowsAFailedCheckInTextAndJson) {
  const PlannerInfo info =
      faulty_info("dijkstra", "dijkstra", changing([](Plan& plan) { plan.cost += 1; }));
  const SuiteReport report{"swirl", "optimal", reports_of(info, 12)};
  const std::string text = check_text(report.checks.front(), "wend test-planner swirl");
  EXPECT_THAT(text, HasSubstr("FAILED (12 maps, 48 queries)"));
  EXPECT_THAT(text, HasSubstr("expected: cost "));
  EXPECT_THAT(text, HasSubstr("again:    wend test-planner swirl --seed "));
  EXPECT_THAT(summary_text(report), HasSubstr("swirl failed "));
  const auto json = nlohmann::json::parse(suite_json(report));
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("passed"), false);
  EXPECT_EQ(json.at("checks").at(0).at("outcome"), "failed");
  EXPECT_GT(json.at("checks").at(0).at("smallest").at("cells"), 0);
}

}  // namespace
}  // namespace wend::test
