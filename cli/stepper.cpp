#include "stepper.hpp"

#include <limits>

namespace wend::cli {
namespace {

constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kLeap = 10;
constexpr const char* kKeys = "any key: next   t: ten more   r: run to the end   q: quit\n";

}  // namespace

void Stepper::ask(const std::string& picture, std::uint64_t expansions) {
  display_.show(picture + kKeys);
  const auto key = keyboard_.read();
  quit_ = key == 'q';
  if (key == 't') {
    next_ = expansions + kLeap;
  } else if (key == 'r' || !key) {  // at the end of the input there is nobody to ask
    next_ = kNever;
  } else {
    next_ = expansions + 1;
  }
}

}  // namespace wend::cli
