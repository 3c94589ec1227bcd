#pragma once

// Replay: what a search did, so that every moment of it can be drawn. A moment is a number of expansions, its
// step. For each cell it keeps the step at which the search reached and expanded it, and what the search knew
// of it last. So a picture of any step takes O(pixels), whatever the number of expansions.
//
// A state that is not a cell (the vertex of a car) stands for the cells that it touches, as in SearchRecorder.
// 24 bytes a cell, 4 an expansion, 4 a cell that was reached. begin() clears only what the last search reached.

#include <cstdint>
#include <vector>

#include "wend/geometry/place_grid.hpp"
#include "wend/planner/observer.hpp"

namespace wend::lab {

class Replay final : public SearchObserver {
 public:
  /// No parent.
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// What the search knew of a cell. NaN: it never reached the cell.
  struct Known {
    float g;
    float h;
    float f;
  };

  /// Forgets everything. `places`: those of the planner.
  void begin(int width, int height, const PlaceGrid& places);

  void on_generate(const SearchEvent& event) override;
  void on_expand(const SearchEvent& event) override;
  void on_relax(const SearchEvent& event) override;

  int width() const { return width_; }
  int height() const { return height_; }

  /// The number of expansions.
  std::uint32_t steps() const { return static_cast<std::uint32_t>(expansions_.size()); }
  /// The cell that the expansion `step` (from 1) took.
  std::uint32_t expanded_at(std::uint32_t step) const { return expansions_[step - 1]; }

  /// For each cell: the step of its first expansion, from 1; 0: never.
  const std::vector<std::uint32_t>& expansion() const { return expansion_; }
  /// For each cell: the step whose expansion reached it, at least 1; 0: never. The start is there from the
  /// beginning, and has step 1.
  const std::vector<std::uint32_t>& generation() const { return generation_; }
  /// For each cell: the cell that it was reached from last, or kNone.
  const std::vector<std::uint32_t>& parent() const { return parent_; }
  /// For each cell: the last known costs.
  const std::vector<Known>& known() const { return known_; }

 private:
  template <class Visit>
  void for_cells_at(Cell place, Visit&& visit) const;
  std::uint32_t index(Cell cell) const;
  void write_down(const SearchEvent& event);
  /// Called before the first change of a cell.
  void reach(std::uint32_t cell);
  void clear_reached();

  int width_ = 0;
  int height_ = 0;
  int reach_ = 0;  // cells on each side of a vertex; 0: places are cells
  std::vector<std::uint32_t> expansion_;
  std::vector<std::uint32_t> generation_;
  std::vector<std::uint32_t> parent_;
  std::vector<Known> known_;
  std::vector<std::uint32_t> expansions_;
  std::vector<std::uint32_t> reached_;
};

}  // namespace wend::lab
