#include "wend/index/euclidean_labels/taut_label_sections.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace wend {
namespace {

constexpr int kSide = TautLabelSections::kSide;
constexpr unsigned kRowBits = 8;
constexpr std::uint64_t kRow = 0xFF;

std::size_t blocks_along(int cells) {
  return (static_cast<std::size_t>(cells) + kSide - 1) / kSide;
}

/// Is each corner of the map there once?
bool corners_pass(std::span<const std::uint32_t> corners, const Portals& portals) {
  if (corners.size() != portals.corners().size()) return false;
  std::vector<std::uint8_t> is_there(corners.size(), 0);
  return std::ranges::all_of(corners, [&](std::uint32_t corner) {
    return corner < is_there.size() && is_there[corner]++ == 0;
  });
}

bool blocks_pass(const TautLabelSections& sections) {
  const auto& first = sections.first_seen;
  return first.front() == 0 && first.back() == sections.seen.size() &&
         std::ranges::is_sorted(first) &&
         std::ranges::all_of(sections.seen, [&](const SeenCorner& seen) {
           return seen.corner < sections.corners.size() && seen.begin <= sections.entries.size() &&
                  seen.count <= sections.entries.size() - seen.begin;
         });
}

/// The path of an entry goes on by a shorter one to the same hub, so it ends.
bool entries_pass(const TautLabelSections& sections) {
  return std::ranges::all_of(sections.entries, [&](const TautLabelEntry& entry) {
    if (entry.length >= kNoTautLength / 2 || entry.hub >= sections.corners.size() ||
        entry.corner >= sections.corners.size()) {
      return false;
    }
    if (entry.next == TautLabelEntry::kHub) return true;
    if (entry.next >= sections.entries.size()) return false;
    const TautLabelEntry& next = sections.entries[entry.next];
    return next.hub == entry.hub && next.length < entry.length;
  });
}

/// The cells of a block, as their bits have them.
struct Box {
  int left;
  int right;
  int low;
  int high;
};

Box box_of(std::uint64_t cells) {
  std::uint64_t columns = cells;
  for (const unsigned shift : {32U, 16U, 8U}) columns |= columns >> shift;
  const auto row = static_cast<unsigned>(columns & kRow);
  const auto first = static_cast<int>(std::countr_zero(cells));
  const auto last = static_cast<int>(std::bit_width(cells)) - 1;
  return {static_cast<int>(std::countr_zero(row)), static_cast<int>(std::bit_width(row)) - 1,
          first / kSide, last / kSide};
}

TautLength whole_length(double cells) {
  return static_cast<TautLength>(std::llround(cells * static_cast<double>(kTautLengthUnit)));
}

}  // namespace

Expected<TautLabelSections, Error> TautLabelSections::of(const IndexReader& reader,
                                                         const Portals& portals) {
  const auto number = [](Section section) { return static_cast<std::size_t>(section); };
  const auto corners = reader.section<std::uint32_t>(number(Section::corners));
  const auto first_seen = reader.section<std::uint32_t>(number(Section::first_seen));
  const auto seen = reader.section<SeenCorner>(number(Section::seen));
  const auto cells = reader.section<std::uint64_t>(number(Section::cells));
  const auto entries = reader.section<TautLabelEntry>(number(Section::entries));
  const std::size_t blocks = blocks_along(portals.width()) * blocks_along(portals.height());
  if (!corners || !first_seen || first_seen->size() != blocks + 1 || !seen || !cells ||
      cells->size() != seen->size() || !entries) {
    return index_failure("its sections are not those of a Euclidean label index");
  }
  const TautLabelSections sections{*corners, *first_seen, *seen, *cells, *entries};
  if (!corners_pass(sections.corners, portals)) {
    return index_failure("its corners are not those of the map");
  }
  if (!blocks_pass(sections)) return index_failure("its blocks contradict each other");
  if (!entries_pass(sections)) return index_failure("its paths do not end");
  return sections;
}

TautLabelArrays::TautLabelArrays(const TautMap& map, const TautLabelling& labelling) : map_(map) {
  for (std::uint32_t hub = 0; hub < labelling.hubs(); ++hub) {
    corners_.push_back(labelling.corner_of(hub));
  }
  add_entries(labelling);
  for (std::size_t block = 0; block < map.blocks(); ++block) add_block(block, labelling);
  first_seen_.push_back(static_cast<std::uint32_t>(seen_.size()));
}

/// Sorts them by their first edge; the edges of a corner follow each other.
void TautLabelArrays::add_entries(const TautLabelling& labelling) {
  const auto entries = labelling.entries();
  first_entry_.assign(map_.graph().edges() + 1, 0);
  for (const TautLabelling::Entry& entry : entries) ++first_entry_[entry.edge + 1];
  for (std::size_t i = 1; i < first_entry_.size(); ++i) first_entry_[i] += first_entry_[i - 1];
  std::vector<std::uint32_t> next(first_entry_.begin(), first_entry_.end() - 1);
  std::vector<std::uint32_t> places;
  for (const TautLabelling::Entry& entry : entries) places.push_back(next[entry.edge]++);
  entries_.resize(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const TautLabelling::Entry& entry = entries[i];
    entries_[places[i]] = {
        whole_length(entry.length),
        entry.next == TautLabelling::kNone ? TautLabelEntry::kHub : places[entry.next],
        static_cast<std::uint16_t>(entry.hub),
        static_cast<std::uint16_t>(labelling.hub_of(entry.corner))};
  }
}

void TautLabelArrays::add_block(std::size_t block, const TautLabelling& labelling) {
  first_seen_.push_back(static_cast<std::uint32_t>(seen_.size()));
  const int y = static_cast<int>(block / map_.blocks_a_row()) * kSide;
  map_.for_each_word(block, [&](std::uint32_t corner, std::uint64_t cells) {
    const int rows_below = map_.graph().portals().corners()[corner].y - y;
    std::uint64_t below = 0;
    if (rows_below >= kSide) {
      below = cells;
    } else if (rows_below > 0) {
      const unsigned bits = kRowBits * static_cast<unsigned>(rows_below);
      below = cells & ((std::uint64_t{1} << bits) - 1);
    }
    if (below != 0) add_seen(block, corner, below, labelling);
    if (below != cells) add_seen(block, corner, cells & ~below, labelling);
  });
}

/// All that lies ahead of the two outermost cells of a box around them.
void TautLabelArrays::add_seen(std::size_t block, std::uint32_t corner, std::uint64_t cells,
                               const TautLabelling& labelling) {
  const TautGraph& graph = map_.graph();
  const TautCorner& at = graph.portals().corners()[corner];
  const int x0 = static_cast<int>(block % map_.blocks_a_row()) * kSide;
  const int y0 = static_cast<int>(block / map_.blocks_a_row()) * kSide;
  const Box box = box_of(cells);
  const auto ahead_of = [&](int x, int y) {
    return graph.known_ahead_of(
        corner, {2 * (std::int64_t{at.x} - x0 - x) - 1, 2 * (std::int64_t{at.y} - y0 - y) - 1});
  };
  // The cells lie high right or low left of a corner where taut lines rise: the outermost ones high left and low right.
  const bool falls = at.rising == 1;
  const TautGraph::Edges one = ahead_of(box.left, falls ? box.high : box.low);
  const TautGraph::Edges other = ahead_of(box.right, falls ? box.low : box.high);
  const std::uint32_t begin = first_entry_[std::min(one.begin, other.begin)];
  const std::uint32_t end = first_entry_[std::max(one.end, other.end)];
  seen_.push_back({begin, static_cast<std::uint16_t>(end - begin),
                   static_cast<std::uint16_t>(labelling.hub_of(corner))});
  cells_.push_back(cells);
}

void TautLabelArrays::write(IndexWriter& writer) const {
  writer.add(std::span(corners_));
  writer.add(std::span(first_seen_));
  writer.add(std::span(seen_));
  writer.add(std::span(cells_));
  writer.add(std::span(entries_));
}

}  // namespace wend
