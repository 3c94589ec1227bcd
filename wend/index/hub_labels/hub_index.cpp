#include "wend/index/hub_labels/hub_index.hpp"

#include <algorithm>
#include <optional>

#include "wend/index/corner_cost.hpp"
#include "wend/index/corner_graph.hpp"
#include "wend/index/file/index_sections.hpp"
#include "wend/index/first_corners.hpp"
#include "wend/index/hub_labels/hub_labelling.hpp"
#include "wend/index/hub_labels/hub_sections.hpp"
#include "wend/index/hub_labels/label_order.hpp"
#include "wend/map/grid.hpp"

namespace wend {
namespace {

using Failure = Unexpected<Error>;

constexpr int kMostRows = 65536;             // a cell is stored in two times 16 bits
constexpr std::size_t kMostCounted = 65535;  // hubs and corners of a record
constexpr double kLabelsShare = 0.9;         // of the work, approximately
constexpr std::uint32_t kHubsBetweenTelling = 64;
constexpr std::size_t kComponentsATask = 256;

Failure unsupported(std::string what) {
  return Failure({Status::unsupported_map, std::move(what)});
}

Failure cancelled() { return Failure({Status::cancelled, "the index was not finished"}); }

/// Labels all corners. False if it was cancelled.
bool label_corners(const CornerGraph& graph, const AllFirstCorners& first, HubLabelling& labelling,
                   const IndexBuilding& building) {
  LabelOrder order(graph, first, labelling, building);
  for (std::uint32_t hub = 0; hub < graph.size(); ++hub) {
    if (building.cancelled()) return false;
    if (hub % kHubsBetweenTelling == 0) {
      building.tell(kLabelsShare * hub / static_cast<double>(graph.size()));
    }
    labelling.add_hub(order.next());
  }
  building.tell(kLabelsShare);
  return !building.cancelled();
}

/// Writes the records of all corners and components, and which cell has which record.
template <class Hub>
class RecordWriter {
 public:
  RecordWriter(const Corners& corners, const AllFirstCorners& first, const HubLabelling& labelling)
      : corners_(corners),
        first_(first),
        labelling_(labelling),
        record_of_cell_(corners.passable().width(), corners.passable().height(),
                        HubSections::kNoRecord) {}

  const std::vector<std::uint32_t>& words() const { return words_; }
  std::span<const std::uint32_t> record_of_cell() const { return record_of_cell_.values(); }

  void add_corners(const HeavyPaths& paths, const IndexBuilding& building) {
    std::vector<typename HubRecord<Hub>::Part> parts(1);
    for (std::uint32_t corner = 0; corner < corners_.size(); ++corner) {
      if (building.cancelled()) return;
      fill(parts[0], corner, labelling_.label(corner));
      record_of_cell_[corners_.cell(corner)] = static_cast<std::uint32_t>(words_.size());
      HubRecord<Hub>::append(words_, parts, paths.places(corner), true);
    }
  }

  /// False if it was cancelled.
  bool add_components(const CellComponents& components, const IndexBuilding& building) {
    OneWorker alone;
    Workers& workers = building.workers != nullptr ? *building.workers : alone;
    std::vector<ComponentHubs> hubs(workers.count(), ComponentHubs(corners_, labelling_));
    const std::size_t tasks = (components.size() + kComponentsATask - 1) / kComponentsATask;
    std::vector<Written> written(tasks);
    workers.run(tasks, [&](std::size_t task, unsigned worker) {
      if (building.cancelled()) return;
      const std::size_t begin = task * kComponentsATask;
      const std::size_t end = std::min(begin + kComponentsATask, components.size());
      for (std::size_t component = begin; component < end && !building.cancelled(); ++component) {
        write_component(components.cells(component), hubs[worker], written[task]);
      }
    });
    if (building.cancelled()) return false;
    for (std::size_t task = 0; task < tasks; ++task) append(written[task], components, task);
    return true;
  }

 private:
  struct Written {
    std::vector<std::uint32_t> words;
    std::vector<std::size_t> begins;  // by component of the task
  };

  void write_component(std::span<const Cell> cells, ComponentHubs& hubs, Written& written) const {
    const auto first = first_.of(cells.front());
    const auto chosen = hubs.choose(cells, first);
    std::vector<typename HubRecord<Hub>::Part> parts(first.size());
    for (std::size_t i = 0; i < first.size(); ++i) fill(parts[i], first[i], chosen[i]);
    written.begins.push_back(written.words.size());
    HubRecord<Hub>::append(written.words, parts, {}, false);
  }

  void append(const Written& written, const CellComponents& components, std::size_t task) {
    for (std::size_t i = 0; i < written.begins.size(); ++i) {
      for (const Cell cell : components.cells(task * kComponentsATask + i)) {
        record_of_cell_[cell] = static_cast<std::uint32_t>(words_.size() + written.begins[i]);
      }
    }
    words_.insert(words_.end(), written.words.begin(), written.words.end());
  }

  void fill(typename HubRecord<Hub>::Part& part, std::uint32_t corner,
            std::span<const HubEntry> entries) const {
    part.cell = corners_.cell(corner);
    part.hubs.clear();
    part.costs.clear();
    for (const HubEntry& entry : entries) {
      part.hubs.push_back(static_cast<Hub>(entry.hub));
      part.costs.push_back(entry.cost);
    }
  }

  const Corners& corners_;
  const AllFirstCorners& first_;
  const HubLabelling& labelling_;
  std::vector<std::uint32_t> words_;
  Grid<std::uint32_t> record_of_cell_;
};

template <class Hub>
Expected<IndexBytes, Error> write_index(const CornerGraph& graph, const AllFirstCorners& first,
                                        const HubLabelling& labelling,
                                        const IndexBuilding& building) {
  const HeavyPaths paths(graph.corners(), labelling, building);
  if (building.cancelled()) return cancelled();
  const CellComponents components(graph.corners(), first, building);
  if (building.cancelled()) return cancelled();
  RecordWriter<Hub> records(graph.corners(), first, labelling);
  records.add_corners(paths, building);
  if (!records.add_components(components, building)) return cancelled();
  if (records.words().size() >= HubSections::kNoRecord || paths.words().size() >= run_word::kHub) {
    return unsupported("the map has too many corners for a label index");
  }
  const std::vector<std::uint64_t> hub_count{labelling.hubs()};
  IndexWriter writer(kHubLabels, HubSections::kVersion, graph.corners().passable());
  writer.add(std::span(hub_count));
  writer.add(records.record_of_cell());
  writer.add(std::span(records.words()));
  writer.add(paths.words());
  building.tell(1);
  return writer.finish();
}

/// What records cannot store; nullopt if they can store everything.
std::optional<std::string> fault_of(const CornerGraph& graph, const HubLabelling& labelling) {
  const BitGrid& passable = graph.corners().passable();
  const auto across = octile_cost<CornerCost>({0, 0}, {passable.width(), passable.height()});
  if (labelling.greatest_cost() + across >= kCostsOfOneKindOfPath / 2) {
    return "its paths are too long for a label index";
  }
  for (std::uint32_t corner = 0; corner < graph.size(); ++corner) {
    if (labelling.label(corner).size() > kMostCounted) {
      return "the map has too many corners for a label index";
    }
  }
  return std::nullopt;
}

}  // namespace

Expected<IndexBytes, Error> build_hub_index(const BitGrid& passable,
                                            const IndexBuilding& building) {
  if (passable.width() >= kMostRows / 2 || passable.height() >= kMostRows / 2) {
    return unsupported("a label index is for maps of fewer than 32768 rows and columns");
  }
  building.tell(0);
  Corners corners(passable, building);
  if (building.cancelled()) return cancelled();
  const CornerGraph graph(std::move(corners), building);
  if (building.cancelled()) return cancelled();
  const AllFirstCorners first(graph.corners(), building);
  if (building.cancelled()) return cancelled();
  HubLabelling labelling(graph, building);
  if (!label_corners(graph, first, labelling, building)) return cancelled();
  if (const auto fault = fault_of(graph, labelling)) return unsupported(*fault);
  return labelling.hubs() <= HubSections::kMostShortHubs
             ? write_index<std::uint16_t>(graph, first, labelling, building)
             : write_index<std::uint32_t>(graph, first, labelling, building);
}

Expected<std::unique_ptr<IndexEngine>, Error> open_hub_index(IndexBytes index,
                                                             const BitGrid& passable) {
  const auto reader =
      IndexReader::open(std::move(index), kHubLabels, HubSections::kVersion, passable);
  if (!reader) return Unexpected<Error>(reader.error());
  const auto sections = HubSections::of(*reader, passable);
  if (!sections) return Unexpected<Error>(sections.error());
  return make_hub_engine(reader->index(), *sections, passable);
}

}  // namespace wend
