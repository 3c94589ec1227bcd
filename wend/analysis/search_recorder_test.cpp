// The recorder on a car's search, by hand and against the definition: a cell takes the events of
// the vertices that it touches. Searches on cells are in tests/watching/search_recorder_test.cpp.

#include "wend/analysis/search_recorder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "tests/testing/drawn_map.hpp"
#include "wend/base/random.hpp"

namespace wend {
namespace {

SearchEvent event_at(Cell corner, double g, std::optional<Cell> parent = std::nullopt) {
  return {.cell = corner,
          .parent = parent,
          .g = g,
          .h = 10 - g,
          .f = 10,
          .heading = 0,
          .parent_heading = parent ? std::optional(0.0) : std::nullopt};
}

/// The numbers of a layer, a line for each row; '.' for an unset cell.
template <class Value>
std::string text_of(const Grid<Value>& grid) {
  std::string text;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const auto value = grid[{x, y}];
      const bool none = std::isnan(static_cast<double>(value)) || value == 0;
      text += none ? "." : std::to_string(static_cast<int>(value));
    }
    text += '\n';
  }
  return text;
}

std::string text_of(const SearchSnapshot& snapshot) {
  std::string text;
  for (int y = 0; y < snapshot.expanded.height(); ++y) {
    for (int x = 0; x < snapshot.expanded.width(); ++x) {
      const Cell cell{x, y};
      text += cell == snapshot.current  ? 'C'
              : snapshot.expanded[cell] ? 'x'
              : snapshot.frontier[cell] ? 'o'
                                        : '.';
    }
    text += '\n';
  }
  return text;
}

TEST(SearchRecorderOfACar, TellsOfTheCellsAroundACorner) {
  const FreeSpace space = test::open_space(4, 3);
  SearchRecorder recorder(space, corners_of(space));
  recorder.on_generate(event_at({0, 0}, 0));
  recorder.on_expand(event_at({0, 0}, 0));
  recorder.on_generate(event_at({1, 1}, 2, Cell{0, 0}));
  recorder.on_generate(event_at({4, 3}, 3, Cell{1, 1}));  // the last corner there is
  EXPECT_EQ(text_of(recorder.layers().generation), "12..\n22..\n...3\n");
  EXPECT_EQ(text_of(recorder.layers().expansion), "1...\n....\n....\n");
  EXPECT_EQ(text_of(recorder.layers().g), ".2..\n22..\n...3\n") << "0 of the start is shown as '.'";
  EXPECT_EQ(recorder.layers().h[(Cell{0, 0})], 10);
  EXPECT_EQ(recorder.layers().h[(Cell{1, 0})], 8);
  EXPECT_EQ(recorder.layers().parent[(Cell{1, 1})], Direction::minus_x_minus_y);
  EXPECT_EQ(recorder.layers().parent[(Cell{0, 0})], std::nullopt);
  EXPECT_EQ(text_of(recorder.snapshot()), "Co..\noo..\n...o\n");
}

TEST(SearchRecorderOfACar, FillsTheSquaresOfItsUnitAndWhatIsLeftAtTheEdge) {
  const FreeSpace space = test::open_space(5, 4);
  SearchRecorder recorder(space, corners_of(space, 2));
  recorder.on_generate(event_at({4, 2}, 1));
  EXPECT_EQ(text_of(recorder.layers().generation), "..111\n..111\n..111\n..111\n");
  recorder.on_generate(event_at({0, 4}, 1));
  EXPECT_EQ(text_of(recorder.layers().generation), "..111\n..111\n22111\n22111\n");
}

TEST(SearchRecorderOfACar, KeepsTheCheapestStateAroundACell) {
  const FreeSpace space = test::open_space(2, 1);
  SearchRecorder recorder(space, corners_of(space));
  recorder.on_generate(event_at({1, 0}, 5, Cell{0, 0}));
  recorder.on_generate(event_at({1, 1}, 4, Cell{1, 0}));
  recorder.on_generate(event_at({1, 1}, 7, Cell{0, 0}));  // facing elsewhere
  EXPECT_EQ(text_of(recorder.layers().g), "44\n");
  EXPECT_EQ(recorder.layers().parent[(Cell{0, 0})], Direction::minus_y);
  recorder.on_relax(event_at({1, 1}, 6, Cell{0, 1}));
  EXPECT_EQ(text_of(recorder.layers().g), "44\n");
  recorder.on_relax(event_at({2, 0}, 3, Cell{1, 0}));
  EXPECT_EQ(text_of(recorder.layers().g), "43\n");
  EXPECT_EQ(recorder.layers().h[(Cell{1, 0})], 7);
  EXPECT_EQ(recorder.layers().parent[(Cell{1, 0})], Direction::minus_x);
}

TEST(SearchRecorderOfACar, CountsEveryStateOfACorner) {
  const FreeSpace space = test::open_space(3, 1);
  SearchRecorder recorder(space, corners_of(space));
  recorder.on_generate(event_at({0, 0}, 0));
  recorder.on_generate(event_at({0, 0}, 1, Cell{1, 0}));
  recorder.on_expand(event_at({0, 0}, 0));
  recorder.on_generate(event_at({3, 1}, 1, Cell{0, 0}));
  recorder.on_expand(event_at({0, 0}, 1, Cell{1, 0}));
  recorder.on_expand(event_at({3, 1}, 1, Cell{0, 0}));
  EXPECT_EQ(recorder.expansions(), (std::vector<Cell>{{0, 0}, {0, 0}, {3, 1}}));
  EXPECT_EQ(text_of(recorder.layers().generation), "1.3\n");
  EXPECT_EQ(text_of(recorder.snapshot(0)), "o..\n");
  EXPECT_EQ(text_of(recorder.snapshot(1)), "C.o\n");
  EXPECT_EQ(text_of(recorder.snapshot(2)), "C.o\n");
  EXPECT_EQ(text_of(recorder.snapshot(3)), "x.C\n");
}

enum class Kind { generate, expand, relax };

struct Entry {
  Kind kind;
  SearchEvent event;
};

/// A search that makes no sense but that of its events: some generated, expanded and relaxed.
std::vector<Entry> random_entries(Random& random, int width, int height, int unit) {
  std::vector<Entry> entries;
  const auto corner = [&] {
    return Cell{unit * random.between(0, width / unit), unit * random.between(0, height / unit)};
  };
  for (int count = random.between(0, 30); count > 0; --count) {
    const Cell at = corner();
    const auto kind = static_cast<Kind>(random.between(0, 2));
    SearchEvent event = event_at(at, random.between(0, 6), corner());
    if (event.parent == at) event.parent.reset();
    event.h = random.between(0, 50);
    event.f = random.between(0, 50);
    entries.push_back({kind, event});
  }
  return entries;
}

bool touches(Cell cell, Cell corner, int unit) {
  const auto near = [unit](int place, int line) {
    const int square = place / unit;
    return line == square * unit || line == (square + 1) * unit;
  };
  return near(cell.x, corner.x) && near(cell.y, corner.y);
}

/// What the first events, up to a given number, say about one cell.
struct Known {
  std::uint32_t generation = 0;
  std::uint32_t expansion = 0;
  std::optional<SearchEvent> cheapest;
};

Known known_of(Cell cell, const std::vector<Entry>& entries, std::size_t count, int unit) {
  Known known;
  std::uint32_t generated = 0;
  std::uint32_t expanded = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [kind, event] = entries[i];
    generated += kind == Kind::generate ? 1 : 0;
    expanded += kind == Kind::expand ? 1 : 0;
    if (!touches(cell, event.cell, unit)) continue;
    if (kind == Kind::generate && known.generation == 0) known.generation = generated;
    if (kind == Kind::expand && known.expansion == 0) known.expansion = expanded;
    if (kind == Kind::expand) continue;
    if (!known.cheapest || event.g < known.cheapest->g) known.cheapest = event;
  }
  return known;
}

std::optional<Direction> direction_to_parent(const SearchEvent& event) {
  if (!event.parent) return std::nullopt;
  return nearest_direction(event.cell, *event.parent);
}

RC_GTEST_PROP(SearchRecorderOfACar, KnowsOfACellWhatItsCornersSay, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  Random random(seed);
  const int width = random.between(1, 9);
  const int height = random.between(1, 9);
  const int unit = random.between(1, 5);
  const auto entries = random_entries(random, width, height, unit);
  const FreeSpace space = test::open_space(width, height);
  SearchRecorder recorder(space, corners_of(space, unit));
  std::vector<std::size_t> ends;  // how many events there were before each expansion
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto& [kind, event] = entries[i];
    if (kind == Kind::generate) recorder.on_generate(event);
    if (kind == Kind::relax) recorder.on_relax(event);
    if (kind != Kind::expand) continue;
    ends.push_back(i);
    recorder.on_expand(event);
  }
  ends.push_back(entries.size());
  const std::size_t moment = random.below(ends.size());
  const SearchSnapshot snapshot = recorder.snapshot(moment);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Cell cell{x, y};
      RC_LOG() << "seed " << seed << ", cell " << x << "," << y << ", moment " << moment << '\n';
      const Known known = known_of(cell, entries, entries.size(), unit);
      const SearchLayers& layers = recorder.layers();
      RC_ASSERT(layers.generation[cell] == known.generation);
      RC_ASSERT(layers.expansion[cell] == known.expansion);
      RC_ASSERT(std::isnan(layers.g[cell]) == !known.cheapest);
      if (known.cheapest) {
        RC_ASSERT(layers.g[cell] == known.cheapest->g);
        RC_ASSERT(layers.h[cell] == known.cheapest->h);
        RC_ASSERT(layers.f[cell] == known.cheapest->f);
        RC_ASSERT(layers.parent[cell] == direction_to_parent(*known.cheapest));
      }
      const Known then = known_of(cell, entries, ends[moment], unit);
      const bool expanded = then.expansion != 0;
      RC_ASSERT(snapshot.expanded[cell] == (expanded && then.generation != 0));
      RC_ASSERT(snapshot.frontier[cell] == (!expanded && then.generation != 0));
    }
  }
}

}  // namespace
}  // namespace wend
