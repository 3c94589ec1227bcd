#pragma once

// How a generator is described and made from its options: code that the files of generators.def share.

#include <string>
#include <string_view>
#include <utility>

#include "wend/base/random.hpp"
#include "wend/generate/generators.hpp"

namespace wend {

/// The cost of a step on a rough road, as `~` in text grids.
inline constexpr double kRoughRoad = 2;

struct MapSize {
  int width;
  int height;
};

/// The error in a size, "too small: it needs at least 3 x 3"; empty if the size is valid.
std::string fault_of(MapSize size, MapSize least);

/// "a map of kind 'maze' with 2 x 9 cells is too small: ...".
Error size_error(std::string_view name, MapSize size, std::string_view fault);

/// The common part of every generator. Options is an option struct that also has a
/// `MapSize least_size() const`, and a `std::string shortage(MapSize) const` if a map can be too
/// small for it in another way: "too small: ..." or empty. `generate` is called only with valid
/// options and sizes.
template <class Options>
GeneratorInfo generator_info(const std::string& name, std::string summary,
                             GridMap (*generate)(MapSize, const Options&, Random&)) {
  GeneratorInfo info;
  info.name = name;
  info.summary = std::move(summary);
  info.least_width = Options{}.least_size().width;
  info.least_height = Options{}.least_size().height;
  info.options = option_schema<Options>();
  info.make = [name, generate](int width, int height, std::uint64_t seed,
                               const OptionValues& values) -> GeneratorResult {
    const auto options = parse_options<Options>(values);
    if (!options) return Unexpected<Error>(options.error());
    const MapSize size{width, height};
    std::string fault = fault_of(  // NOLINT(misc-const-correctness): not where there is a shortage
        size, options->least_size());
    if constexpr (requires { options->shortage(size); }) {
      if (fault.empty()) fault = options->shortage(size);
    }
    if (!fault.empty()) return Unexpected<Error>(size_error(name, size, fault));
    Random random(seed);  // NOLINT(misc-const-correctness): generate() draws from it
    return generate(size, *options, random);
  };
  return info;
}

}  // namespace wend
