#include "wend/io/map/direction_mask.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/io/files.hpp"
#include "wend/io/image/colour_image.hpp"
#include "wend/io/image/grey_image.hpp"
#include "wend/io/map/image_file.hpp"
#include "wend/io/map/map_yaml.hpp"
#include "wend/map/direction_map.hpp"

namespace wend {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Keeps the greys of an image, on a scale of 255; NaN: transparent.
class KeptGreys final : public ImageRows {
 public:
  void begin(int width, int /*height*/, int maximum) override {
    width_ = width;
    step_ = 255.0 / maximum;
  }
  void add(std::span<const std::uint16_t> values,
           std::span<const unsigned char> transparent) override {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool clear = !transparent.empty() && transparent[i] != 0;
      greys_.push_back(clear ? kNone : step_ * values[i]);
    }
  }

  Grid<double> finish() && {
    const auto height = greys_.size() / static_cast<std::size_t>(width_);
    return {width_, static_cast<int>(height), std::move(greys_)};
  }

 private:
  int width_ = 1;
  double step_ = 1;
  std::vector<double> greys_;
};

/// An image and where it lies.
struct MaskImage {
  std::string bytes;
  Frame frame;
  MapFormat format = MapFormat::image_map;
  std::vector<std::string> notes = {};
  std::vector<std::filesystem::path> files = {};
};

Expected<MaskImage, Error> read_image(const std::filesystem::path& file) {
  auto bytes = read_file(file);
  if (!bytes) return Unexpected<Error>(std::move(bytes.error()));
  const MapFormatInfo* const named = map_format_of(file, MapUse::load);
  if (looks_like_image(*bytes)) {
    return MaskImage{.bytes = *std::move(bytes), .frame = {}, .files = {file}};
  }
  if (named == nullptr || named->format != MapFormat::map_yaml) {
    return file_failure(file.string(), 0,
                        "a mask of directions is an image, or a ROS map.yaml with one");
  }
  auto yaml = parse_map_yaml(*bytes, file.string());
  if (!yaml) return Unexpected<Error>(std::move(yaml.error()));
  const auto image = find_image(yaml->image.string(), {file.string(), file.parent_path()});
  if (!image) return Unexpected<Error>(image.error());
  auto pixels = read_file(image->file);
  if (!pixels) return file_failure(file.string(), 0, "image " + pixels.error().message);
  MaskImage read{*std::move(pixels),
                 yaml->frame,
                 MapFormat::map_yaml,
                 std::move(yaml->notes),
                 {file, image->file}};
  if (!image->note.empty()) read.notes.push_back(image->note);
  return read;
}

bool holds_headings(std::string_view bytes) {
  return looks_like_png(bytes) || bytes.starts_with("P2") || bytes.starts_with("P5");
}

/// How colourful a pixel has to be to be an arrow, of 255. Less is grey, or what lossy programs make of it.
constexpr int kLeastChroma = 64;

/// The hue of a pixel in degrees: red 0, yellow 60, green 120; NaN: grey or transparent.
double hue_of(const Colour& colour) {
  const auto [red, green, blue, alpha] = colour;
  const int most = std::max({red, green, blue});
  const int chroma = most - std::min({red, green, blue});
  constexpr int kHalf = 128;
  if (alpha < kHalf || chroma < kLeastChroma) return kNone;
  const auto part = [chroma](int a, int b) { return 60.0 * (a - b) / chroma; };
  if (most == red) return part(green, blue);
  return most == green ? 120 + part(blue, red) : 240 + part(red, green);
}

/// Degrees on the page, counter-clockwise from its right; NaN: no arrow.
Grid<double> page_headings(const ColourImage& image, const Grid<double>& greys) {
  Grid<double> headings(image.width, image.height, kNone);
  bool any_colour = false;
  for (const Cell cell : every_cell(headings)) {
    const auto at = static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(image.width) +
                    static_cast<std::size_t>(cell.x);
    headings[cell] = hue_of(image.pixels[at]);
    any_colour = any_colour || !std::isnan(headings[cell]);
  }
  return any_colour ? headings : greys;
}

double degrees_of_grey(double grey) {
  constexpr double kDegreesOfGrey = 1.5;
  constexpr double kMost = 240;
  const double value = std::round(grey);
  return value >= 1 && value <= kMost ? kDegreesOfGrey * (value - 1) : kNone;
}

/// In radians in the frame of the mask, row 0 first.
Expected<Grid<double>, Error> headings_in(const MaskImage& image, Grid<double> greys) {
  for (const Cell cell : every_cell(greys)) greys[cell] = degrees_of_grey(greys[cell]);
  if (looks_like_png(image.bytes)) {
    const auto colours = decode_colours(image.bytes);
    if (!colours) return Unexpected<Error>(colours.error());
    greys = page_headings(*colours, greys);
  }
  const double side = image.frame.y_up ? 1 : -1;  // of a page, y up
  for (const Cell cell : every_cell(greys)) {
    greys[cell] = radians_from(side * greys[cell]) + image.frame.origin.heading;
  }
  return greys;
}

/// From the order of the page to that of the frame.
Grid<double> in_frame(const Grid<double>& page, const Frame& frame) {
  if (!frame.y_up) return page;
  Grid<double> turned(page.width(), page.height());
  for (const Cell cell : every_cell(page)) {
    turned[{cell.x, page.height() - 1 - cell.y}] = page[cell];
  }
  return turned;
}

Expected<GridMap, Error> with_directions(const GridMap& open, const MaskImage& image,
                                         Grid<double> greys, const MaskReading& reading) {
  if (reading.kind == MaskKind::height) {
    for (const Cell cell : every_cell(greys)) greys[cell] *= reading.height_step;
    return with_heights(open, in_frame(greys, image.frame), reading.slope);
  }
  const auto headings = headings_in(image, std::move(greys));
  if (!headings) return Unexpected<Error>(headings.error());
  return with_arrows(open, in_frame(*headings, image.frame), reading.arrow);
}

Expected<LoadedMap, Error> load(const std::filesystem::path& file, const MaskReading& reading) {
  auto image = read_image(file);
  if (!image) return Unexpected<Error>(std::move(image.error()));
  if (reading.kind == MaskKind::oneway && !holds_headings(image->bytes)) {
    return file_failure(file.string(), 0,
                        "a one-way mask is a PNG, or a PGM of greys: other formats do not keep "
                        "colours or are not read with them");
  }
  KeptGreys rows;
  const auto notes = decode_image(image->bytes, rows);
  if (!notes) return file_failure(file.string(), 0, notes.error().message);
  Grid<double> greys = std::move(rows).finish();
  const auto open =
      make_grid_map(Grid<CellState>(greys.width(), greys.height(), CellState::free), image->frame);
  if (!open) return file_failure(file.string(), 0, open.error().message);
  auto made = with_directions(*open, *image, std::move(greys), reading);
  if (!made) return file_failure(file.string(), 0, made.error().message);
  LoadedMap loaded{*std::move(made), image->format, std::move(image->notes),
                   std::move(image->files)};
  loaded.notes.insert(loaded.notes.end(), notes->begin(), notes->end());
  const DirectionMap& directions = *loaded.map.directions();
  bool any = false;
  for (const Cell cell : every_cell(loaded.map)) any = any || !directions.none_at(cell);
  if (!any) {
    loaded.notes.push_back(reading.kind == MaskKind::height
                               ? "the height mask is flat: it changes nothing"
                               : "the one-way mask has no arrows: neither colours nor greys of 1 "
                                 "to 240");
  }
  return loaded;
}

}  // namespace

Expected<LoadedMap, Error> load_direction_mask(const std::filesystem::path& file,
                                               const MaskReading& reading) {
  try {
    return load(file, reading);
  } catch (const std::bad_alloc&) {
    return file_failure(file.string(), 0, "not enough memory for this mask");
  }
}

}  // namespace wend
