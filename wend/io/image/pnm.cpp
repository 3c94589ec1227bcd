#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/io/image/grey_image.hpp"
#include "wend/io/text.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {
namespace {

constexpr int kLargestMaximum = 65535;

bool is_white_space(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

struct Header {
  bool text;     // samples are decimal numbers
  bool bitmap;   // one bit a pixel, 1 is black
  int channels;  // 1 or 3
  int width = 0;
  int height = 0;
  int maximum = 1;

  std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  std::size_t samples() const { return pixels() * static_cast<std::size_t>(channels); }
  std::size_t sample_bytes() const { return maximum > 255 ? 2 : 1; }

  /// The least number of bytes of the samples; in a binary file the exact number.
  std::size_t least_bytes() const {
    if (text) return bitmap ? samples() : 2 * samples() - 1;
    if (!bitmap) return samples() * sample_bytes();
    return (static_cast<std::size_t>(width) + 7) / 8 * static_cast<std::size_t>(height);
  }
};

class PnmDecoder {
 public:
  PnmDecoder(std::string_view bytes, ImageRows& rows) : rest_(bytes), rows_(rows) {}

  DecodedRows decode() {
    auto header = read_header();
    if (!header) return Unexpected<Error>(header.error());
    if (rest_.size() < header->least_bytes()) {
      return failure(fmt::format("pixel data truncated: {} bytes, expected at least {}",
                                 rest_.size(), header->least_bytes()));
    }
    rows_.begin(header->width, header->height, header->maximum);
    row_.resize(static_cast<std::size_t>(header->width));
    for (int y = 0; y < header->height; ++y) {
      if (is_grey_in_bytes(*header) && add_bytes(*header)) continue;
      if (header->bitmap && !header->text) {
        read_bits();
      } else if (std::string wrong = read_samples(*header); !wrong.empty()) {
        return failure(std::move(wrong));
      }
      rows_.add(row_, {});
    }
    return notes(*header);
  }

 private:
  static Unexpected<Error> failure(std::string what) {
    return wend::failure(Status::invalid_file, std::move(what), "PNM");
  }

  void skip_space_and_comments() {
    while (!rest_.empty()) {
      if (rest_.front() == '#') {
        rest_.remove_prefix(std::min(rest_.size(), rest_.find('\n')));
      } else if (is_white_space(rest_.front())) {
        rest_.remove_prefix(1);
      } else {
        return;
      }
    }
  }

  /// The next word; empty at the end of the file.
  std::string_view next_word() {
    skip_space_and_comments();
    std::size_t length = 0;
    while (length < rest_.size() && !is_white_space(rest_[length]) && rest_[length] != '#') {
      ++length;
    }
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }

  Expected<int, Error> read_number(std::string_view name, int largest) {
    const std::string_view word = next_word();
    if (word.empty()) return failure(fmt::format("header truncated: {} is missing", name));
    const auto value = parse_integer<int>(word);
    if (!value || *value < 1 || *value > largest) {
      return failure(
          fmt::format("{} must be a whole number in 1..{}, not {}", name, largest, quote(word)));
    }
    return *value;
  }

  Expected<Header, Error> read_header() {
    const int kind = rest_[1] - '0';
    rest_.remove_prefix(2);
    Header header{kind <= 3, kind % 3 == 1, kind % 3 == 0 ? 3 : 1};
    const auto width = read_number("width", static_cast<int>(GridMap::kMaxCells));
    if (!width) return Unexpected<Error>(width.error());
    const auto height = read_number("height", static_cast<int>(GridMap::kMaxCells));
    if (!height) return Unexpected<Error>(height.error());
    header.width = *width;
    header.height = *height;
    if (!header.bitmap) {
      const auto maximum = read_number("the maximum value", kLargestMaximum);
      if (!maximum) return Unexpected<Error>(maximum.error());
      header.maximum = *maximum;
    }
    if (header.pixels() > GridMap::kMaxCells) {
      return failure(fmt::format("{} x {} pixels are too many, the limit is {}", header.width,
                                 header.height, GridMap::kMaxCells));
    }
    if (!header.text) skip_line_end(header);
    return header;
  }

  /// Skips the single white space between the header and binary samples, which a comment may precede.
  /// A CRLF counts as one if the samples are complete without its LF.
  void skip_line_end(const Header& header) {
    if (rest_.starts_with('#')) rest_.remove_prefix(std::min(rest_.size(), rest_.find('\n')));
    const bool windows = rest_.starts_with("\r\n") && rest_.size() >= header.least_bytes() + 2;
    rest_.remove_prefix(std::min<std::size_t>(rest_.size(), windows ? 2 : 1));
  }

  static bool is_grey_in_bytes(const Header& header) {
    return !header.text && !header.bitmap && header.channels == 1 && header.sample_bytes() == 1;
  }

  /// Adds a row of grey bytes, the usual one; does nothing and returns false if one is above the maximum.
  bool add_bytes(const Header& header) {
    const std::span<const unsigned char> bytes(reinterpret_cast<const unsigned char*>(rest_.data()),
                                               row_.size());
    unsigned char largest = 0;
    for (const unsigned char value : bytes) largest = std::max(largest, value);
    if (largest > header.maximum) return false;
    if (!rows_.add_bytes(bytes)) {
      std::ranges::copy(bytes, row_.begin());
      rows_.add(row_, {});
    }
    rest_.remove_prefix(bytes.size());
    return true;
  }

  /// Reads a row of grey or colour samples, or of a text bitmap. Returns an error, empty on success.
  std::string read_samples(const Header& header) {
    for (std::uint16_t& value : row_) {
      unsigned samples[3] = {};
      for (int i = 0; i < header.channels; ++i) {
        if (!header.text) {
          samples[i] = read_binary(header);
        } else if (std::string wrong = read_text(header, samples[i]); !wrong.empty()) {
          return wrong;
        }
        if (samples[i] > static_cast<unsigned>(header.maximum)) {
          return fmt::format("pixel value {} above the maximum value {}", samples[i],
                             header.maximum);
        }
      }
      value = grey(header, samples);
    }
    return {};
  }

  std::string read_text(const Header& header, unsigned& sample) {
    const std::string_view word = header.bitmap ? next_digit() : next_word();
    if (word.empty()) {
      return fmt::format("pixel data truncated: {} pixels, expected {}",
                         text_samples_ / header.channels, header.pixels());
    }
    ++text_samples_;
    const auto value = parse_integer<unsigned>(word);
    if (!value) return fmt::format("pixel value {} is not a non-negative integer", quote(word));
    sample = *value;
    return {};
  }

  unsigned read_binary(const Header& header) {
    const bool wide = header.sample_bytes() == 2;
    const unsigned sample = wide ? byte(0) << 8 | byte(1) : byte(0);
    rest_.remove_prefix(wide ? 2 : 1);
    return sample;
  }

  /// The next digit of a text bitmap, where blanks between digits are optional.
  std::string_view next_digit() {
    skip_space_and_comments();
    const std::string_view digit = rest_.substr(0, 1);
    rest_.remove_prefix(digit.size());
    return digit;
  }

  void read_bits() {
    for (std::size_t x = 0; x < row_.size(); ++x) {
      row_[x] = ((byte(x / 8) >> (7 - x % 8)) & 1U) != 0 ? 0 : 1;
    }
    rest_.remove_prefix((row_.size() + 7) / 8);
  }

  unsigned byte(std::size_t at) const { return static_cast<unsigned char>(rest_[at]); }

  static std::uint16_t grey(const Header& header, const unsigned (&samples)[3]) {
    if (header.bitmap) return samples[0] == 0 ? 1 : 0;
    if (header.channels == 1) return static_cast<std::uint16_t>(samples[0]);
    return luma(samples[0], samples[1], samples[2]);
  }

  std::vector<std::string> notes(const Header& header) {
    if (header.text) skip_space_and_comments();
    if (rest_.empty() || (rest_.size() == 1 && is_white_space(rest_.front()))) return {};
    return {fmt::format("{} bytes after the last pixel of the image are ignored", rest_.size())};
  }

  std::string_view rest_;
  ImageRows& rows_;
  std::vector<std::uint16_t> row_;  // the current one
  int text_samples_ = 0;            // read so far
};

}  // namespace

bool looks_like_pnm(std::string_view bytes) {
  return bytes.size() >= 3 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6' &&
         (is_white_space(bytes[2]) || bytes[2] == '#');
}

DecodedRows decode_pnm(std::string_view bytes, ImageRows& rows) {
  return PnmDecoder(bytes, rows).decode();
}

std::string encode_pgm(const GreyImage& image) {
  assert(image.maximum == 255);
  std::string bytes = fmt::format("P5\n{} {}\n255\n", image.width, image.height);
  bytes.reserve(bytes.size() + image.values.size());
  for (const std::uint16_t value : image.values) bytes += static_cast<char>(value);
  return bytes;
}

}  // namespace wend
