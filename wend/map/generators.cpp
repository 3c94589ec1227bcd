#include "wend/map/generators.hpp"

#include "wend/map/generator_kinds.hpp"

namespace wend {
namespace {

std::string text_of(MapSize size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}  // namespace

std::optional<GeneratorError> check_size(std::string_view name, MapSize size, MapSize least) {
  const std::string such =
      "a map of kind '" + std::string(name) + "' with " + text_of(size) + " cells is too ";
  if (size.width < least.width || size.height < least.height) {
    return GeneratorError{such + "small: it needs at least " + text_of(least)};
  }
  if (size.width > kMostGeneratedCells || size.height > kMostGeneratedCells) {
    return GeneratorError{such + "large: it can have at most " +
                          text_of({kMostGeneratedCells, kMostGeneratedCells})};
  }
  return std::nullopt;
}

const Registry<GeneratorInfo>& generators() {
  static const Registry<GeneratorInfo> registry({
      random_generator(),
      maze_generator(),
      rooms_generator(),
      office_generator(),
      warehouse_generator(),
      rough_generator(),
  });
  return registry;
}

}  // namespace wend
