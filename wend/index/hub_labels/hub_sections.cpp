#include "wend/index/hub_labels/hub_sections.hpp"

#include <algorithm>
#include <vector>

#include "wend/index/hub_labels/hub_record.hpp"

namespace wend {
namespace {

using Fault = Unexpected<std::string>;

constexpr std::size_t kJointWords = 3;

/// Goes through the records from one to the next, and remembers where they begin.
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

  /// Do passable cells, and no others, have a record?
  bool cells_pass() const {
    std::size_t number = 0;
    for (int y = 0; y < passable_.height(); ++y) {
      for (int x = 0; x < passable_.width(); ++x) {
        const std::uint32_t record = sections_.record_of_cell[number++];
        const bool has_one = record < kinds_.size() && kinds_[record] != Kind::none;
        if (passable_[{x, y}] ? !has_one : record != HubSections::kNoRecord) return false;
      }
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

/// Reading on goes forwards but at joints, where the engine looks: so a joint must come before the
/// end, wherever reading begins.
bool runs_pass(std::span<const RunWord> runs) {
  return runs.size() >= kJointWords &&
         std::all_of(runs.end() - kJointWords, runs.end(),
                     [](RunWord word) { return word == run_word::kJoint; });
}

}  // namespace

Expected<HubSections, std::string> HubSections::of(const IndexReader& reader,
                                                   const BitGrid& passable) {
  const auto number = [](Section section) { return static_cast<std::size_t>(section); };
  const auto hub_count = reader.section<std::uint64_t>(number(Section::hub_count));
  const auto record_of_cell = reader.section<std::uint32_t>(number(Section::record_of_cell));
  const auto records = reader.section<std::uint32_t>(number(Section::records));
  const auto runs = reader.section<RunWord>(number(Section::runs));
  const auto cells =
      static_cast<std::size_t>(passable.width()) * static_cast<std::size_t>(passable.height());
  if (!hub_count || hub_count->size() != 1 || !record_of_cell || record_of_cell->size() != cells ||
      !records || !runs) {
    return Fault("its sections are not those of a label index");
  }
  const HubSections sections{static_cast<std::size_t>(hub_count->front()), *record_of_cell,
                             *records, *runs};
  if (sections.hub_count > cells) return Fault("it has more hubs than the map has cells");
  if (!runs_pass(sections.runs)) return Fault("its paths do not end");
  if (!records_pass(sections, passable)) return Fault("its records contradict each other");
  return sections;
}

}  // namespace wend
