#include "wend/render/label_font.hpp"

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

}  // namespace wend
