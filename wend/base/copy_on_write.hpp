#pragma once

// CopyOnWrite: a value that its copies share until one of them changes it.
//
//   wend::CopyOnWrite<Data> data(...);
//   const wend::CopyOnWrite<Data> other = data;  // O(1)
//   data.change().width = 3;                      // copies the Data first: `other` keeps its own

#include <memory>
#include <utility>

namespace wend {

template <class T>
class CopyOnWrite {
 public:
  /// Makes the value from these arguments.
  template <class... Arguments>
  explicit CopyOnWrite(std::in_place_t /*in_place*/, Arguments&&... arguments)
      : value_(std::make_shared<T>(std::forward<Arguments>(arguments)...)) {}

  /// The value; not of an object that was moved from.
  const T& operator*() const { return *value_; }
  /// The same.
  const T* operator->() const { return value_.get(); }

  /// The value to change it: a copy if others share it. No other thread may use this object meanwhile.
  T& change() {
    if (value_.use_count() != 1) {
      value_ = std::make_shared<T>(std::as_const(*value_));
    } else {
      // Another thread may just have dropped the last copy but this one. Counting up and down sees what it
      // did before.
      const std::shared_ptr<T> seen = value_;
    }
    return *value_;
  }

 private:
  std::shared_ptr<T> value_;
};

}  // namespace wend
