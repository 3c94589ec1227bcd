#include "wend/render/animation/gif.hpp"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <iterator>
#include <optional>
#include <unordered_map>

#include "wend/render/animation/lzw_encoder.hpp"

namespace wend {
namespace {

using Index = GifByteType;

constexpr std::int64_t kMostDelay = 65535;          // what a frame can say
constexpr std::size_t kMostKnownColours = 1 << 16;  // to remember

struct GifCloser {
  void operator()(GifFileType* file) const { EGifCloseFile(file, nullptr); }
};

int append_bytes(GifFileType* file, const GifByteType* data, int length) {
  static_cast<std::string*>(file->UserData)
      ->append(reinterpret_cast<const char*>(data), static_cast<std::size_t>(length));
  return length;
}

GifColorType gif_colour(std::uint32_t rgb) {
  return {static_cast<GifByteType>(rgb >> 16U & 255U), static_cast<GifByteType>(rgb >> 8U & 255U),
          static_cast<GifByteType>(rgb & 255U)};
}

int squared_distance(std::uint32_t a, std::uint32_t b) {
  int sum = 0;
  for (const unsigned shift : {0U, 8U, 16U}) {
    const int difference =
        static_cast<int>(a >> shift & 255U) - static_cast<int>(b >> shift & 255U);
    sum += difference * difference;
  }
  return sum;
}

/// Colours as indices into a palette.
class NearestColours {
 public:
  explicit NearestColours(std::vector<std::uint32_t> palette) : palette_(std::move(palette)) {}

  const std::vector<std::uint32_t>& palette() const { return palette_; }

  Index operator[](std::uint32_t colour) {
    if (known_.size() > kMostKnownColours) known_.clear();
    const auto [place, is_new] = known_.try_emplace(colour, Index{0});
    if (is_new) place->second = search(colour);
    return place->second;
  }

 private:
  Index search(std::uint32_t colour) const {
    const auto closer = [colour](std::uint32_t a, std::uint32_t b) {
      return squared_distance(a, colour) < squared_distance(b, colour);
    };
    const auto nearest = std::min_element(palette_.begin(), palette_.end(), closer);
    return static_cast<Index>(nearest - palette_.begin());
  }

  std::vector<std::uint32_t> palette_;
  std::unordered_map<std::uint32_t, Index> known_;
};

/// A rectangle of pixels, one at least.
struct Area {
  int left = 0;
  int top = 0;
  int width = 1;
  int height = 1;
};

/// Calls visit(value, length) for the runs of equal values, from left to right.
template <class Value, class Visit>
void for_runs_of(std::span<const Value> row, Visit&& visit) {
  for (auto run = row.begin(); run != row.end();) {
    const Value value = *run;
    const auto end = std::find_if(run, row.end(), [value](Value other) { return other != value; });
    visit(value, end - run);
    run = end;
  }
}

}  // namespace

class GifAnimation::Writer {
 public:
  Writer(int width, int height, std::vector<std::uint32_t> palette)
      : colours_(std::move(palette)),
        row_(static_cast<std::size_t>(width)),
        written_(width, height),
        shown_(width, height),
        pixels_(width, height),
        encoder_(bits_of(colours_.palette())),
        file_(EGifOpen(&bytes_, append_bytes, &error_)) {
    if (file_ != nullptr) write_head();
  }

  int width() const { return shown_.width(); }
  int height() const { return shown_.height(); }

  void add(const Grid<std::uint32_t>& pixels, int centiseconds) {
    const bool is_first = state_ == State::empty;
    bool differs = false;
    for (int y = 0; y < pixels.height(); ++y) {
      const auto row = pixels.row(y);
      // Most rows of most frames are those of the frame before.
      if (!is_first && std::ranges::equal(row, pixels_.row(y))) continue;
      std::ranges::copy(row, pixels_.row(y).begin());
      take_colours(row);
      if (!is_first && std::ranges::equal(row_, shown_.row(y))) continue;
      if (!is_first && !differs) write_shown();
      differs = true;
      if (!is_first) widen_changed(y);
      std::ranges::copy(row_, shown_.row(y).begin());
    }
    if (is_first) state_ = State::first_shown;
    delay_ += centiseconds;
  }

  Expected<std::string, Error> finish() {
    if (state_ == State::empty)
      return failure(Status::unsupported_query, "an animation without frames");
    write_shown();
    int error = error_;
    EGifCloseFile(file_.release(), error == 0 ? &error : nullptr);
    if (error != 0) return failure(Status::memory_limit, GifErrorString(error));
    return std::move(bytes_);
  }

 private:
  enum class State { empty, first_shown, others_shown };

  static int bits_of(const std::vector<std::uint32_t>& palette) {
    return std::max(2, static_cast<int>(std::bit_width(palette.size())));
  }

  /// A row as indices, into row_.
  void take_colours(std::span<const std::uint32_t> row) {
    auto to = row_.begin();
    for_runs_of(row, [&](std::uint32_t colour, std::ptrdiff_t length) {
      to = std::fill_n(to, length, colours_[colour]);
    });
  }

  /// By what differs between row_ and the row y that it replaces.
  void widen_changed(int y) {
    const auto old = shown_.row(y);
    const auto first = std::ranges::mismatch(row_, old).in1 - row_.begin();
    const auto after = row_.rend() - std::mismatch(row_.rbegin(), row_.rend(), old.rbegin()).first;
    if (!changed_) changed_ = Area{static_cast<int>(first), y, 1, 1};
    const int right = std::max(changed_->left + changed_->width, static_cast<int>(after));
    changed_->left = std::min(changed_->left, static_cast<int>(first));
    changed_->width = right - changed_->left;
    changed_->height = y - changed_->top + 1;
  }

  void check(int result) {
    if (result == GIF_ERROR && error_ == 0) error_ = file_->Error;
  }

  Index transparent() const { return static_cast<Index>(colours_.palette().size()); }

  void write_head() {
    const auto& palette = colours_.palette();
    const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> map(
        GifMakeMapObject(1 << bits_of(palette), nullptr), GifFreeMapObject);
    if (map == nullptr) {
      error_ = E_GIF_ERR_NOT_ENOUGH_MEM;
      return;
    }
    std::transform(palette.begin(), palette.end(), map->Colors, gif_colour);
    EGifSetGifVersion(file_.get(), true);
    check(EGifPutScreenDesc(file_.get(), shown_.width(), shown_.height(), map->BitsPerPixel, 0,
                            map.get()));
    write_repetition();
  }

  /// "Play for ever", as Netscape once said it.
  void write_repetition() {
    constexpr std::string_view kName = "NETSCAPE2.0";
    constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
    check(EGifPutExtensionLeader(file_.get(), APPLICATION_EXT_FUNC_CODE));
    check(EGifPutExtensionBlock(file_.get(), static_cast<int>(kName.size()), kName.data()));
    check(EGifPutExtensionBlock(file_.get(), static_cast<int>(kForEver.size()), kForEver.data()));
    check(EGifPutExtensionTrailer(file_.get()));
  }

  /// Writes the frame that is shown, now that its time is known.
  void write_shown() {
    const bool is_first = state_ == State::first_shown;
    Area area{0, 0, shown_.width(), shown_.height()};
    if (!is_first) area = changed_.value_or(Area{});
    write_frame(area, !is_first);
    for (int y = area.top; y < area.top + area.height; ++y) {
      std::ranges::copy(shown_.row(y), written_.row(y).begin());
    }
    changed_.reset();
    state_ = State::others_shown;
    while (delay_ > 0) write_frame(Area{}, true);
  }

  /// An area of what is shown, for as much of the delay as a frame can say.
  void write_frame(const Area& area, bool onto_another) {
    const auto delay = static_cast<int>(std::min(delay_, kMostDelay));
    delay_ -= delay;
    if (error_ != 0) return;
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, delay,
                                       onto_another ? transparent() : NO_TRANSPARENT_COLOR};
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    check(EGifPutExtension(file_.get(), GRAPHICS_EXT_FUNC_CODE, bytes.size(), bytes.data()));
    check(EGifPutImageDesc(file_.get(), area.left, area.top, area.width, area.height, false,
                           nullptr));
    std::optional<Index> last;
    for (int y = area.top; y < area.top + area.height; ++y) {
      last = write_row(area, y, onto_another, last);
    }
    write_blocks(encoder_.finish());
  }

  /// Row y of an area, behind that pixel; returns the last one. A pixel that stays as it is may be written or be
  /// transparent: what repeats the pixel before compresses better.
  Index write_row(const Area& area, int y, bool onto_another, std::optional<Index> last) {
    const auto part = [&](const Grid<Index>& image) {
      return image.row(y).subspan(static_cast<std::size_t>(area.left),
                                  static_cast<std::size_t>(area.width));
    };
    const auto shown = part(shown_);
    const auto written = part(written_);
    if (onto_another && std::ranges::equal(shown, written)) {
      encoder_.add(transparent(), area.width);
      return transparent();
    }
    bool any = last.has_value();
    Index current = last.value_or(Index{});
    int run = 0;
    for (std::size_t x = 0; x < shown.size(); ++x) {
      const bool stays = onto_another && shown[x] == written[x];
      const bool repeats = any && shown[x] == current;
      const Index index = stays && !repeats ? transparent() : shown[x];
      if (run > 0 && index != current) {
        encoder_.add(current, run);
        run = 0;
      }
      current = index;
      any = true;
      ++run;
    }
    encoder_.add(current, run);
    return current;
  }

  /// What the library would compress pixel by pixel.
  void write_blocks(const std::string& blocks) {
    const auto* block = reinterpret_cast<const GifByteType*>(blocks.data());
    for (; *block != 0; block += *block + 1) check(EGifPutCodeNext(file_.get(), block));
    check(EGifPutCodeNext(file_.get(), nullptr));
  }

  NearestColours colours_;
  std::vector<Index> row_;
  Grid<Index> written_;          // what viewers show after the last frame that was written
  Grid<Index> shown_;            // the frame whose time is not over
  std::optional<Area> changed_;  // where they differ, but for the first frame
  Grid<std::uint32_t> pixels_;   // of the frame that was added last
  LzwEncoder encoder_;
  State state_ = State::empty;
  std::int64_t delay_ = 0;
  int error_ = 0;
  std::string bytes_;
  std::unique_ptr<GifFileType, GifCloser> file_;
};

GifAnimation::GifAnimation(int width, int height, std::vector<std::uint32_t> palette) {
  assert(width >= 1 && width <= kMostGifPixels && height >= 1 && height <= kMostGifPixels);
  assert(!palette.empty() && palette.size() <= kMostGifColours);
  writer_ = std::make_unique<Writer>(width, height, std::move(palette));
}

GifAnimation::GifAnimation(GifAnimation&&) noexcept = default;
GifAnimation& GifAnimation::operator=(GifAnimation&&) noexcept = default;
GifAnimation::~GifAnimation() = default;

void GifAnimation::add(const Grid<std::uint32_t>& pixels, int centiseconds) {
  assert(pixels.width() == writer_->width() && pixels.height() == writer_->height());
  assert(centiseconds >= 0);
  writer_->add(pixels, centiseconds);
}

Expected<std::string, Error> GifAnimation::finish() { return writer_->finish(); }

std::vector<std::uint32_t> palette_of(std::span<const Grid<std::uint32_t>> frames) {
  std::unordered_map<std::uint32_t, std::uint64_t> counts;
  for (const Grid<std::uint32_t>& frame : frames) {
    for_runs_of(frame.values(), [&](std::uint32_t colour, std::ptrdiff_t length) {
      counts[colour] += static_cast<std::uint64_t>(length);
    });
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> ranking;
  ranking.reserve(counts.size());
  for (const auto& [colour, count] : counts) ranking.emplace_back(count, colour);
  const auto more_frequent = [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  };
  const std::size_t size = std::min(ranking.size(), kMostGifColours);
  const auto end = ranking.begin() + static_cast<std::ptrdiff_t>(size);
  std::partial_sort(ranking.begin(), end, ranking.end(), more_frequent);
  std::vector<std::uint32_t> palette;
  std::transform(ranking.begin(), end, std::back_inserter(palette),
                 [](const auto& entry) { return entry.second; });
  return palette;
}

}  // namespace wend
