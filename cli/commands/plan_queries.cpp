#include "cli/commands/plan_queries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <new>
#include <string_view>
#include <utility>

#include "cli/arguments/input_files.hpp"
#include "cli/arguments/planner_argument.hpp"
#include "cli/arguments/typed_request.hpp"
#include "cli/interrupt.hpp"
#include "cli/output/output.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/report/query_answers.hpp"

namespace wend::cli {
namespace {

constexpr std::size_t kMostRowsTold = 5;

void refuse(QueryAnswer& answer, std::string_view wrong) {
  answer.status = kInvalidQuery;
  answer.reason = fmt::format("line {}: {}", answer.line, wrong);
}

void fail(QueryAnswer& answer, Status status, std::string reason) {
  answer.status = to_string(status);
  answer.reason = std::move(reason);
}

/// A batch of queries on the map of a session, all with the same planner. Threads may share it.
class QueryBatch {
 public:
  QueryBatch(const PlanArguments& arguments, Session& session, const PlannerSpec& planner)
      : arguments_(arguments),
        session_(session),
        planner_(planner),
        view_(value_or_throw(session.view())),
        coordinates_(arguments.map.coordinates(view_.space.map())) {}

  const Frame& frame() const { return view_.space.map().frame(); }

  /// Does not throw: the answer to an invalid row says so.
  QueryAnswer answer(const QueryRow& row) const;

 private:
  void ask(QueryAnswer& answer) const;

  const PlanArguments& arguments_;
  Session& session_;
  const PlannerSpec& planner_;
  Session::View view_;
  Coordinates coordinates_;
};

QueryAnswer QueryBatch::answer(const QueryRow& row) const {
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

void QueryBatch::ask(QueryAnswer& answer) const {
  PlanRequest request = typed_request(planner_, view_.space, coordinates_,
                                      {answer.start, {answer.goal}, arguments_.ends.tolerance});
  arguments_.request.put(request, coordinates_);
  request.limits = arguments_.limits.limits();
  request.explain = false;
  auto run = session_.begin(view_, request);
  if (!run) return fail(answer, run.error().status, run.error().message);
  auto found = run->finish();
  if (found) {
    answer.status = to_string(Status::found);
    answer.reason = fmt::format("{}", fmt::join(run->notes(), "; "));
    answer.plan = std::move(found->plan);
    answer.seconds = found->search_seconds;
    answer.lead_out = std::move(found->lead_out);
    answer.remaining = found->remaining;
    return;
  }
  answer.plan.metrics = found.error().metrics;
  answer.seconds = found.error().search_seconds;
  // Finding the reason takes an extra search: worth it for one query, not for each of thousands.
  const Status status = found.error().status;
  fail(answer, status,
       status == Status::unreachable
           ? fmt::format("{}; `wend explain` shows the reason", describe(status))
           : run->explain());
}

std::vector<QueryAnswer> answers_to(const std::vector<QueryRow>& rows, const QueryBatch& batch,
                                    std::size_t count) {
  std::vector<QueryAnswer> answers(rows.size());
  const Interruptible interruptible;  // what is answered until then is reported
  ProgressBar progress("queries", rows.size());
  std::atomic<std::uint64_t> done = 0;
  ThreadWorkers threads(static_cast<unsigned>(count));
  threads.run(rows.size(), [&](std::size_t row, unsigned thread) {
    answers[row] = batch.answer(rows[row]);
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
  // One for each thread: they share what they prepare, and the session keeps them for the rows.
  if (const auto made = session.planners(planner, most); !made) {
    throw InputError(made.error().message);
  }
  const QueryBatch batch(arguments, session, planner);
  const std::vector<QueryAnswer> answers = answers_to(rows, batch, most);
  const auto text = [&](TableFormat format) {
    return text_of(planner, answers, batch.frame(), format);
  };
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
