#pragma once

// The kinds of generators, one source file each. To add one, write generate_<name>.cpp, declare its
// function here and list it in generators.cpp.

#include <optional>
#include <string>
#include <string_view>

#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"

namespace wend {

GeneratorInfo random_generator();
GeneratorInfo maze_generator();
GeneratorInfo rooms_generator();
GeneratorInfo office_generator();
GeneratorInfo warehouse_generator();
GeneratorInfo rough_generator();
GeneratorInfo car_generator();
GeneratorInfo parking_generator();

/// What a step on a rough road costs, as `~` in text grids.
inline constexpr double kRoughRoad = 2;

struct MapSize {
  int width;
  int height;
};

/// The size, and what is wrong with it: "a map of kind 'maze' with 2 x 9 cells is too small: ...".
GeneratorError size_error(std::string_view name, MapSize size, std::string_view wrong);

/// What is wrong with a size, if anything.
std::optional<GeneratorError> check_size(std::string_view name, MapSize size, MapSize least);

/// What every generator has in common. Options is an option struct that also has a
/// `MapSize least_size() const`, and a `std::string shortage(MapSize) const` if a map can be too
/// small for it in another way: "too small: ..." or empty. `generate` is called with checked
/// options and sizes only.
template <class Options>
GeneratorInfo generator_info(const std::string& name, std::string summary,
                             GridMap (*generate)(MapSize, const Options&, Random&)) {
  GeneratorInfo info;
  info.name = name;
  info.summary = std::move(summary);
  info.least_width = Options{}.least_size().width;
  info.least_height = Options{}.least_size().height;
  info.connected = true;
  info.free_corner = 1;
  info.options = option_schema<Options>();
  info.make = [name, generate](int width, int height, std::uint64_t seed,
                               const OptionValues& values) -> GeneratorResult {
    const auto options = parse_options<Options>(values);
    if (!options) return Unexpected<GeneratorError>({options.error().message()});
    const MapSize size{width, height};
    if (auto error = check_size(name, size, options->least_size())) {
      return Unexpected<GeneratorError>(*std::move(error));
    }
    if constexpr (requires { options->shortage(size); }) {
      const std::string shortage = options->shortage(size);
      if (!shortage.empty()) return Unexpected<GeneratorError>(size_error(name, size, shortage));
    }
    Random random(seed);  // NOLINT(misc-const-correctness): generate() draws from it
    return generate(size, *options, random);
  };
  return info;
}

}  // namespace wend
