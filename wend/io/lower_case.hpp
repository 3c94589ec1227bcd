#pragma once

// ASCII letters in lower case, the same in every locale.

#include <string>

namespace wend {

constexpr char lower_case(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

inline std::string lower_case(std::string text) {
  for (char& letter : text) letter = lower_case(letter);
  return text;
}

}  // namespace wend
