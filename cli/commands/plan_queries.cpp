#include "cli/commands/plan_queries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "cli/arguments/input_files.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/interrupt.hpp"
#include "cli/output/explanations.hpp"
#include "cli/output/output.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/report/query_answers.hpp"

namespace wend::cli {
namespace {

constexpr std::size_t kMostRowsTold = 5;

/// Answers rows one after the other; one for each thread.
class QueryWorker {
 public:
  QueryWorker(const PlanArguments& arguments, const PlannerSpec& spec, FreeSpace space,
              WarmPlanner planner)
      : arguments_(arguments),
        spec_(spec),
        space_(std::move(space)),
        coordinates_(arguments.map.coordinates(space_.map())),
        planner_(std::move(planner)),
        explainer_(
            explainer_for(space_, coordinates_, planner_->grid_moves().value_or(GridMoves{}))),
        leeway_(arguments.leeway.leeway(coordinates_)) {
    explainer_.allow(leeway_);
  }

  /// Does not throw: the answer to an invalid row says so.
  QueryAnswer answer(const QueryRow& row) {
    QueryAnswer answer{
        .line = row.line, .start = row.start, .goal = row.goal, .status = {}, .reason = {}};
    if (!row.wrong.empty()) {
      refuse(answer, row.wrong);
      return answer;
    }
    if (Interruptible::cancelled()) {
      fail(answer, Status::cancelled, std::string(describe(Status::cancelled)));
      return answer;
    }
    try {
      ask(answer);
    } catch (const InputError& error) {
      const std::string_view wrong = error.what();  // "--start: ..." of what a column says here
      refuse(answer, wrong.substr(wrong.starts_with("--") ? 2 : 0));
    } catch (const std::bad_alloc&) {
      fail(answer, Status::memory_limit, std::string(describe(Status::memory_limit)));
    }
    return answer;
  }

 private:
  static void refuse(QueryAnswer& answer, std::string_view wrong) {
    answer.status = kInvalidQuery;
    answer.reason = fmt::format("line {}: {}", answer.line, wrong);
  }

  static void fail(QueryAnswer& answer, Status status, std::string reason) {
    answer.status = to_string(status);
    answer.reason = std::move(reason);
  }

  void ask(QueryAnswer& answer) {
    const Deadline deadline = arguments_.limits.deadline();
    explainer_.stop_at(deadline);
    const auto asked = typed_query(spec_, space_, coordinates_,
                                   {answer.start, {answer.goal}, arguments_.ends.tolerance});
    EasedQuery eased(asked->query(), *planner_, explainer_, coordinates_, leeway_);
    asked->move_ends(eased);
    Query& query = eased.query();
    const auto search = [&] {
      query.limits = deadline.left();
      query.limits.expansions = arguments_.limits.expansions;
      return planner_->plan(query, answer.plan);
    };
    const Status status = timed(thread_cpu_seconds, answer.seconds, [&] {
      const Status first = search();
      return eased.ease_goals(first) ? search() : first;
    });
    if (arguments_.limits.seconds) query.limits.seconds = *arguments_.limits.seconds;
    answer.status = to_string(status);
    if (status == Status::found) return finish(eased, answer);
    // Finding the reason takes an extra search: worth it for one query, not for each of thousands.
    fail(answer, status,
         status == Status::unreachable
             ? fmt::format("{}; `wend explain` shows the reason", describe(status))
             : explainer_.explain(*planner_, query, asked->ends(), status, answer.plan.metrics));
  }

  void finish(EasedQuery& eased, QueryAnswer& answer) const {
    eased.finish(answer.plan);
    begin_with(eased.lead(), answer.plan, space_.map().frame());
    answer.reason = fmt::format("{}", fmt::join(eased.notes(), "; "));
    answer.lead_out = eased.lead_out();
    if (const auto remaining = eased.remaining()) {
      answer.remaining = *remaining * space_.map().frame().resolution;
    }
  }

  const PlanArguments& arguments_;
  const PlannerSpec& spec_;
  FreeSpace space_;
  Coordinates coordinates_;
  WarmPlanner planner_;
  Explainer explainer_;
  Leeway leeway_;
};

/// They share what their planners prepare.
std::vector<QueryWorker> make_workers(const PlanArguments& arguments, Session& session,
                                      const PlannerSpec& planner, std::size_t count) {
  const FreeSpace space = value_or_throw(session.view()).space;
  auto planners = session.planners(planner, count);
  if (!planners) throw InputError(planners.error().message);
  std::vector<QueryWorker> workers;
  for (WarmPlanner& each : *planners) {
    workers.emplace_back(arguments, planner, space, std::move(each));
  }
  return workers;
}

std::vector<QueryAnswer> answers_to(const std::vector<QueryRow>& rows,
                                    std::vector<QueryWorker>& workers) {
  std::vector<QueryAnswer> answers(rows.size());
  const Interruptible interruptible;  // what is answered until then is reported
  ProgressBar progress("queries", rows.size());
  std::atomic<std::uint64_t> done = 0;
  ThreadWorkers threads(static_cast<unsigned>(workers.size()));
  threads.run(rows.size(), [&](std::size_t row, unsigned thread) {
    answers[row] = workers[thread].answer(rows[row]);
    ++done;
    if (thread == 0) progress.update(done);
  });
  return answers;
}

std::string text_of(const PlannerSpec& planner, const std::vector<QueryAnswer>& answers,
                    const Frame& frame, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return query_answers_text(answers, frame);
    case TableFormat::json:
      return query_answers_json(planner.name, answers, frame, info_of(planner).capabilities);
    case TableFormat::csv:
      break;
  }
  return query_answers_csv(answers, frame);
}

/// Reports the first rows without a path; the answers have all of them.
void complain_of(const std::string& file, const std::vector<QueryAnswer>& answers) {
  std::size_t complaints = 0;
  for (const QueryAnswer& answer : answers) {
    if (answer.found()) continue;
    if (++complaints > kMostRowsTold) {
      complain("... and more; the answers list all of them");
      return;
    }
    const std::string line = fmt::format("line {}: ", answer.line);
    const bool named = answer.reason.starts_with(line);
    complain(fmt::format("{}: {}{}", file, named ? "" : line, answer.reason));
  }
}

}  // namespace

void check_queries(const PlanArguments& arguments) {
  check_range("--threads", arguments.threads, 1, kMostThreads);
  check_read_once({arguments.map.file, arguments.queries});
  const WatchArguments& watch = arguments.watch;
  const bool watched = watch.verbose || watch.step || watch.animate || !watch.trace.empty();
  if (!arguments.ends.start.empty() || !arguments.ends.goals.empty()) {
    throw InputError("--queries reads starts and goals from a file: leave out --start and --goal");
  }
  if (watched || !arguments.layers.empty() || arguments.refine.any()) {
    throw InputError(
        "--queries cannot be combined with --show, --verbose, --step, --animate, --trace, "
        "--simplify, --smooth or --resample");
  }
  arguments.output.check_not_among({arguments.queries});
  for (const std::string& file : arguments.output.files()) {
    if (file == kStandardOutput || OutputFiles::is(file, ".csv") ||
        OutputFiles::is(file, ".json")) {
      continue;
    }
    throw InputError(fmt::format("-o {}: with --queries the name must end in .csv or .json", file));
  }
}

ExitCode run_queries(const PlanArguments& arguments, Session& session, const PlannerSpec& planner,
                     const IndexArgument& index) {
  const std::vector<QueryRow> rows = read_queries(arguments.queries);
  WorkTimes times;  // unused: answers have only the search times
  if (const auto built = provide_index(session, planner, index, times); !built) {
    throw InputError(built.error().message);
  }
  const std::size_t most = std::clamp<std::size_t>(rows.size(), 1, arguments.threads);
  std::vector<QueryWorker> workers = make_workers(arguments, session, planner, most);
  const Frame frame = value_or_throw(session.view()).space.map().frame();
  const std::vector<QueryAnswer> answers = answers_to(rows, workers);
  const auto text = [&](TableFormat format) { return text_of(planner, answers, frame, format); };
  if (!arguments.output.print()) print(text(arguments.format));
  arguments.output.write(
      {{".csv", [&](const std::string& file) { return write_bytes(file, text(TableFormat::csv)); }},
       {".json",
        [&](const std::string& file) { return write_bytes(file, text(TableFormat::json)); }}},
      arguments.format == TableFormat::json ? ".json" : ".csv");
  complain_of(arguments.queries, answers);
  const bool all = std::all_of(answers.begin(), answers.end(),
                               [](const QueryAnswer& answer) { return answer.found(); });
  return all ? success : no_plan;
}

}  // namespace wend::cli
