#include "wend/render/animation/lzw_encoder.hpp"

#include <algorithm>
#include <cassert>

namespace wend {
namespace {

constexpr std::uint16_t kMostCodes = 4095;  // some decoders do not expect the last of 12 bits
constexpr std::size_t kMostInABlock = 255;

}  // namespace

LzwEncoder::LzwEncoder(int bits)
    : bits_(bits),
      clear_(static_cast<Code>(1U << static_cast<unsigned>(bits))),
      words_(kMostCodes),
      repeated_(clear_) {
  assert(bits >= 2 && bits <= 8);
  for (Code pixel = 0; pixel < clear_; ++pixel) repeated_[pixel] = {pixel};
}

void LzwEncoder::add(std::uint8_t pixel, int count) {
  assert(pixel < clear_);
  if (count > 0 && empty_) {
    begin();
    word_ = pixel;
    length_ = 1;
    --count;
  }
  const std::vector<Code>& repeated = repeated_[pixel];
  while (count > 0) {
    if (length_ > 0 && length_ < repeated.size() && repeated[length_ - 1] == word_) {
      const std::size_t more = std::min(static_cast<std::size_t>(count), repeated.size() - length_);
      length_ += more;
      word_ = repeated[length_ - 1];
      count -= static_cast<int>(more);
    } else {
      add_one(pixel);
      --count;
    }
  }
}

const std::string& LzwEncoder::finish() {
  assert(!empty_);
  put(word_);
  put(static_cast<Code>(clear_ + 1));
  if (pending_bits_ > 0) put_byte(static_cast<std::uint8_t>(pending_ & 255U));
  bytes_[block_] = static_cast<char>(bytes_.size() - block_ - 1);
  bytes_.push_back(0);
  empty_ = true;
  return bytes_;
}

void LzwEncoder::begin() {
  empty_ = false;
  bytes_.assign(1, 0);
  block_ = 0;
  pending_ = 0;
  pending_bits_ = 0;
  forget_words();
  put(clear_);
}

void LzwEncoder::add_one(std::uint8_t pixel) {
  if (const Code both = longer(word_, pixel); both != 0) {
    word_ = both;
    length_ = 0;
    return;
  }
  put(word_);
  if (next_code_ < kMostCodes) {
    learn(pixel);
  } else {
    put(clear_);
    forget_words();
  }
  word_ = pixel;
  length_ = 1;
}

/// The word with that pixel behind it; 0 if it is not known.
LzwEncoder::Code LzwEncoder::longer(Code word, std::uint8_t pixel) const {
  Code code = words_[word].first_longer;
  while (code != 0 && words_[code].last != pixel) code = words_[code].next;
  return code;
}

void LzwEncoder::forget_words() {
  for (Word& word : words_) word.first_longer = 0;
  for (std::vector<Code>& repeated : repeated_) repeated.resize(1);
  next_code_ = static_cast<Code>(clear_ + 2);
  code_bits_ = bits_ + 1;
}

/// That the last word may have this pixel behind it.
void LzwEncoder::learn(std::uint8_t pixel) {
  Word& shorter = words_[word_];
  words_[next_code_] = {0, shorter.first_longer, pixel};
  shorter.first_longer = next_code_;
  std::vector<Code>& repeated = repeated_[pixel];
  if (repeated.size() == length_ && repeated.back() == word_) repeated.push_back(next_code_);
  ++next_code_;
}

void LzwEncoder::put(Code code) {
  pending_ |= static_cast<std::uint32_t>(code) << static_cast<unsigned>(pending_bits_);
  pending_bits_ += code_bits_;
  for (; pending_bits_ >= 8; pending_bits_ -= 8) {
    put_byte(static_cast<std::uint8_t>(pending_ & 255U));
    pending_ >>= 8U;
  }
  // Decoders learn a word one code later.
  if (next_code_ >> static_cast<unsigned>(code_bits_) != 0) ++code_bits_;
}

void LzwEncoder::put_byte(std::uint8_t byte) {
  if (bytes_.size() - block_ > kMostInABlock) {
    bytes_[block_] = static_cast<char>(kMostInABlock);
    block_ = bytes_.size();
    bytes_.push_back(0);
  }
  bytes_.push_back(static_cast<char>(byte));
}

}  // namespace wend
