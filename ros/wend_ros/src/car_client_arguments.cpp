#include "wend_ros/car_client_arguments.hpp"

#include <array>
#include <cstdint>

#include "wend/base/parse.hpp"
#include "wend/generate/generators.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend_ros/car_planning.hpp"

namespace wend_ros {
namespace {

constexpr std::array<const char*, kCarArguments> kNames{
    "mapWidth", "mapHeight", "startX", "startY",        "startD",
    "goalX",    "goalY",     "goalD",  "obstacleCount", "roughRoadCount"};
constexpr std::array<std::int32_t, kCarArguments> kDefaults{20, 20, 0, 0, 2, 18, 18, 2, 25, 25};

struct Ends {
  CarPose start;
  CarPose goal;
};

wend::Unexpected<std::string> wrong(std::string what) {
  return wend::Unexpected<std::string>(std::move(what));
}

Ends ends_of(const std::array<std::int32_t, kCarArguments>& numbers) {
  Ends ends;
  ends.start.x = numbers[2];
  ends.start.y = numbers[3];
  ends.start.d = numbers[4];
  ends.goal.x = numbers[5];
  ends.goal.y = numbers[6];
  ends.goal.d = numbers[7];
  return ends;
}

/// Does no obstacle touch that corner?
bool is_clear(const wend::GridMap& yard, const CarPose& corner) {
  for (int y = corner.y - 1; y <= corner.y; ++y) {
    for (int x = corner.x - 1; x <= corner.x; ++x) {
      const wend::Cell cell{x, y};
      if (yard.contains(cell) && yard.state(cell) == wend::CellState::occupied) return false;
    }
  }
  return true;
}

wend::Expected<CarRequest, std::string> random_request(
    const std::array<std::int32_t, kCarArguments>& numbers, std::uint64_t seed) {
  constexpr std::uint64_t kTries = 1000;
  const wend::GeneratorInfo& car = *wend::generators().find("car");
  const wend::OptionValues options{{"obstacles", std::to_string(numbers[8])},
                                   {"rough", std::to_string(numbers[9])}};
  const Ends ends = ends_of(numbers);
  for (std::uint64_t i = 0; i < kTries; ++i) {
    const auto yard = car.make(numbers[0] - 1, numbers[1] - 1, seed + i, options);
    if (!yard) return wrong(yard.error().message);
    if (!is_clear(*yard, ends.start) || !is_clear(*yard, ends.goal)) continue;
    CarRequest request = request_for(*yard);
    request.start = ends.start;
    request.goal = ends.goal;
    return request;
  }
  return wrong("too many obstacles: the start's or the goal's corner is rarely free");
}

/// From the first corner to the last but one, facing east, as the defaults have it.
wend::Expected<CarRequest, std::string> file_request(const std::string& file) {
  const auto loaded = wend::load_map(file);
  if (!loaded) return wrong(loaded.error().message);
  if (loaded->map.frame().y_up) return wrong(file + ": a yard has y down, as text grids do");
  CarRequest request = request_for(loaded->map);
  request.start.d = kDefaults[4];
  request.goal.x = request.mapWidth - 2;
  request.goal.y = request.mapHeight - 2;
  request.goal.d = kDefaults[7];
  return request;
}

}  // namespace

wend::Expected<CarRequest, std::string> car_request(const std::vector<std::string>& words,
                                                    std::uint64_t seed) {
  constexpr std::string_view kYard = "yard:=";
  if (words.size() == 1 && words.front().starts_with(kYard)) {
    return file_request(words.front().substr(kYard.size()));
  }
  if (words.empty()) return random_request(kDefaults, seed);
  if (words.size() != kCarArguments) {
    return wrong(
        "all ten arguments or none expected (mapWidth mapHeight startX startY startD goalX "
        "goalY goalD obstacleCount roughRoadCount), or yard:=FILE; " +
        std::to_string(words.size()) + " given");
  }
  std::array<std::int32_t, kCarArguments> numbers{};
  for (std::size_t i = 0; i < kCarArguments; ++i) {
    const auto number = wend::parse_integer<std::int32_t>(words[i]);
    if (!number) {
      return wrong(std::string(kNames[i]) + " must be a whole number, not '" + words[i] + "'");
    }
    numbers[i] = *number;
  }
  return random_request(numbers, seed);
}

}  // namespace wend_ros
