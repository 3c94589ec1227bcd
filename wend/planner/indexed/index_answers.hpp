#pragma once

// IndexAnswers: what IndexPlanner asks an opened index: paths between cells. It owns scratch memory: each thread needs
// its own.

#include <memory>
#include <optional>

#include "wend/geometry/cell.hpp"
#include "wend/index/index_engine.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/path/path.hpp"
#include "wend/search/search_outcome.hpp"

namespace wend {

class IndexAnswers {
 public:
  IndexAnswers() = default;
  virtual ~IndexAnswers() = default;
  IndexAnswers(const IndexAnswers&) = delete;
  IndexAnswers& operator=(const IndexAnswers&) = delete;

  /// The cost of the cheapest path between two different cells that are connected; infinite if a forged index knows
  /// none.
  virtual double find(Cell start, Cell goal) = 0;

  /// Writes the path of the last find() into an empty one, and returns its cost; nothing if a forged index knows none.
  virtual std::optional<double> write(Path& path) = 0;

  /// Writes the path that stays in a cell into an empty one.
  virtual void write_place(Cell cell, Path& path) const = 0;

  /// What Plan::bound says of every answer.
  virtual double bound() const = 0;

  /// The work of the last find().
  virtual SearchMetrics metrics() const = 0;
};

/// From an engine whose paths are steps between cells.
std::unique_ptr<IndexAnswers> answers_in_steps(std::unique_ptr<IndexEngine> engine,
                                               const BitGrid& passable);

}  // namespace wend
