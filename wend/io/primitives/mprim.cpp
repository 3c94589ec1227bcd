// SBPL's .mprim files: load_primitives.hpp says what is in them.

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/io/primitives/load_primitives.hpp"
#include "wend/io/text.hpp"

namespace wend {
namespace {

constexpr double kMostCells = 1e6;

/// Reads one line after the other and keeps the first error.
class MprimReader {
 public:
  explicit MprimReader(std::string_view text) : lines_(text) {}

  const std::string& wrong() const { return wrong_; }
  std::size_t line() const { return line_; }

  bool at_end() {
    find_line();
    return !next_;
  }

  /// The numbers of a line "key: 1 2 3".
  std::vector<double> numbers_of(std::string_view key, std::size_t count) {
    find_line();
    std::string_view line = next_.value_or("");
    if (!line.starts_with(key) || !line.substr(key.size()).starts_with(':')) {
      complain(next_ ? fmt::format("expected '{}:', not {}", key, quote(line))
                     : fmt::format("the file ends, expected '{}:'", key));
      return std::vector<double>(count, 0);
    }
    line.remove_prefix(key.size() + 1);
    return numbers_in(line, count);
  }

  /// The numbers of a line.
  std::vector<double> numbers(std::size_t count) {
    find_line();
    if (!next_) complain(fmt::format("the file ends, expected a line of {} numbers", count));
    return numbers_in(next_.value_or(""), count);
  }

  double number_of(std::string_view key) { return numbers_of(key, 1).front(); }

  int whole_of(std::string_view key) { return whole(number_of(key), key); }

  int whole(double value, std::string_view what) {
    if (value == std::floor(value) && std::abs(value) <= kMostCells) return static_cast<int>(value);
    complain(fmt::format("{} is {}, not a whole number up to {}", what, format_number(value),
                         format_number(kMostCells)));
    return 0;
  }

  void complain(std::string what) {
    if (wrong_.empty()) wrong_ = std::move(what);
  }

 private:
  /// Looks for the next line that is not blank.
  void find_line() {
    while (!next_ && wrong_.empty()) {
      next_ = lines_.next();
      if (!next_) break;
      line_ = lines_.number();
      next_ = trimmed(*next_);
      if (next_->empty()) next_.reset();
    }
  }

  std::vector<double> numbers_in(std::string_view line, std::size_t count) {
    std::vector<double> numbers;
    for (const std::string_view word : words_of(line)) {
      const auto number = parse_number(word);
      if (!number || !std::isfinite(*number)) complain(quote(word) + " is not a finite number");
      numbers.push_back(number.value_or(0));
    }
    if (numbers.size() != count) {
      complain(fmt::format("{} numbers, expected {}", numbers.size(), count));
    }
    numbers.resize(count, 0);
    next_.reset();
    return numbers;
  }

  LineReader lines_;
  std::optional<std::string_view> next_;
  std::size_t line_ = 0;
  std::string wrong_;
};

MotionPrimitive read_primitive(MprimReader& reader, double resolution, int headings) {
  MotionPrimitive primitive;
  primitive.number = reader.whole_of("primID");
  primitive.from = reader.whole_of("startangle_c");
  const std::vector<double> end = reader.numbers_of("endpose_c", 3);
  primitive.by = {reader.whole(end[0], "x"), reader.whole(end[1], "y")};
  const int to = reader.whole(end[2], "the heading");
  primitive.to = ((to % headings) + headings) % headings;  // -1 is the last one
  primitive.cost_factor = reader.number_of("additionalactioncostmult");
  const int poses = reader.whole_of("intermediateposes");
  constexpr int kMost = static_cast<int>(MotionPrimitives::kMostPoses);
  if (poses < 2 || poses > kMost) {
    reader.complain(fmt::format("{} intermediate poses, expected 2 to {}", poses, kMost));
  }
  for (int i = 0; i < poses && reader.wrong().empty(); ++i) {
    const std::vector<double> pose = reader.numbers(3);
    primitive.poses.push_back({pose[0] / resolution, pose[1] / resolution, pose[2]});
  }
  return primitive;
}

}  // namespace

Expected<MotionPrimitives, Error> parse_mprim(std::string_view text, const std::string& name) {
  MprimReader reader(text);
  const auto failed = [&](const std::string& what) {
    return file_failure(name, reader.line(), what);
  };
  const double resolution = reader.number_of("resolution_m");
  if (reader.wrong().empty() && !(resolution > 0)) {
    return failed("the resolution must be above 0, in metres per cell");
  }
  const int headings = reader.whole_of("numberofangles");
  constexpr int kMostHeadings = static_cast<int>(MotionPrimitives::kMostHeadings);
  if (reader.wrong().empty() && (headings < 1 || headings > kMostHeadings)) {
    return failed(fmt::format("{} angles, expected 1 to {}", headings, kMostHeadings));
  }
  const int count = reader.whole_of("totalnumberofprimitives");
  MotionPrimitives::Parts parts{.resolution = resolution, .headings = {}, .primitives = {}};
  for (int i = 0; i < headings; ++i) parts.headings.push_back(2 * kPi * i / headings);
  while (reader.wrong().empty() && !reader.at_end() &&
         parts.primitives.size() <= MotionPrimitives::kMostPrimitives) {
    const std::size_t line = reader.line();
    parts.primitives.push_back(read_primitive(reader, resolution, headings));
    const MotionPrimitive& primitive = parts.primitives.back();
    if (reader.wrong().empty() && (primitive.from < 0 || primitive.from >= headings)) {
      return file_failure(name, line,
                          fmt::format("startangle_c {} of primitive {} is not from 0 to {}",
                                      primitive.from, primitive.number, headings - 1));
    }
  }
  if (!reader.wrong().empty()) return failed(reader.wrong());
  if (count < 0 || parts.primitives.size() != static_cast<std::size_t>(count)) {
    return failed(fmt::format("{} primitives, the header says {}", parts.primitives.size(), count));
  }
  auto made = MotionPrimitives::make(std::move(parts));
  if (made) return *std::move(made);
  const Error& error = made.error();
  return file_failure(name, 0, (error.where.empty() ? "" : error.where + ": ") + error.message);
}

}  // namespace wend
