#include "wend/index/hub_labels/hub_sections.hpp"

#include <algorithm>
#include <cstdlib>
#include <ranges>

namespace wend {
namespace {

constexpr std::size_t kJointWords = 3;

/// Checks one record after the other, and remembers where they begin.
template <class Hub>
class RecordCheck {
 public:
  RecordCheck(const HubSections& sections, const BitGrid& passable)
      : sections_(sections), passable_(passable), kinds_(sections.records.size(), Kind::none) {}

  bool passes() {
    const auto records = sections_.records;
    for (std::size_t begin = 0; begin < records.size();) {
      if (records.size() - begin < HubRecord<Hub>::kHeaderWords) return false;
      const HubRecord<Hub> record(records.data() + begin);
      if (!passes(record, records.size() - begin)) return false;
      kinds_[begin] = record.is_corner() ? Kind::corner : Kind::component;
      begin += record.size();
    }
    return cells_pass() && corners_pass();
  }

 private:
  enum class Kind : std::uint8_t { none, component, corner };

  bool passes(const HubRecord<Hub>& record, std::size_t room) const {
    if (record.hub_count() > room || record.size() > room) return false;
    if (record.is_corner() && record.corner_count() != 1) return false;
    std::size_t counted = 0;
    for (std::uint32_t i = 0; i < record.corner_count(); ++i) counted += record.count(i);
    if (counted != record.hub_count()) return false;
    const auto hubs = record.hubs();
    if (!std::all_of(hubs.begin(), hubs.end(),
                     [&](Hub hub) { return hub < sections_.hub_count; })) {
      return false;
    }
    for (std::uint32_t i = 0; record.is_corner() && i < record.hub_count(); ++i) {
      const std::uint32_t place = record.place(i);
      if (place != run_word::kHub && place >= sections_.runs.size()) return false;
    }
    return true;
  }

  /// Do exactly the passable cells have a record?
  bool cells_pass() const {
    std::size_t number = 0;
    for (const Cell cell : every_cell(passable_)) {
      const std::uint32_t record = sections_.record_of_cell[number++];
      const bool has_one = record < kinds_.size() && kinds_[record] != Kind::none;
      if (passable_[cell] ? !has_one : record != HubSections::kNoRecord) return false;
    }
    return true;
  }

  /// Do the corners that records name have records of corners?
  bool corners_pass() const {
    const auto width = static_cast<std::size_t>(passable_.width());
    for (std::size_t begin = 0; begin < kinds_.size();) {
      const HubRecord<Hub> record(sections_.records.data() + begin);
      for (std::uint32_t i = 0; i < record.corner_count(); ++i) {
        const Cell cell = record.cell(i);
        if (!passable_.contains(cell) || !passable_[cell]) return false;
        const std::size_t number =
            static_cast<std::size_t>(cell.y) * width + static_cast<std::size_t>(cell.x);
        if (kinds_[sections_.record_of_cell[number]] != Kind::corner) return false;
      }
      begin += record.size();
    }
    return true;
  }

  const HubSections& sections_;
  const BitGrid& passable_;
  std::vector<Kind> kinds_;  // of the record that begins at a word
};

bool records_pass(const HubSections& sections, const BitGrid& passable) {
  return sections.hub_count <= HubSections::kMostShortHubs
             ? RecordCheck<std::uint16_t>(sections, passable).passes()
             : RecordCheck<std::uint32_t>(sections, passable).passes();
}

/// The engine reads forwards without checks until a joint. So a joint must come before the end, wherever
/// reading begins.
bool runs_pass(std::span<const RunWord> runs) {
  return runs.size() >= kJointWords &&
         std::all_of(runs.end() - kJointWords, runs.end(),
                     [](RunWord word) { return word == run_word::kJoint; });
}

constexpr std::uint32_t kNone = HubTreeNode::kRoot;
constexpr unsigned kHalf = 16;  // bits

}  // namespace

Expected<HubSections, Error> HubSections::of(const IndexReader& reader, const BitGrid& passable) {
  const auto number = [](Section section) { return static_cast<std::size_t>(section); };
  const auto hub_count = reader.section<std::uint64_t>(number(Section::hub_count));
  const auto record_of_cell = reader.section<std::uint32_t>(number(Section::record_of_cell));
  const auto records = reader.section<std::uint32_t>(number(Section::records));
  const auto runs = reader.section<RunWord>(number(Section::runs));
  const auto cells =
      static_cast<std::size_t>(passable.width()) * static_cast<std::size_t>(passable.height());
  if (!hub_count || hub_count->size() != 1 || !record_of_cell || record_of_cell->size() != cells ||
      !records || !runs) {
    return index_failure("its sections are not those of a label index");
  }
  const HubSections sections{static_cast<std::size_t>(hub_count->front()), *record_of_cell,
                             *records, *runs};
  if (sections.hub_count > cells) return index_failure("it has more hubs than the map has cells");
  if (!runs_pass(sections.runs)) return index_failure("its paths do not end");
  if (!records_pass(sections, passable)) return index_failure("its records contradict each other");
  return sections;
}

HeavyPaths::HeavyPaths(const Corners& corners, const HubLabelling& labelling,
                       const IndexBuilding& building)
    : corners_(corners), begins_{0} {
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    begins_.push_back(begins_.back() + labelling.label(corner).size());
  }
  places_.resize(begins_.back());
  next_ = begins_;
  for (std::uint32_t hub = 0; hub < labelling.hubs(); ++hub) {
    if (building.cancelled()) return;
    add_tree(labelling.tree(hub));
  }
  add_joint(0);  // the end
}

void HeavyPaths::add_tree(std::span<const HubTreeNode> tree) {
  below_.assign(tree.size(), 1);
  heavy_.assign(tree.size(), kNone);
  starts_.resize(tree.size());
  for (auto node = static_cast<std::uint32_t>(tree.size()); node-- > 1;) {
    const std::uint32_t parent = tree[node].parent;
    below_[parent] += below_[node];
    std::uint32_t& heavy = heavy_[parent];
    if (heavy == kNone || below_[node] > below_[heavy]) heavy = node;
  }
  starts_[0] = run_word::kHub;
  for (std::uint32_t node = 1; node < tree.size(); ++node) {
    const std::uint32_t parent = tree[node].parent;
    if (parent == 0 || heavy_[parent] != node) add_path(tree, node);
  }
  for (std::uint32_t node = 0; node < tree.size(); ++node) {
    places_[next_[tree[node].corner]++] = starts_[node];
  }
}

void HeavyPaths::add_path(std::span<const HubTreeNode> tree, std::uint32_t top) {
  path_.clear();
  for (std::uint32_t node = top; node != kNone; node = heavy_[node]) path_.push_back(node);
  for (const std::uint32_t node : path_ | std::views::reverse) {
    starts_[node] = static_cast<std::uint32_t>(words_.size());
    add_way(corners_.cell(tree[node].corner), corners_.cell(tree[tree[node].parent].corner));
  }
  add_joint(starts_[tree[top].parent]);
}

void HeavyPaths::add_way(Cell from, Cell to) {
  while (from != to) {
    const Cell way{to.x - from.x, to.y - from.y};
    const Cell sign{(way.x > 0) - (way.x < 0), (way.y > 0) - (way.y < 0)};
    const int wide = std::abs(way.x);
    const int high = std::abs(way.y);
    const int length = sign.x != 0 && sign.y != 0 ? std::min(wide, high) : std::max(wide, high);
    const int steps = std::min(length, run_word::kMostSteps);
    words_.push_back(run_word::of(steps, direction_of(sign)));
    from = {from.x + steps * sign.x, from.y + steps * sign.y};
  }
}

void HeavyPaths::add_joint(std::uint32_t place) {
  words_.push_back(run_word::kJoint);
  words_.push_back(static_cast<RunWord>(place));
  words_.push_back(static_cast<RunWord>(place >> kHalf));
}

}  // namespace wend
