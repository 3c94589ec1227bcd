#include "cli/output/picture_files.hpp"

#include <memory>
#include <utility>

namespace wend::cli {
namespace {

/// A panel that has nothing to say besides its scene is a picture of its own.
Expected<std::string, RenderError> drawn(const std::vector<Panel>& panels, PictureKind kind,
                                         const Style& style) {
  const Panel& first = panels.front();
  const bool alone = panels.size() == 1 && first.title.empty() && first.caption.empty();
  return alone ? draw_picture(first.scene, kind, first.style.value_or(style))
               : draw_panels(panels, kind, style);
}

}  // namespace

std::vector<std::string> picture_extensions() { return {".png", ".svg", ".pdf"}; }

std::map<std::string, FileWriter> picture_writers(std::vector<Panel> panels, StyleName style) {
  const auto shared = std::make_shared<const std::vector<Panel>>(std::move(panels));
  const auto writer_of = [&](PictureKind kind) {
    return [shared, style, kind](const std::string& file) {
      return write_picture(file, drawn(*shared, kind, style_of(style)));
    };
  };
  return {{".png", writer_of(PictureKind::png)},
          {".svg", writer_of(PictureKind::svg)},
          {".pdf", writer_of(PictureKind::pdf)}};
}

std::string write_picture(const std::string& file,
                          const Expected<std::string, RenderError>& picture) {
  return picture ? write_bytes(file, *picture) : file + ": " + picture.error().message();
}

}  // namespace wend::cli
