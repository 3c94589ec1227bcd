#include "wend/render/animation/gif.hpp"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <iterator>
#include <unordered_map>

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

/// The smallest area in which two images differ; nothing if they are equal.
std::optional<Area> changed_area(const Grid<Index>& a, const Grid<Index>& b) {
  int left = a.width();
  int right = -1;
  int top = -1;
  int bottom = -1;
  for (int y = 0; y < a.height(); ++y) {
    const auto row = a.row(y);
    const auto other = b.row(y);
    const auto first = std::mismatch(row.begin(), row.end(), other.begin()).first;
    if (first == row.end()) continue;
    const auto last = std::mismatch(row.rbegin(), row.rend(), other.rbegin()).first;
    left = std::min(left, static_cast<int>(first - row.begin()));
    right = std::max(right, static_cast<int>(row.rend() - last) - 1);
    if (top < 0) top = y;
    bottom = y;
  }
  if (top < 0) return std::nullopt;
  return Area{left, top, right - left + 1, bottom - top + 1};
}

}  // namespace

class GifAnimation::Writer {
 public:
  Writer(int width, int height, std::vector<std::uint32_t> palette)
      : colours_(std::move(palette)),
        written_(width, height),
        shown_(width, height),
        next_(width, height),
        pixels_(width, height),
        file_(EGifOpen(&bytes_, append_bytes, &error_)) {
    if (file_ != nullptr) write_head();
  }

  int width() const { return shown_.width(); }
  int height() const { return shown_.height(); }

  void add(const Grid<std::uint32_t>& pixels, int centiseconds) {
    for (int y = 0; y < pixels.height(); ++y) take_row(pixels.row(y), y);
    if (state_ == State::empty || shown_ != next_) {
      write_shown();
      std::swap(shown_, next_);
      state_ = state_ == State::empty ? State::first_shown : State::others_shown;
    }
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

  /// Into the next frame. Most rows of most frames are those of the frame before.
  void take_row(std::span<const std::uint32_t> row, int y) {
    if (state_ != State::empty && std::ranges::equal(row, pixels_.row(y))) {
      std::ranges::copy(shown_.row(y), next_.row(y).begin());
      return;
    }
    std::ranges::copy(row, pixels_.row(y).begin());
    const auto indices = next_.row(y);
    for (std::size_t x = 0; x < row.size(); ++x) {
      indices[x] = x > 0 && row[x] == row[x - 1] ? indices[x - 1] : colours_[row[x]];
    }
  }

  void check(int result) {
    if (result == GIF_ERROR && error_ == 0) error_ = file_->Error;
  }

  Index transparent() const { return static_cast<Index>(colours_.palette().size()); }

  void write_head() {
    const auto& palette = colours_.palette();
    const auto size = std::bit_ceil(palette.size() + 1);
    const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> map(
        GifMakeMapObject(static_cast<int>(size), nullptr), GifFreeMapObject);
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
    if (state_ == State::empty) return;
    const bool is_first = state_ == State::first_shown;
    Area area{0, 0, shown_.width(), shown_.height()};
    if (!is_first) area = changed_area(written_, shown_).value_or(Area{});
    write_frame(area, !is_first);
    written_ = shown_;
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
    int last = -1;
    for (int y = area.top; y < area.top + area.height; ++y) {
      last = choose_line(area, y, onto_another, last);
      check(EGifPutLine(file_.get(), line_.data(), area.width));
    }
  }

  /// Chooses what to write for row y of an area; returns the last pixel. One that stays as it is
  /// may be written or be transparent: what repeats the pixel before compresses better.
  int choose_line(const Area& area, int y, bool onto_another, int last) {
    line_.clear();
    for (int x = area.left; x < area.left + area.width; ++x) {
      const Index index = shown_[{x, y}];
      const bool stays = onto_another && index == written_[{x, y}];
      last = stays && index != last ? transparent() : index;
      line_.push_back(static_cast<Index>(last));
    }
    return last;
  }

  std::vector<Index> line_;
  NearestColours colours_;
  Grid<Index> written_;  // what viewers show after the last frame that was written
  Grid<Index> shown_;    // the frame whose time is not over
  Grid<Index> next_;
  Grid<std::uint32_t> pixels_;  // of the frame that was added last
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
    for (const std::uint32_t colour : frame.values()) ++counts[colour];
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
