#pragma once

// LzwEncoder: the pixels of a GIF's image, compressed.
//
//   wend::LzwEncoder encoder(8);
//   encoder.add(7, 800);  // a run of equal pixels
//   encoder.add(3, 1);
//   append(encoder.finish());
//
// Welch's variant of the algorithm of Lempel and Ziv, with codes of up to 12 bits. It takes the longest word that it knows,
// and knows words of one pixel repeated by their length: long runs, of which most frames of a film consist, take
// O(1) a code and not a pixel.

#include <cstdint>
#include <string>
#include <vector>

namespace wend {

class LzwEncoder {
 public:
  /// For pixels of that many bits, 2 to 8.
  explicit LzwEncoder(int bits);

  /// Appends `count` (at least 0) pixels of one value, below 2^bits.
  void add(std::uint8_t pixel, int count);

  /// The pixels since the last call (one at least) as a file has them: blocks of up to 255 bytes, each behind its
  /// length, and an empty one. Valid until the next pixel is added.
  const std::string& finish();

 private:
  using Code = std::uint16_t;

  /// A word that is known. Those that are one pixel longer than the same word are a list.
  struct Word {
    Code first_longer = 0;  // 0: none
    Code next = 0;          // of the list that it is in
    std::uint8_t last = 0;  // its last pixel
  };

  void begin();
  void add_one(std::uint8_t pixel);
  Code longer(Code word, std::uint8_t pixel) const;
  void forget_words();
  void learn(std::uint8_t pixel);
  void put(Code code);
  void put_byte(std::uint8_t byte);

  int bits_;
  Code clear_;               // then the code that ends an image, then those of words
  std::vector<Word> words_;  // by code
  std::vector<std::vector<Code>> repeated_;  // by pixel: the words of it alone, by their length
  bool empty_ = true;
  Code word_ = 0;           // the longest that the last pixels are
  std::size_t length_ = 0;  // of this word if it is one pixel repeated; else 0
  Code next_code_ = 0;
  int code_bits_ = 0;
  std::uint32_t pending_ = 0;  // bits that are not a byte yet, the first one lowest
  int pending_bits_ = 0;
  std::string bytes_;
  std::size_t block_ = 0;  // where in bytes_ the length of the last block stands
};

}  // namespace wend
