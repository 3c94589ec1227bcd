#pragma once

// HubEngine: answers queries from the sections of a label index (hub_index.hpp).

#include <cstdint>
#include <optional>
#include <vector>

#include "wend/index/hub_labels/hub_record.hpp"
#include "wend/index/hub_labels/hub_sections.hpp"
#include "wend/index/index_engine.hpp"
#include "wend/index/run_writer.hpp"
#include "wend/jump/sight.hpp"

namespace wend {

/// Hub is std::uint16_t, or std::uint32_t if 16 bits do not name all hubs.
template <class Hub>
class HubEngine final : public IndexEngine {
 public:
  /// Keeps the bytes, where the sections lie.
  HubEngine(IndexBytes index, const HubSections& sections, const BitGrid& passable);

  OctileSteps find(Cell start, Cell goal) override;
  void write(std::span<Cell> cells) override;
  SearchMetrics metrics() const override { return metrics_; }

 private:
  using Record = HubRecord<Hub>;

  /// A cost in the upper half, and in the lower one which hub of the record it is to.
  using Sum = std::uint64_t;
  static constexpr Sum kNoSum = Sum{1} << 63U;
  static constexpr unsigned kHalf = 32;  // bits

  /// Diagonally first from the start to `first` and from the goal to `last`; between these by a hub,
  /// or they are the same cell.
  struct Way {
    CornerCost cost = kUnreachedCost;
    Cell first;
    Cell last;
    std::optional<Hub> hub;
    CornerCost cost_to_middle = 0;  // from the start to the hub, or to that cell
  };

  std::size_t number_of(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * width_ + static_cast<std::size_t>(cell.x);
  }
  Record record_of(Cell cell) const {
    return Record(sections_.records.data() + sections_.record_of_cell[number_of(cell)]);
  }

  Way way_by_hub(const Record& from, const Record& to);
  void note_sums(const Record& from);
  void forget_sums(const Record& from);
  void improve_by_sight(const Record& seen, Cell own, Cell other, Way& way) const;
  std::uint32_t place_of(Cell corner, Hub hub) const;
  template <int kWay>
  void follow(std::uint32_t place, RunWriter<kWay>& writer) const;

  IndexBytes index_;
  HubSections sections_;
  std::size_t width_;
  Sight sight_;
  std::vector<Sum> sums_;  // by hub: from the start; kNoSum between queries
  Cell start_;
  Cell goal_;
  Way way_;
  SearchMetrics metrics_;
};

extern template class HubEngine<std::uint16_t>;
extern template class HubEngine<std::uint32_t>;

}  // namespace wend
