#include "wend/sight/taut_map.hpp"

#include <algorithm>
#include <utility>

namespace wend {

TautMap::TautMap(std::shared_ptr<const Portals> portals)
    : graph_(std::move(portals)),
      columns_((static_cast<std::size_t>(graph_.portals().width()) + kSide - 1) / kSide),
      seen_(columns_ *
            ((static_cast<std::size_t>(graph_.portals().height()) + kSide - 1) / kSide)) {}

std::size_t TautMap::usual_most_bytes(const Portals& portals) {
  constexpr std::size_t kBytesACell = 64;
  const auto width = static_cast<std::size_t>(portals.width());
  return (std::size_t{1} << 20U) + kBytesACell * width * static_cast<std::size_t>(portals.height());
}

std::shared_ptr<const TautMap> TautMap::make(std::shared_ptr<const Portals> portals,
                                             std::size_t most_bytes) {
  TautMapMaking making(std::move(portals), most_bytes);
  const auto state = making.go_on([](double) { return true; });
  return state == TautMapMaking::State::finished ? making.take() : nullptr;
}

void TautMap::look_around(std::uint32_t corner, std::vector<Entry>& entries) {
  graph_.learn(corner, [this](int y, int first, int last) { see(y, first, last); });
  for (const std::uint32_t block : touched_) {
    entries.push_back({block, corner, std::exchange(seen_[block], 0)});
  }
  touched_.clear();
}

void TautMap::see(int y, int first, int last) {
  const auto row = static_cast<unsigned>(y % kSide * kSide);
  for (int begin = first / kSide * kSide; begin <= last; begin += kSide) {
    const auto skipped = static_cast<unsigned>(std::max(first - begin, 0));
    const auto left_out = static_cast<unsigned>(std::max(begin + kSide - 1 - last, 0));
    const std::uint64_t cells = (0xFFU << skipped) & (0xFFU >> left_out);
    const std::size_t block = block_of(begin, y);
    if (seen_[block] == 0) touched_.push_back(static_cast<std::uint32_t>(block));
    seen_[block] |= cells << row;
  }
}

/// Sorts by blocks, and keeps the order of corners.
void TautMap::store(const std::vector<Entry>& entries) {
  first_.assign(seen_.size() + 1, 0);
  for (const Entry& entry : entries) ++first_[entry.block + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  words_.resize(entries.size());
  corners_.resize(entries.size());
  for (const Entry& entry : entries) {
    const std::uint32_t at = next[entry.block]++;
    words_[at] = entry.cells;
    corners_[at] = entry.corner;
  }
  seen_ = {};
  touched_ = {};
}

TautMapMaking::TautMapMaking(std::shared_ptr<const Portals> portals, std::size_t most_bytes)
    : map_(new TautMap(std::move(portals))), most_bytes_(most_bytes) {}

TautMapMaking::State TautMapMaking::go_on(const std::function<bool(double share)>& goes_on) {
  constexpr std::size_t kBytesAWord = sizeof(std::uint64_t) + sizeof(std::uint32_t);
  TautGraph& graph = map_->graph_;
  const auto corners = static_cast<std::uint32_t>(graph.portals().corners().size());
  for (; next_ < corners; ++next_) {
    if (!goes_on(static_cast<double>(next_) / corners)) return State::unfinished;
    map_->look_around(next_, entries_);
    if (entries_.size() * kBytesAWord + graph.edges() * sizeof(TautGraph::Edge) > most_bytes_) {
      return State::too_large;
    }
  }
  map_->store(entries_);
  entries_ = {};
  graph.learn_ahead();
  return State::finished;
}

}  // namespace wend
