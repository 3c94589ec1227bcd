#include "wend_ros/masks.hpp"

#include <utility>

#include "wend/io/map/load_mask.hpp"
#include "wend/map/masked.hpp"

namespace wend_ros {
namespace {

wend::Expected<wend::LoadedMap, wend::Error> loaded(const std::string& text) {
  const auto spec = wend::parse_mask_spec(text);
  if (!spec) return wend::Unexpected<wend::Error>(spec.error());
  return wend::load_mask(spec->file, spec->reading);
}

wend::Unexpected<wend::Error> failed(const std::string& spec, wend::Error error) {
  error.message = "mask " + spec + ": " + error.message;
  return wend::Unexpected<wend::Error>(std::move(error));
}

}  // namespace

Masks Masks::of(const std::vector<std::string>& specs) {
  Masks masks;
  for (const std::string& spec : specs) {
    auto mask = loaded(spec);
    if (mask) {
      masks.masks_.push_back({spec, std::move(mask->map), std::move(mask->notes)});
    } else {
      masks.masks_.push_back({spec, wend::Unexpected<wend::Error>(std::move(mask.error())), {}});
    }
  }
  return masks;
}

std::vector<std::string> Masks::faults() const {
  std::vector<std::string> faults;
  for (const Mask& mask : masks_) {
    if (!mask.map) faults.push_back("mask " + mask.spec + ": " + mask.map.error().message);
  }
  return faults;
}

std::vector<std::string> Masks::notes() const {
  std::vector<std::string> notes;
  for (const Mask& mask : masks_) {
    for (const std::string& note : mask.notes) notes.push_back("mask " + mask.spec + ": " + note);
  }
  return notes;
}

wend::Expected<wend::GridMap, wend::Error> Masks::lay_over(wend::GridMap map) {
  on_grid_.reset();
  for (const Mask& mask : masks_) {
    if (!mask.map) return failed(mask.spec, mask.map.error());
    auto here =
        on_grid_ ? wend::masked(*on_grid_, *mask.map) : wend::mask_on_grid_of(map, *mask.map);
    if (!here) return failed(mask.spec, std::move(here.error()));
    on_grid_ = *std::move(here);
  }
  if (!on_grid_) return map;
  return wend::masked(map, *on_grid_);
}

wend::MapEdit Masks::over(wend::MapEdit edit) const {
  return on_grid_ ? wend::masked_edit(std::move(edit), *on_grid_) : edit;
}

}  // namespace wend_ros
