#pragma once

// Json: writes JSON text, for answers to the page. The caller keeps the order right: key() before each value of
// an object.
//
//   Json json;
//   json.object().key("cost").value(12.5).end_object();

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "wend/base/parse.hpp"

namespace wend::lab {

class Json {
 public:
  Json& object() { return open('{'); }
  Json& end_object() { return close('}'); }
  Json& array() { return open('['); }
  Json& end_array() { return close(']'); }

  Json& key(std::string_view name) {
    value(name);
    text_ += ':';
    first_ = true;
    return *this;
  }

  Json& value(std::string_view text) {
    separate();
    text_ += '"';
    for (const char letter : text) append(letter);
    text_ += '"';
    return *this;
  }
  Json& value(const char* text) { return value(std::string_view(text)); }
  Json& value(bool flag) { return raw(flag ? "true" : "false"); }
  /// NaN and infinity become null.
  Json& value(double number) {
    const bool finite = number - number == 0;
    return raw(finite ? format_number(number) : "null");
  }
  template <std::integral Integer>
  Json& value(Integer number) {
    return raw(std::to_string(number));
  }

  template <class Value>
  Json& field(std::string_view name, const Value& its_value) {
    return key(name).value(its_value);
  }

  const std::string& text() const { return text_; }

 private:
  Json& open(char bracket) {
    separate();
    text_ += bracket;
    first_ = true;
    return *this;
  }
  Json& close(char bracket) {
    text_ += bracket;
    first_ = false;
    return *this;
  }
  Json& raw(std::string_view text) {
    separate();
    text_ += text;
    return *this;
  }
  void separate() {
    if (!first_) text_ += ',';
    first_ = false;
  }
  void append(char letter) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      text_ += '\\';
      text_ += letter;
    } else if (code < 0x20) {
      text_ += "\\u00";
      text_ += kDigits[code >> 4U];
      text_ += kDigits[code & 0xFU];
    } else {
      text_ += letter;
    }
  }

  std::string text_;
  bool first_ = true;
};

}  // namespace wend::lab
