#include "wend/session/kept_field.hpp"

#include <utility>

namespace wend {

Expected<KeptField::Answer, PlanFailure> KeptField::get(const FreeSpace& space,
                                                        std::uint64_t version,
                                                        std::vector<Cell> goals, GridMoves moves,
                                                        const Limits& limits) {
  const std::shared_ptr<Slot> slot = slot_for(version, std::move(goals), moves);
  const MutexLock lock(slot->mutex);
  if (slot->costs) return Answer{slot->costs};
  auto made = CostToGo::make(space, slot->goals, moves, limits);
  if (!made) return Unexpected<PlanFailure>(std::move(made.error()));
  const SearchMetrics metrics = made->metrics();
  slot->costs = std::make_shared<const CostToGo>(*std::move(made));
  return Answer{slot->costs, metrics};
}

void KeptField::forget() {
  std::shared_ptr<Slot> forgotten;  // its memory is freed without the lock
  const MutexLock lock(mutex_);
  forgotten = std::move(slot_);
}

std::shared_ptr<KeptField::Slot> KeptField::slot_for(std::uint64_t version, std::vector<Cell> goals,
                                                     GridMoves moves) {
  const MutexLock lock(mutex_);
  const bool same =
      slot_ && slot_->version == version && slot_->goals == goals && slot_->moves == moves;
  if (!same) slot_ = std::make_shared<Slot>(version, std::move(goals), moves);
  return slot_;
}

}  // namespace wend
