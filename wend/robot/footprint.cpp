#include "wend/robot/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/box.hpp"
#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

constexpr std::string_view kDisc = "disc:";
constexpr std::string_view kRectangle = "rect:";
constexpr std::string_view kBlanks = " ";
constexpr std::size_t kLongestQuote = 40;  // bytes of a wrong text that an error repeats

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// Quotes a text in apostrophes and limits its length.
std::string quoted(std::string_view text) {
  return "'" + std::string(text.substr(0, kLongestQuote)) +
         (text.size() > kLongestQuote ? "...'" : "'");
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// Splits "[[x, y], [x, y]]" into the texts "x, y"; nothing if brackets are missing.
std::optional<std::vector<std::string_view>> corners_in_brackets(std::string_view text) {
  if (text.size() < 2 || text.back() != ']') return std::nullopt;
  text = trimmed(text.substr(1, text.size() - 2));
  std::vector<std::string_view> corners;
  for (;;) {
    const std::size_t end = text.find(']');
    if (text.empty() || text.front() != '[' || end == std::string_view::npos) return std::nullopt;
    corners.push_back(text.substr(1, end - 1));
    text = trimmed(text.substr(end + 1));
    if (text.empty()) return corners;
    if (text.front() != ',') return std::nullopt;
    text = trimmed(text.substr(1));
  }
}

Unexpected<Error> refused_corner(std::string_view text, std::size_t i) {
  const std::string where = "corner " + std::to_string(i + 1);
  return failure(Status::invalid_option, where + ", " + quoted(text) + ", is not two numbers 'x,y'",
                 where);
}

Unexpected<Error> too_many_corners(std::size_t number) {
  return failure(Status::invalid_option, "a polygon has at most " +
                                             std::to_string(Polygon::kMostCorners) +
                                             " corners, not " + std::to_string(number));
}

Expected<Footprint, Error> polygon_of(const std::vector<std::string_view>& texts) {
  if (texts.size() > Polygon::kMostCorners + 1) return too_many_corners(texts.size());
  std::vector<Point> corners;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const auto numbers = split(texts[i], ',');
    if (numbers.size() != 2) return refused_corner(texts[i], i);
    const auto x = parse_number(numbers[0]);
    const auto y = parse_number(numbers[1]);
    if (!x || !y) return refused_corner(texts[i], i);
    corners.push_back({*x, *y});
  }
  auto outline = Polygon::make(std::move(corners));
  if (!outline) return Unexpected<Error>(std::move(outline).error());
  return Footprint::polygon(*std::move(outline));
}

Expected<Footprint, Error> disc_of(std::string_view text) {
  if (text.size() > kLongestQuote) {
    return failure(Status::invalid_option,
                   "the radius of the disc: " + quoted(text) + " is not a number");
  }
  double radius = 0;
  const std::string wrong = parse_in_range(text, radius, 0, Footprint::kLargestRadius, "m");
  if (!wrong.empty()) return failure(Status::invalid_option, "the radius of the disc: " + wrong);
  return Footprint::disc(radius);
}

/// Reads "LENGTHxWIDTH" or "LENGTHxWIDTH,AHEAD".
Expected<Footprint, Error> rectangle_of(std::string_view text) {
  const auto wrong = [&](const std::string& why) {
    return failure(Status::invalid_option, "the rectangle " + quoted(text) + ": " + why);
  };
  const auto parts = split(text, ',');
  const auto sides = split(parts.front(), 'x');
  if (parts.size() > 2 || sides.size() != 2) {
    return wrong("write rect:LENGTHxWIDTH, or rect:LENGTHxWIDTH,AHEAD");
  }
  std::array<double, 3> numbers{};
  const std::array texts{sides[0], sides[1], parts.size() == 2 ? parts[1] : std::string_view("0")};
  constexpr std::array<std::string_view, 3> kNames{"length", "width", "distance ahead"};
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const auto number = parse_number(texts[i]);
    if (!number)
      return wrong("its " + std::string(kNames[i]) + ", " + quoted(texts[i]) + ", is not a number");
    numbers[i] = *number;
  }
  return Footprint::rectangle(numbers[0], numbers[1], numbers[2]);
}

/// Looks for a large disc in a polygon near the base point, which lies outside. It tells where the base point can be:
/// the larger the disc and the nearer, the better.
class InnerDiscSearch {
 public:
  explicit InnerDiscSearch(const Polygon& outline)
      : outline_(outline), best_(outline.corners().front()), most_(value_at(best_)) {}

  /// A search by pattern, from the best of a lattice of points.
  InnerDisc run() {
    Box box(best_);
    for (const Point corner : outline_.corners()) box.include(corner);
    const double width = box.high.x - box.low.x;
    const double height = box.high.y - box.low.y;
    constexpr int kPoints = 16;
    for (int i = 1; i < kPoints; ++i) {
      for (int j = 1; j < kPoints; ++j) {
        offer({box.low.x + width * i / kPoints, box.low.y + height * j / kPoints});
      }
    }
    double step = std::max(width, height) / kPoints;
    constexpr int kTries = 64;
    for (int i = 0; i < kTries; ++i) {
      const double before = most_;
      for (const Point by : {Point{step, 0}, Point{-step, 0}, Point{0, step}, Point{0, -step}}) {
        offer({best_.x + by.x, best_.y + by.y});
      }
      if (most_ == before) step /= 2;
    }
    const double radius = depth(best_);
    return radius > 0 ? InnerDisc{best_, radius} : InnerDisc{outline_.corners().front(), 0};
  }

 private:
  /// How far a point is inside; negative outside.
  double depth(Point point) const {
    const double away = distance_to_outline(outline_, point);
    return is_inside(outline_.corners(), point) ? away : -away;
  }

  double value_at(Point point) const { return 2 * depth(point) - distance(Point{0, 0}, point); }

  void offer(Point point) {
    const double value = value_at(point);
    if (value <= most_) return;
    best_ = point;
    most_ = value;
  }

  const Polygon& outline_;
  Point best_;
  double most_;
};

/// Counter-clockwise, without points on its edges: A. Andrew's monotone chains, 1979.
std::vector<Point> convex_hull(std::vector<Point> points) {
  constexpr double kFlat = 1e-12;
  const auto turns_left = [](Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > kFlat;
  };
  std::ranges::sort(points,
                    [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Point> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const Point point : points) {
      while (hull.size() >= begin + 2 && !turns_left(hull[hull.size() - 2], hull.back(), point)) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

/// A sum of numbers of this size as one would write it: -0.2, not -0.19999999999999998.
double without_noise(double sum, double size) {
  constexpr double kNanometres = 1e9;
  constexpr double kNoise = 4e-16;
  const double rounded = std::round(sum * kNanometres) / kNanometres;
  return std::abs(rounded - sum) <= kNoise * size ? rounded : sum;
}

}  // namespace

Expected<Footprint, Error> Footprint::polygon(Polygon outline) {
  const Point base{0, 0};
  Footprint footprint(0, farthest_distance(outline, base));
  footprint.covers_base_ = outline.contains(base);
  footprint.inner_ = footprint.covers_base_ ? InnerDisc{base, distance_to_outline(outline, base)}
                                            : InnerDiscSearch(outline).run();
  footprint.polygon_ = std::make_shared<const Polygon>(std::move(outline));
  return footprint;
}

Expected<Footprint, Error> Footprint::rectangle(double length, double width, double ahead) {
  constexpr double kLargest = Polygon::kLargestCoordinate;
  const auto wrong = [](const std::string& name, double value, double least) {
    return failure(Status::invalid_option,
                   "the rectangle's " + name + " is " + format_number(value) + ": a number " +
                       (least < 0 ? "from -1e6" : "above 0") + " to 1e6 expected",
                   name);
  };
  if (!(length > 0 && length <= kLargest)) return wrong("length", length, 0);
  if (!(width > 0 && width <= kLargest)) return wrong("width", width, 0);
  if (!(std::abs(ahead) <= kLargest)) return wrong("distance ahead", ahead, -kLargest);
  const double size = std::abs(ahead) + length;
  const double front = without_noise(ahead + length / 2, size);
  const double rear = without_noise(ahead - length / 2, size);
  const double side = width / 2;
  auto outline = Polygon::make({{front, side}, {rear, side}, {rear, -side}, {front, -side}});
  if (!outline) return Unexpected<Error>(std::move(outline).error());
  return polygon(*std::move(outline));
}

Footprint Footprint::scaled(double factor) const {
  Footprint footprint = *this;
  const Point centre = inner_.centre;
  footprint.inner_ = {{centre.x * factor, centre.y * factor}, inner_.radius * factor};
  footprint.circumscribed_ *= factor;
  if (polygon_) footprint.polygon_ = std::make_shared<const Polygon>(polygon_->scaled(factor));
  return footprint;
}

Footprint Footprint::grown(double margin) const {
  constexpr int kSides = 8;
  Footprint around = disc(circumscribed_ + margin);
  if (!polygon_ || margin == 0) return polygon_ ? *this : around;
  std::vector<Point> points;
  const double reach = margin / sine_and_cosine(kPi / kSides).cosine;
  for (const Point corner : polygon_->corners()) {
    for (int i = 0; i < kSides; ++i) {
      const double angle = (2 * i + 1) * kPi / kSides;
      const auto [sine, cosine] = sine_and_cosine(angle);
      points.push_back({corner.x + reach * cosine, corner.y + reach * sine});
    }
  }
  auto hull = Polygon::make(convex_hull(std::move(points)));
  if (!hull) return around;
  return polygon(*std::move(hull)).value_or(around);
}

Expected<Footprint, Error> parse_footprint(std::string_view typed) {
  std::string line(typed);  // control characters become blanks, here and in errors
  const auto is_control = [](unsigned char letter) { return letter < ' '; };
  std::replace_if(line.begin(), line.end(), is_control, ' ');
  const std::string_view text = trimmed(line);
  if (text == "point") return Footprint();
  if (text.starts_with(kDisc)) return disc_of(trimmed(text.substr(kDisc.size())));
  if (text.starts_with(kRectangle)) return rectangle_of(trimmed(text.substr(kRectangle.size())));
  if (text.starts_with('[')) {
    const auto corners = corners_in_brackets(text);
    if (corners) return polygon_of(*corners);
    return failure(Status::invalid_option,
                   quoted(text) + " is not a list of corners '[[x, y], [x, y], ...]'");
  }
  auto corners = split(text, ';');
  if (corners.size() > 1 && corners.back().empty()) corners.pop_back();
  if (corners.size() > 1) return polygon_of(corners);
  std::string message = quoted(text) +
                        " is not a footprint: give corners 'x,y;x,y;x,y', "
                        "'rect:LENGTHxWIDTH', or 'disc:RADIUS'";
  if (parse_number(text) && text.size() < kLongestQuote)
    message += "; did you mean 'disc:" + std::string(text) + "'?";
  return failure(Status::invalid_option, std::move(message));
}

std::string text_of(const Footprint& footprint) {
  if (footprint.is_point()) return "point";
  if (!footprint.outline()) {
    return std::string(kDisc) + format_number(footprint.circumscribed_radius());
  }
  std::string text;
  for (const Point corner : footprint.outline()->corners()) {
    if (!text.empty()) text += ';';
    text += format_number(corner.x) + "," + format_number(corner.y);
  }
  return text;
}

}  // namespace wend
