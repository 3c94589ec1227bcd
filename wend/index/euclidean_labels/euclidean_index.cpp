#include "wend/index/euclidean_labels/euclidean_index.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "wend/geometry/trigonometry.hpp"
#include "wend/index/euclidean_labels/taut_labelling.hpp"
#include "wend/index/euclidean_labels/taut_order.hpp"
#include "wend/sight/taut_map.hpp"

namespace wend {
namespace {

using Failure = Unexpected<Error>;

constexpr std::size_t kMostBytesFactor = 4;  // of what searches allow a TautMap
constexpr std::uint32_t kCornersBetweenTelling = 64;
constexpr double kMapShare = 0.4;  // of the work, approximately
constexpr double kLabelsShare = 0.9;

Failure unsupported(std::string what) {
  return Failure({Status::unsupported_map, std::move(what)});
}

Failure cancelled() { return Failure({Status::cancelled, "the index was not finished"}); }

Expected<std::shared_ptr<const TautMap>, Error> make_map(
    const std::shared_ptr<const Portals>& portals, const IndexBuilding& building) {
  const std::size_t most_bytes = kMostBytesFactor * TautMap::usual_most_bytes(*portals);
  TautMapMaking making(portals, most_bytes);
  std::uint32_t asked = 0;
  const auto state = making.go_on([&](double share) {
    if (asked++ % kCornersBetweenTelling == 0) building.tell(kMapShare * share);
    return !building.cancelled();
  });
  if (state == TautMapMaking::State::unfinished || building.cancelled()) return cancelled();
  if (state == TautMapMaking::State::too_large) {
    return unsupported("what the corners of the map see takes more than " +
                       std::to_string(most_bytes >> 20U) +
                       " MiB, the most for a Euclidean label index; any_angle needs no index");
  }
  return making.take();
}

/// Labels all corners. False if it was cancelled.
bool label_corners(const TautGraph& graph, TautLabelling& labelling,
                   const IndexBuilding& building) {
  const std::vector<std::uint32_t> order = taut_order(graph, building);
  for (const std::uint32_t corner : order) {
    if (building.cancelled()) return false;
    if (labelling.hubs() % kCornersBetweenTelling == 0) {
      building.tell(kMapShare + (kLabelsShare - kMapShare) * labelling.hubs() /
                                    static_cast<double>(order.size()));
    }
    labelling.add_hub(corner);
  }
  return !building.cancelled();
}

bool has_too_long_paths(const TautLabelling& labelling) {
  return std::ranges::any_of(labelling.entries(), [](const TautLabelling::Entry& entry) {
    return entry.length > TautLabelSections::kLongestPath;
  });
}

}  // namespace

Expected<IndexBytes, Error> build_euclidean_index(const BitGrid& passable,
                                                  const IndexBuilding& building) {
  building.tell(0);
  const Deadline flag(Limits{.clock = {}, .cancel = building.cancel});
  DeadlineCheck stop(building.deadline != nullptr ? building.deadline : &flag);
  const auto portals = std::make_shared<const Portals>(passable, Portals::OpenGap(), stop);
  if (building.cancelled()) return cancelled();
  const std::size_t corners = portals->corners().size();
  if (corners > TautLabelSections::kMostCorners) {
    return unsupported("the map has " + std::to_string(corners) +
                       " corners of obstacles; a Euclidean label index takes at most " +
                       std::to_string(TautLabelSections::kMostCorners) +
                       "; any_angle needs no index");
  }
  const auto made = make_map(portals, building);
  if (!made) return Failure(made.error());
  const TautMap& map = **made;
  building.tell(kMapShare);
  TautLabelling labelling(map.graph());
  if (!label_corners(map.graph(), labelling, building)) return cancelled();
  if (has_too_long_paths(labelling)) {
    return unsupported("its paths are too long for a Euclidean label index");
  }
  building.tell(kLabelsShare);
  IndexWriter writer(kEuclideanLabels, TautLabelSections::kVersion, passable);
  TautLabelArrays(map, labelling).write(writer);
  building.tell(1);
  return writer.finish();
}

Expected<std::unique_ptr<EuclideanEngine>, Error> EuclideanEngine::open(IndexBytes index,
                                                                        const BitGrid& passable) {
  const auto reader =
      IndexReader::open(std::move(index), kEuclideanLabels, TautLabelSections::kVersion, passable);
  if (!reader) return Failure(reader.error());
  Portals portals(passable);
  const auto sections = TautLabelSections::of(*reader, portals);
  if (!sections) return Failure(sections.error());
  return std::unique_ptr<EuclideanEngine>(
      new EuclideanEngine(reader->index(), std::move(portals), *sections));
}

EuclideanEngine::EuclideanEngine(IndexBytes index, Portals portals,
                                 const TautLabelSections& sections)
    : index_(std::move(index)),
      portals_(std::move(portals)),
      sections_(sections),
      blocks_a_row_((static_cast<std::size_t>(portals_.width()) + TautLabelSections::kSide - 1) /
                    TautLabelSections::kSide),
      reached_(sections.corners.size()) {
  for (const std::uint32_t corner : sections.corners) {
    const TautCorner& at = portals_.corners()[corner];
    places_.push_back({2 * at.x, 2 * at.y});
  }
  touched_.reserve(reached_.size());
  path_.reserve(reached_.size());
}

/// Calls visit(hub, length from the cell, entry or kItself).
template <class Visit>
void EuclideanEngine::for_each_hub(Cell cell, Visit&& visit) {
  constexpr int kSide = TautLabelSections::kSide;
  const std::size_t block = static_cast<std::size_t>(cell.y / kSide) * blocks_a_row_ +
                            static_cast<std::size_t>(cell.x / kSide);
  const auto bit = static_cast<unsigned>(cell.y % kSide * kSide + cell.x % kSide);
  const std::uint32_t end = sections_.first_seen[block + 1];
  for (std::uint32_t i = sections_.first_seen[block]; i < end; ++i) {
    if ((sections_.cells[i] >> bit & 1U) == 0) continue;
    const SeenCorner& seen = sections_.seen[i];
    const Place place = places_[seen.corner];
    const auto x = static_cast<double>(place.x - 2 * cell.x - 1);
    const auto y = static_cast<double>(place.y - 2 * cell.y - 1);
    constexpr auto kHalfCell = static_cast<double>(kTautLengthUnit) / 2;
    const auto length =
        static_cast<TautLength>(static_cast<std::int64_t>(std::sqrt(x * x + y * y) * kHalfCell));
    visit(seen.corner, length, kItself);
    for (std::uint32_t entry = seen.begin; entry < seen.begin + seen.count; ++entry) {
      const TautLabelEntry& label = sections_.entries[entry];
      visit(label.hub, length + label.length, entry);
    }
    ++metrics_.expanded;
    metrics_.generated += seen.count + std::uint64_t{1};
  }
}

bool EuclideanEngine::find(Cell start, Cell goal) {
  path_.clear();
  metrics_ = {1, 1, 1};
  if (start == goal || portals_.sees(start, goal)) {
    length_ = hypotenuse(goal.x - start.x, goal.y - start.y);
    return true;
  }
  for_each_hub(start, [this](std::uint32_t hub, TautLength length, std::uint32_t entry) {
    Reached& reached = reached_[hub];
    if (length >= reached.length) return;
    if (reached.length == kNoTautLength) touched_.push_back(hub);
    reached = {length, entry};
  });
  Way best;
  for_each_hub(goal, [&](std::uint32_t hub, TautLength length, std::uint32_t entry) {
    const TautLength sum = reached_[hub].length + length;
    if (sum < best.length) best = {sum, hub, reached_[hub].entry, entry};
  });
  for (const std::uint32_t hub : touched_) reached_[hub].length = kNoTautLength;
  touched_.clear();
  if (best.length == kNoTautLength) return false;
  length_ = static_cast<double>(best.length) / static_cast<double>(kTautLengthUnit);
  append_corners(best.from_goal);
  std::ranges::reverse(path_);
  const auto middle = static_cast<std::ptrdiff_t>(path_.size());
  append_corners(best.from_start);
  path_.push_back(sections_.corners[best.hub]);
  std::ranges::rotate(path_, path_.begin() + middle);
  return true;
}

/// From that of the entry to the one before its hub.
void EuclideanEngine::append_corners(std::uint32_t entry) {
  for (; entry != kItself; entry = sections_.entries[entry].next) {
    path_.push_back(sections_.corners[sections_.entries[entry].corner]);
  }
}

}  // namespace wend
