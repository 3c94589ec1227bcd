#include <fmt/format.h>

#include <array>
#include <csetjmp>
#include <cstdio>  // jpeglib.h needs it

#include <jpeglib.h>

#include "wend/io/image/grey_image.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {
namespace {

constexpr std::string_view kJpegSignature = "\xFF\xD8\xFF";

/// Without arithmetic coding a block of 8 x 8 pixels takes at least one bit.
constexpr std::size_t kMostPixelsPerByte = 512;

/// Some small files would take hours: each of their scans goes over the whole image.
constexpr int kMostScans = 100;

/// What libjpeg calls back. It must be able to find this from its own part, so that comes first.
struct JpegErrors {
  jpeg_error_mgr calls{};
  std::jmp_buf jump{};
  std::array<char, JMSG_LENGTH_MAX> message{};  // the error, or the first warning

  static JpegErrors& of(j_common_ptr jpeg) { return *reinterpret_cast<JpegErrors*>(jpeg->err); }
  void keep(j_common_ptr jpeg) { calls.format_message(jpeg, message.data()); }
};

[[noreturn]] void leave(j_common_ptr jpeg) {
  JpegErrors& errors = JpegErrors::of(jpeg);
  errors.keep(jpeg);
  // NOLINTNEXTLINE(modernize-avoid-setjmp-longjmp): libjpeg has no other way to report errors
  std::longjmp(errors.jump, 1);
}

/// Damaged data: libjpeg would fill in grey.
void take_message(j_common_ptr jpeg, int level) {
  if (level < 0) leave(jpeg);
}

void show_nothing(j_common_ptr /*jpeg*/) {}

void count_scans(j_common_ptr jpeg) {
  const auto* const decoder = reinterpret_cast<j_decompress_ptr>(jpeg);
  if (decoder->input_scan_number <= kMostScans) return;
  JpegErrors& errors = JpegErrors::of(jpeg);
  fmt::format_to_n(errors.message.data(), errors.message.size() - 1, "more than {} scans",
                   kMostScans);
  // NOLINTNEXTLINE(modernize-avoid-setjmp-longjmp): libjpeg has no other way to report errors
  std::longjmp(errors.jump, 1);
}

class JpegDecoder {
 public:
  JpegDecoder(std::string_view bytes, ImageRows& rows) : bytes_(bytes), rows_(rows) {
    jpeg_.err = jpeg_std_error(&errors_.calls);
    errors_.calls.error_exit = leave;
    errors_.calls.emit_message = take_message;
    errors_.calls.output_message = show_nothing;
    progress_.progress_monitor = count_scans;
  }
  ~JpegDecoder() { jpeg_destroy_decompress(&jpeg_); }
  JpegDecoder(const JpegDecoder&) = delete;
  JpegDecoder& operator=(const JpegDecoder&) = delete;

  DecodedRows decode() {
    if (!read_header()) return failure(errors_.message.data());
    const std::string wrong = wrong_kind();
    if (!wrong.empty()) return failure(wrong);
    if (!succeeds([&] { jpeg_start_decompress(&jpeg_); })) return failure(errors_.message.data());
    rows_.begin(static_cast<int>(jpeg_.output_width), static_cast<int>(jpeg_.output_height), 255);
    if (!read_rows()) return failure(errors_.message.data());
    return std::vector<std::string>{
        "JPEG does not keep grey values exactly: cells beside walls may be wrong; PNG keeps them"};
  }

 private:
  static Unexpected<Error> failure(const std::string& what) {
    return wend::failure(Status::invalid_file, "JPEG: " + what, "JPEG");
  }

  /// As for PNG: libjpeg exits by longjmp, which runs no destructors, so `call` must own nothing while it is
  /// inside libjpeg.
  template <class Call>
  bool succeeds(const Call& call) {
    // NOLINTNEXTLINE(modernize-avoid-setjmp-longjmp): libjpeg has no other way to report errors
    if (setjmp(errors_.jump) != 0) return false;
    call();
    return true;
  }

  bool read_header() {
    return succeeds([&] {
      jpeg_create_decompress(&jpeg_);
      jpeg_.progress = &progress_;
      jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
      jpeg_read_header(&jpeg_, TRUE);
      const bool grey = jpeg_.jpeg_color_space == JCS_GRAYSCALE;
      jpeg_.out_color_space = grey ? JCS_GRAYSCALE : JCS_RGB;
    });
  }

  /// Why the image is not read; empty if it is.
  std::string wrong_kind() const {
    const std::size_t pixels = std::size_t{jpeg_.image_width} * jpeg_.image_height;
    if (jpeg_.arith_code != FALSE) return "arithmetic coding is not supported";
    if (jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK) {
      return "CMYK colours are not supported";
    }
    if (pixels <= GridMap::kMaxCells && pixels / kMostPixelsPerByte <= bytes_.size()) return {};
    return fmt::format("{} x {} pixels are too large or truncated, the file has {} bytes",
                       jpeg_.image_width, jpeg_.image_height, bytes_.size());
  }

  bool read_rows() {
    const auto width = std::size_t{jpeg_.output_width};
    const auto channels = static_cast<std::size_t>(jpeg_.output_components);
    std::vector<unsigned char> samples(width * channels);
    std::vector<std::uint16_t> values(width);
    JSAMPROW row = samples.data();
    while (jpeg_.output_scanline < jpeg_.output_height) {
      if (!succeeds([&] { jpeg_read_scanlines(&jpeg_, &row, 1); })) return false;
      for (std::size_t x = 0; x < width; ++x) {
        const auto pixel = std::span(samples).subspan(x * channels, channels);
        values[x] = channels == 1 ? pixel[0] : luma(pixel[0], pixel[1], pixel[2]);
      }
      rows_.add(values, {});
    }
    return succeeds([&] { jpeg_finish_decompress(&jpeg_); });
  }

  std::string_view bytes_;
  ImageRows& rows_;
  JpegErrors errors_;
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct jpeg_{};
};

}  // namespace

bool looks_like_jpeg(std::string_view bytes) { return bytes.starts_with(kJpegSignature); }

DecodedRows decode_jpeg(std::string_view bytes, ImageRows& rows) {
  return JpegDecoder(bytes, rows).decode();
}

}  // namespace wend
