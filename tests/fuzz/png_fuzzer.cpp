// Random changes would all fail at the checksums, so these are put right after each.

#include <algorithm>

#include "loaders.hpp"
#include "wend/io/image/png_test_support.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace {

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kWord = 4;  // the length, the type and the checksum of a chunk

std::size_t length_at(const std::uint8_t* bytes) {
  return std::size_t{bytes[0]} << 24 | std::size_t{bytes[1]} << 16 | std::size_t{bytes[2]} << 8 |
         bytes[3];
}

void correct_checksums(std::uint8_t* data, std::size_t size) {
  std::size_t at = kSignatureBytes;
  while (at + 3 * kWord <= size) {
    const std::size_t length = length_at(data + at);
    if (length > size - at - 3 * kWord) return;
    const std::string_view checked(reinterpret_cast<const char*>(data + at + kWord),
                                   kWord + length);
    const std::string checksum = wend::png_file::big_endian(wend::png_file::crc32(checked));
    std::copy(checksum.begin(), checksum.end(), data + at + 2 * kWord + length);
    at += 3 * kWord + length;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t largest, unsigned seed) {
  size = LLVMFuzzerMutate(data, size, largest);
  if (seed % 8 != 0) correct_checksums(data, size);
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return wend::test::fuzz_or_abort("png", data, size);
}
