// The same query asked in another way: the answers are equal.

#include <string>

#include "conformance/answer.hpp"
#include "conformance/checks.hpp"
#include "conformance/random_edit.hpp"
#include "wend/base/random.hpp"

namespace wend::test {
namespace {

void expect_same(Examination& examination, const Answer& expected, const Answer& answer,
                 const std::string& way) {
  if (!same_answers(examination.info(), expected, answer))
    examination.violate(text_of(expected), way + ": " + text_of(answer));
}

}  // namespace

/// Many queries on a larger map, with one planner and one plan.
void examine_reused(Examination& examination, std::uint64_t seed) {
  Random random(seed);
  const PlannerInfo& info = examination.info();
  Trial trial = examination.random_trial(seed);
  trial.robot = {};
  if (!info.capabilities.headings) {
    trial.map = random_map(random, 20, 15);
    if (!examination.fixed_options()) trial.options = random_options(random, info.options);
  }
  examination.on(trial, seed);
  const auto reused = examination.planner_for(trial);
  if (reused == nullptr) return;
  Answer answer;
  for (int i = 0; i < 50; ++i) {
    const Query query = random_query(random, trial.map, info);
    examination.ask(query);
    const auto fresh = examination.planner_for(trial);
    if (fresh == nullptr) return;
    answer.status = reused->plan(query, answer.plan);
    expect_same(examination, answer_of(*fresh, query), answer, "reused");
  }
}

/// One planner over a row of maps of all sizes.
void examine_updated(Examination& examination, std::uint64_t seed) {
  constexpr std::uint64_t kMaps = 25;
  const OptionValues options = examination.random_trial(seed * kMaps).options;
  std::unique_ptr<Planner> updated;
  for (std::uint64_t i = 0; i < kMaps; ++i) {
    Trial trial = examination.random_trial(seed * kMaps + i);
    trial.options = options;
    examination.on(trial, seed);
    const auto fresh = examination.planner_for(trial);
    if (fresh == nullptr) continue;
    if (updated == nullptr) {
      updated = examination.planner_for(trial);
    } else if (const auto done = updated->update(fresh->free_space()); !done) {
      examination.violate("an update, as it can be made on this map", done.error().message);
    }
    Random random(seed + i);
    for (int n = 0; n < 3; ++n) {
      const Query query = random_query(random, trial.map, examination.info());
      examination.ask(query);
      expect_same(examination, answer_of(*fresh, query), answer_of(*updated, query), "updated");
    }
  }
}

/// One planner over a row of edits of one map, with and without copies of the space it lets go of.
void examine_edited(Examination& examination, std::uint64_t seed) {
  constexpr int kEdits = 6;
  const PlannerInfo& info = examination.info();
  Trial trial = examination.random_trial(seed);
  examination.on(trial, seed);
  const auto edited = examination.planner_for(trial);
  if (edited == nullptr) return;
  Random random(seed);
  FreeSpace space = edited->free_space();
  for (int i = 0; i < kEdits; ++i) {
    const bool with_terrain = info.capabilities.terrain && random.chance(0.3);
    const MapEdit edit = random_edit(random, space.map(), with_terrain);
    if (random.chance(0.5)) edited->release();
    const auto change = space.edit(edit);
    if (!change) return examination.violate("a map with the edit", change.error().message);
    trial.map = space.map();
    examination.on(trial, seed);
    const auto updated = edited->update(space, *change);
    // An index is not built again.
    if (!updated && updated.error().status == Status::index_mismatch) continue;
    const auto fresh = examination.planner_for(trial);
    if (fresh == nullptr) {
      if (updated) examination.violate("no update, as none can be made on this map", "one");
      continue;
    }
    if (!updated)
      return examination.violate("an update, as one can be made on this map",
                                 updated.error().message);
    for (int n = 0; n < 3; ++n) {
      const Query query = random_query(random, trial.map, info);
      examination.ask(query);
      expect_same(examination, answer_of(*fresh, query), answer_of(*edited, query), "edited");
    }
  }
}

void examine_cloned(Examination& examination, std::uint64_t seed) {
  const Trial trial = examination.random_trial(seed);
  examination.on(trial, seed);
  const auto planner = examination.planner_for(trial);
  if (planner == nullptr) return;
  Random random(seed);
  const auto before = planner->clone();
  for (int i = 0; i < 3; ++i) {
    const Query query = random_query(random, trial.map, examination.info());
    examination.ask(query);
    const Answer expected = answer_of(*planner, query);
    expect_same(examination, expected, answer_of(*before, query), "cloned");
    expect_same(examination, expected, answer_of(*planner->clone(), query), "cloned after queries");
  }
}

void examine_stepped(Examination& examination, std::uint64_t seed) {
  const Trial trial = examination.random_trial(seed);
  examination.on(trial, seed);
  const auto planner = examination.planner_for(trial);
  if (planner == nullptr) return;
  Random random(seed);
  const Query query = random_query(random, trial.map, examination.info());
  examination.ask(query);
  const Answer answer = answer_of(*planner, query);
  const std::string fault = stepping_fault(*planner, examination.info(), query, answer);
  if (!fault.empty()) examination.violate(text_of(answer), fault);
}

}  // namespace wend::test
