#include "wend/generate/generators.hpp"

#include "wend/generate/generator_info.hpp"

namespace wend {
namespace {

std::string text_of(MapSize size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}  // namespace

std::string fault_of(MapSize size, MapSize least) {
  if (size.width < least.width || size.height < least.height) {
    return "too small: it needs at least " + text_of(least);
  }
  constexpr MapSize kMost{kMostGeneratedCells, kMostGeneratedCells};
  if (size.width <= kMost.width && size.height <= kMost.height) return {};
  return "too large: it can have at most " + text_of(kMost);
}

Error size_error(std::string_view name, MapSize size, std::string_view fault) {
  return {Status::invalid_option, "a map of kind '" + std::string(name) + "' with " +
                                      text_of(size) + " cells is " + std::string(fault)};
}

#define WEND_GENERATOR(name) GeneratorInfo name##_generator();
#include "wend/generate/generators.def"

const Registry<GeneratorInfo>& generators() {
  static const Registry<GeneratorInfo> registry({
#define WEND_GENERATOR(name) name##_generator(),
#include "wend/generate/generators.def"
  });
  return registry;
}

GeneratorResult make_map(std::string_view kind, int width, int height, std::uint64_t seed,
                         const OptionValues& options) {
  const auto info = generators().named("generator", kind);
  if (!info) return Unexpected<Error>(info.error());
  return (*info)->make(width, height, seed, options);
}

}  // namespace wend
