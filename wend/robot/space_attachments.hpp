#pragma once

// SpaceAttachments: what planners have prepared for a FreeSpace, so that the next planner on this space finds it.
//
// A planner asks its FreeSpace for an attachment of a type of its own: FreeSpace::attachment(). The first to ask
// makes it, and all others share it. It lives as long as the data of the space, or as somebody holds it.

#include <memory>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/mutex.hpp"
#include "wend/robot/space_change.hpp"

namespace wend {

/// A value that planners keep with a FreeSpace. It must not hold the FreeSpace. Threads may use it at the same time.
class WEND_API SpaceAttachment {
 public:
  virtual ~SpaceAttachment() = default;
  SpaceAttachment(const SpaceAttachment&) = delete;
  SpaceAttachment& operator=(const SpaceAttachment&) = delete;

  /// The space was edited in place. Nobody uses the attachment meanwhile.
  virtual void space_edited(const SpaceChange& change) = 0;

 protected:
  /// For derived classes.
  SpaceAttachment() = default;
};

class SpaceAttachments {
 public:
  /// None at first.
  SpaceAttachments() = default;
  /// Data that is copied is about to be edited: what was prepared for the original does not fit.
  SpaceAttachments(const SpaceAttachments& /*other*/) {}
  SpaceAttachments& operator=(const SpaceAttachments&) = delete;
  ~SpaceAttachments() = default;

  /// The attachment of a type; make() makes a std::shared_ptr of it if there is none.
  template <class T, class Make>
  std::shared_ptr<T> get(Make&& make) const {
    const MutexLock lock(mutex_);
    for (const auto& [type, value] : attachments_) {
      if (type == &kType<T>) return std::static_pointer_cast<T>(value);
    }
    std::shared_ptr<T> made = std::forward<Make>(make)();
    attachments_.push_back({&kType<T>, made});
    return made;
  }

  /// Tells the attachments of an edit in place. Those that somebody still holds stay as they are, and leave.
  void space_edited(const SpaceChange& change) {
    std::erase_if(attachments_, [](const Attached& each) {
      // Counting up and down sees what a thread did that has just let go (CopyOnWrite::change()).
      // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): the copy counts
      const std::shared_ptr<SpaceAttachment> held = each.value;
      return held.use_count() != 2;
    });
    for (const Attached& each : attachments_) each.value->space_edited(change);
  }

 private:
  /// Its address stands for a type, without the compiler's names of types.
  template <class T>
  static constexpr char kType = 0;

  struct Attached {
    const char* type;
    std::shared_ptr<SpaceAttachment> value;
  };

  mutable Mutex mutex_;  // guards the rest
  mutable std::vector<Attached> attachments_;
};

}  // namespace wend
