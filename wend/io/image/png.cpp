#include <fmt/format.h>
#include <png.h>

#include <array>
#include <cassert>
#include <csetjmp>
#include <cstring>

#include "wend/io/image/grey_image.hpp"
#include "wend/io/text.hpp"
#include "wend/map/grid_map.hpp"

namespace wend {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1A\n";

/// Deflate expands one byte to at most 1032.
constexpr std::size_t kLargestExpansion = 1032;

struct PngSource {
  std::string_view rest;
  std::string warning;  // the last one: often more telling than the error that follows it
  std::string error;
};

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto* const source = static_cast<PngSource*>(png_get_io_ptr(png));
  if (source->rest.size() < count) png_error(png, "the file is truncated");
  std::memcpy(to, source->rest.data(), count);
  source->rest.remove_prefix(count);
}

void keep_error(png_structp png, png_const_charp what) {
  auto* const source = static_cast<PngSource*>(png_get_error_ptr(png));
  source->error = source->warning.empty() ? what : what + (" (" + source->warning + ")");
  png_longjmp(png, 1);
}

void keep_warning(png_structp png, png_const_charp what) {
  static_cast<PngSource*>(png_get_error_ptr(png))->warning = what;
}

/// Runs `call`. Returns false if libpng fails; the source then holds the error. libpng exits by longjmp,
/// which runs no destructors, so `call` must own nothing while it is inside libpng.
template <class Call>
bool succeeds(png_structp png, const Call& call) {
  // NOLINTNEXTLINE(modernize-avoid-setjmp-longjmp): libpng has no other way to report errors
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  call();
  return true;
}

/// The content of the header.
struct Layout {
  int width = 0;
  int height = 0;
  int depth = 0;
  int colour_type = 0;
  bool interlaced = false;

  bool palette() const { return colour_type == PNG_COLOR_TYPE_PALETTE; }
  bool colour() const { return (colour_type & PNG_COLOR_MASK_COLOR) != 0 && !palette(); }
  bool alpha() const { return (colour_type & PNG_COLOR_MASK_ALPHA) != 0; }
  std::size_t channels() const { return (colour() ? 3U : 1U) + (alpha() ? 1U : 0U); }
  std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  std::size_t packed_bytes() const {
    const std::size_t bits =
        static_cast<std::size_t>(width) * channels() * static_cast<std::size_t>(depth);
    return (bits + 7) / 8 * static_cast<std::size_t>(height);
  }
  /// In memory a sample takes at least one byte.
  std::size_t row_bytes() const {
    return static_cast<std::size_t>(width) * channels() * (depth == 16 ? 2U : 1U);
  }
};

struct PaletteEntry {
  std::uint16_t grey;
  bool transparent;
};

class PngDecoder {
 public:
  PngDecoder(std::string_view bytes, ImageRows& rows)
      : size_(bytes.size()),
        rows_(rows),
        source_{bytes, {}, {}},
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, keep_error, keep_warning)),
        info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {}
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;

  DecodedRows decode() {
    if (info_ == nullptr) return failure("libpng cannot be set up");
    if (!read_header()) return failure(source_.error);
    if (layout_.pixels() > GridMap::kMaxCells ||
        layout_.packed_bytes() / kLargestExpansion > size_) {
      return failure(fmt::format("{} x {} pixels are too large or truncated, the file has {} bytes",
                                 layout_.width, layout_.height, size_));
    }
    read_palette();
    maximum_ = layout_.palette() ? 255 : (1 << layout_.depth) - 1;
    rows_.begin(layout_.width, layout_.height, maximum_);
    if (!(layout_.interlaced ? read_interlaced() : read_rows())) return failure(source_.error);
    if (!succeeds(png_, [&] { png_read_end(png_, nullptr); })) return failure(source_.error);
    return std::vector<std::string>();
  }

 private:
  static Unexpected<Error> failure(const std::string& what) {
    return wend::failure(Status::invalid_file, "PNG: " + what, "PNG");
  }

  bool read_header() {
    png_set_read_fn(png_, &source_, read_bytes);
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    // Colour profiles, texts and the like say nothing about a map.
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_set_benign_errors(png_, 0);
    return succeeds(png_, [&] {
      png_read_info(png_, info_);
      layout_.width = static_cast<int>(png_get_image_width(png_, info_));
      layout_.height = static_cast<int>(png_get_image_height(png_, info_));
      layout_.depth = png_get_bit_depth(png_, info_);
      layout_.colour_type = png_get_color_type(png_, info_);
      layout_.interlaced = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
      png_set_packing(png_);
    });
  }

  void read_palette() {
    png_bytep alphas = nullptr;
    int alpha_count = 0;
    png_color_16p colour = nullptr;
    const bool found = png_get_tRNS(png_, info_, &alphas, &alpha_count, &colour) == PNG_INFO_tRNS;
    if (!layout_.palette()) {
      if (found && !layout_.alpha()) set_transparent_colour(*colour);
      return;
    }
    png_colorp entries = nullptr;
    int count = 0;
    png_get_PLTE(png_, info_, &entries, &count);
    for (int i = 0; i < count; ++i) {
      const bool transparent = found && i < alpha_count && alphas[i] < 255;
      any_transparent_ = any_transparent_ || transparent;
      palette_.push_back({luma(entries[i].red, entries[i].green, entries[i].blue), transparent});
    }
  }

  void set_transparent_colour(const png_color_16& colour) {
    any_transparent_ = true;
    has_transparent_colour_ = true;
    transparent_colour_ = layout_.colour() ? std::array{colour.red, colour.green, colour.blue}
                                           : std::array{colour.gray, colour.gray, colour.gray};
  }

  /// Reads row by row, so that memory grows only with the actual content of the file.
  bool read_rows() {
    std::vector<unsigned char> row(layout_.row_bytes());
    for (int y = 0; y < layout_.height; ++y) {
      if (!read_row(row.data()) || !append(row)) return false;
    }
    return true;
  }

  bool read_interlaced() {
    std::vector<unsigned char> bytes(layout_.row_bytes() *
                                     static_cast<std::size_t>(layout_.height));
    const auto row = [&](int y) {
      return std::span(bytes).subspan(static_cast<std::size_t>(y) * layout_.row_bytes(),
                                      layout_.row_bytes());
    };
    const int passes = png_set_interlace_handling(png_);
    for (int pass = 0; pass < passes; ++pass) {
      for (int y = 0; y < layout_.height; ++y) {
        if (!read_row(row(y).data())) return false;
      }
    }
    for (int y = 0; y < layout_.height; ++y) {
      if (!append(row(y))) return false;
    }
    return true;
  }

  bool read_row(unsigned char* to) {
    return succeeds(png_, [&] { png_read_row(png_, to, nullptr); });
  }

  bool append(std::span<const unsigned char> row) {
    values_.clear();
    transparent_.clear();
    if (!(layout_.palette() ? append_indices(row) : append_samples(row))) return false;
    rows_.add(values_, transparent_);
    return true;
  }

  bool append_indices(std::span<const unsigned char> row) {
    for (const unsigned char index : row) {
      if (index >= palette_.size()) {
        source_.error =
            fmt::format("palette index {} out of range ({} entries)", index, palette_.size());
        return false;
      }
      values_.push_back(palette_[index].grey);
      if (any_transparent_) transparent_.push_back(palette_[index].transparent ? 1 : 0);
    }
    return true;
  }

  bool append_samples(std::span<const unsigned char> row) {
    if (layout_.channels() == 1 && layout_.depth <= 8 && !any_transparent_) {
      values_.insert(values_.end(), row.begin(), row.end());
      return true;
    }
    const std::size_t step = layout_.channels() * (layout_.depth == 16 ? 2U : 1U);
    for (std::size_t i = 0; i < row.size(); i += step) append_pixel(row.subspan(i, step));
    return true;
  }

  void append_pixel(std::span<const unsigned char> pixel) {
    const auto sample = [&](std::size_t i) -> std::uint16_t {
      if (layout_.depth < 16) return pixel[i];
      return static_cast<std::uint16_t>(pixel[2 * i] << 8 | pixel[2 * i + 1]);
    };
    const std::array<std::uint16_t, 3> colour = layout_.colour()
                                                    ? std::array{sample(0), sample(1), sample(2)}
                                                    : std::array{sample(0), sample(0), sample(0)};
    values_.push_back(layout_.colour() ? luma(colour[0], colour[1], colour[2]) : colour[0]);
    if (layout_.alpha()) {
      const bool opaque = sample(layout_.channels() - 1) == maximum_;
      transparent_.push_back(opaque ? 0 : 1);
    } else if (has_transparent_colour_) {
      transparent_.push_back(colour == transparent_colour_ ? 1 : 0);
    }
  }

  std::size_t size_;
  ImageRows& rows_;
  PngSource source_;
  png_structp png_;
  png_infop info_;
  Layout layout_;
  std::vector<PaletteEntry> palette_;
  bool any_transparent_ = false;
  bool has_transparent_colour_ = false;
  std::array<std::uint16_t, 3> transparent_colour_{};
  int maximum_ = 255;
  std::vector<std::uint16_t> values_;       // of the current row
  std::vector<unsigned char> transparent_;  // of the current row; empty if the image is opaque
};

/// The first chunk must be the header, but libpng skips unknown chunks before it and takes others as
/// part of the image. Empty if there is no error, also for a file that ends before the header.
std::string wrong_first_chunk(std::string_view bytes) {
  constexpr std::size_t kType = kSignature.size() + 4;
  if (bytes.size() < kType + 4 || bytes.substr(kType, 4) == "IHDR") return {};
  return fmt::format("the first chunk must be IHDR, not {}", quote(bytes.substr(kType, 4)));
}

}  // namespace

bool looks_like_png(std::string_view bytes) { return bytes.starts_with(kSignature); }

DecodedRows decode_png(std::string_view bytes, ImageRows& rows) {
  const std::string wrong = wrong_first_chunk(bytes);
  if (!wrong.empty()) return failure(Status::invalid_file, "PNG: " + wrong, "PNG");
  return PngDecoder(bytes, rows).decode();
}

Expected<std::string, Error> encode_png(const GreyImage& image) {
  assert(image.maximum == 255);
  const bool alpha = !image.transparent.empty();
  std::vector<unsigned char> samples;
  samples.reserve(image.values.size() * (alpha ? 2 : 1));
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    samples.push_back(static_cast<unsigned char>(image.values[i]));
    if (alpha) samples.push_back(image.transparent[i] != 0 ? 0 : 255);
  }
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = alpha ? PNG_FORMAT_GA : PNG_FORMAT_GRAY;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, samples.data(), 0, nullptr) == 0) {
    return failure(Status::invalid_file, fmt::format("PNG: {}", png.message), "PNG");
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace wend
