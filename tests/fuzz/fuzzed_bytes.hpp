#pragma once

// FuzzedBytes: takes values from any bytes at all.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace wend::test {

/// Values are 0 once there are no more bytes.
class FuzzedBytes {
 public:
  explicit FuzzedBytes(std::string_view bytes) : bytes_(bytes) {}

  bool empty() const { return bytes_.empty(); }

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const auto first = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return first;
  }

  /// Any value of this type.
  template <class Value>
  Value any() {
    Value value{};
    std::array<char, sizeof value> its_bytes{};
    for (char& each : its_bytes) each = static_cast<char>(byte());
    std::memcpy(&value, its_bytes.data(), sizeof value);
    return value;
  }

  /// Often a small number of tenths, else any double.
  double number() { return byte() < kOften ? 0.1 * byte() : any<double>(); }

  /// Often a small number, else any integer.
  template <class Integer>
  Integer integer() {
    return byte() < kOften ? static_cast<Integer>(byte()) : any<Integer>();
  }

  /// Up to the next NUL.
  std::string text() {
    const std::string found(bytes_.substr(0, bytes_.find('\0')));
    bytes_.remove_prefix(std::min(bytes_.size(), found.size() + 1));
    return found;
  }

  std::string_view rest() const { return bytes_; }

 private:
  static constexpr std::uint8_t kOften = 200;

  std::string_view bytes_;
};

}  // namespace wend::test
