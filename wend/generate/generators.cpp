#include "wend/generate/generators.hpp"

#include "wend/generate/generator_kinds.hpp"

namespace wend {
namespace {

std::string text_of(MapSize size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}  // namespace

GeneratorError size_error(std::string_view name, MapSize size, std::string_view wrong) {
  return {"a map of kind '" + std::string(name) + "' with " + text_of(size) + " cells is " +
          std::string(wrong)};
}

std::optional<GeneratorError> check_size(std::string_view name, MapSize size, MapSize least) {
  if (size.width < least.width || size.height < least.height) {
    return size_error(name, size, "too small: it needs at least " + text_of(least));
  }
  if (size.width > kMostGeneratedCells || size.height > kMostGeneratedCells) {
    const MapSize most{kMostGeneratedCells, kMostGeneratedCells};
    return size_error(name, size, "too large: it can have at most " + text_of(most));
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
      car_generator(),
      parking_generator(),
  });
  return registry;
}

}  // namespace wend
