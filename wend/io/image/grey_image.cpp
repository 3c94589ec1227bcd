#include "wend/io/image/grey_image.hpp"

#include <array>

namespace wend {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view begin;
  std::string_view name;
};

/// Known image formats that wend does not read.
constexpr std::array kUnsupported = {
    Signature{"GIF8"sv, "GIF"},      Signature{"II*\0"sv, "TIFF"},  Signature{"MM\0*"sv, "TIFF"},
    Signature{"RIFF"sv, "WebP"},     Signature{"P7"sv, "PAM (P7)"}, Signature{"Pf"sv, "PFM (Pf)"},
    Signature{"PF"sv, "PFM (PF)"},   Signature{"%PDF"sv, "PDF"},    Signature{"<svg"sv, "SVG"},
    Signature{"\x1F\x8B"sv, "gzip"},
};

/// The name of an image format that wend does not read; empty for other bytes.
std::string_view unsupported_format(std::string_view bytes) {
  for (const Signature& signature : kUnsupported) {
    if (bytes.starts_with(signature.begin)) return signature.name;
  }
  return {};
}

}  // namespace

bool looks_like_image(std::string_view bytes) {
  return looks_like_png(bytes) || looks_like_pnm(bytes) || looks_like_bmp(bytes) ||
         looks_like_jpeg(bytes) || !unsupported_format(bytes).empty();
}

DecodedRows decode_image(std::string_view bytes, ImageRows& rows) {
  if (looks_like_png(bytes)) return decode_png(bytes, rows);
  if (looks_like_pnm(bytes)) return decode_pnm(bytes, rows);
  if (looks_like_bmp(bytes)) return decode_bmp(bytes, rows);
  if (looks_like_jpeg(bytes)) return decode_jpeg(bytes, rows);
  const std::string name(unsupported_format(bytes));
  return failure(Status::invalid_file,
                 (name.empty() ? "unknown image format" : name + " images are not supported") +
                     "; expected PNG, PNM (P1 to P6), BMP or JPEG",
                 name);
}

}  // namespace wend
