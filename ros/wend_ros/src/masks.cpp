#include "wend_ros/masks.hpp"

#include <ros/ros.h>

#include <sstream>
#include <utility>

#include "wend/io/map/load_mask.hpp"
#include "wend/map/masked.hpp"

namespace wend_ros {
namespace {

wend::Expected<wend::GridMap, wend::Error> loaded(const std::string& text) {
  const auto spec = wend::parse_mask_spec(text);
  if (!spec) return wend::Unexpected<wend::Error>(spec.error());
  auto mask = wend::load_mask(spec->file, spec->reading);
  if (!mask) return wend::Unexpected<wend::Error>(std::move(mask.error()));
  return std::move(mask->map);
}

/// The texts of a list, or of one text with commas; an error for anything else.
wend::Expected<std::vector<std::string>, wend::Error> texts_of(XmlRpc::XmlRpcValue value) {
  std::vector<std::string> texts;
  if (value.getType() == XmlRpc::XmlRpcValue::TypeString) {
    std::istringstream words(static_cast<std::string>(value));
    for (std::string word; std::getline(words, word, ',');) {
      if (!word.empty()) texts.push_back(word);
    }
    return texts;
  }
  bool right = value.getType() == XmlRpc::XmlRpcValue::TypeArray;
  for (int i = 0; right && i < value.size(); ++i) {
    right = value[i].getType() == XmlRpc::XmlRpcValue::TypeString;
    if (right) texts.push_back(static_cast<std::string>(value[i]));
  }
  if (right) return texts;
  return wend::failure(wend::Status::invalid_option, "a list or a text of masks expected");
}

wend::Unexpected<wend::Error> failed(const std::string& spec, wend::Error error) {
  error.message = "mask " + spec + ": " + error.message;
  return wend::Unexpected<wend::Error>(std::move(error));
}

}  // namespace

Masks Masks::of_parameter(const ros::NodeHandle& own) {
  XmlRpc::XmlRpcValue value;
  Masks masks;
  if (!own.getParam("masks", value)) return masks;
  if (const auto texts = texts_of(value)) {
    masks = of(*texts);
  } else {
    masks.masks_.push_back({"~masks", wend::Unexpected<wend::Error>(texts.error())});
  }
  for (const Mask& mask : masks.masks_) {
    if (!mask.map) ROS_ERROR_STREAM("~masks: " << mask.spec << ": " << mask.map.error().message);
  }
  return masks;
}

Masks Masks::of(const std::vector<std::string>& specs) {
  Masks masks;
  for (const std::string& spec : specs) masks.masks_.push_back({spec, loaded(spec)});
  return masks;
}

wend::Expected<wend::GridMap, wend::Error> Masks::over(
    wend::Expected<wend::GridMap, wend::Error> map) const {
  for (const Mask& mask : masks_) {
    if (!map) break;
    if (!mask.map) return failed(mask.spec, mask.map.error());
    map = wend::masked(*map, *mask.map);
    if (!map) return failed(mask.spec, std::move(map.error()));
  }
  return map;
}

}  // namespace wend_ros
