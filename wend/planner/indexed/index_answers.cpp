#include "wend/planner/indexed/index_answers.hpp"

#include <utility>

namespace wend {
namespace {

class StepAnswers final : public IndexAnswers {
 public:
  StepAnswers(std::unique_ptr<IndexEngine> engine, std::size_t most_cells)
      : engine_(std::move(engine)), most_cells_(most_cells) {}

  double find(Cell start, Cell goal) override {
    steps_ = engine_->find(start, goal);
    return steps_.cost();
  }

  std::optional<double> write(Path& path) override {
    // A shortest path never visits a cell twice: an index that says so was forged.
    if (steps_.cells() > most_cells_) return std::nullopt;
    engine_->write(path.make_cells(steps_.cells()));
    return steps_.cost();
  }

  void write_place(Cell cell, Path& path) const override { path.append(cell); }
  double bound() const override { return 1; }
  SearchMetrics metrics() const override { return engine_->metrics(); }

 private:
  std::unique_ptr<IndexEngine> engine_;
  std::size_t most_cells_;
  OctileSteps steps_;
};

}  // namespace

std::unique_ptr<IndexAnswers> answers_in_steps(std::unique_ptr<IndexEngine> engine,
                                               const BitGrid& passable) {
  return std::make_unique<StepAnswers>(std::move(engine), passable.count());
}

}  // namespace wend
