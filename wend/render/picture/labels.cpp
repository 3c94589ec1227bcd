#include "wend/render/picture/labels.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define WEND_LEAK_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define WEND_LEAK_SANITIZER
#endif

#ifdef WEND_LEAK_SANITIZER
#include <sanitizer/lsan_interface.h>
#endif

namespace wend {
namespace {

/// A byte of UTF-8 that is not the first one of its character.
bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

void select_label_font(cairo_t* context, double size) {
#ifdef WEND_LEAK_SANITIZER
  // Cairo keeps the fonts that it has found. Fontconfig's patterns point into themselves by
  // offsets, which the sanitizer does not take for pointers.
  const __lsan::ScopedDisabler disabler;
#endif
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
  cairo_get_scaled_font(context);  // looks for it now
}

double text_width(cairo_t* context, std::string_view text) {
  cairo_text_extents_t extents;
  cairo_text_extents(context, std::string(text).c_str(), &extents);
  return extents.x_advance;
}

void draw_text(cairo_t* context, Point baseline, std::string_view text, const Colour& colour) {
  set_source(context, colour);
  cairo_move_to(context, baseline.x, baseline.y);
  cairo_show_text(context, std::string(text).c_str());
}

std::string shortened(cairo_t* context, std::string_view text, double room) {
  if (text_width(context, text) <= room) return std::string(text);
  std::string result;
  for (std::size_t end = text.size(); end > 0; --end) {
    if (continues_character(text[end - 1])) continue;
    result = std::string(text.substr(0, end - 1)) + "…";
    if (text_width(context, result) <= room) break;
  }
  return result;
}

}  // namespace wend
