#pragma once

// How a controller is made from its options as text: what ControllerInfo::make does.

#include <memory>

#include "wend/control/controller.hpp"

namespace wend {

template <class Made, class Options>
ControllerResult make_controller(const OptionValues& values) {
  const auto options = parse_options<Options>(values);
  if (!options) return Unexpected<OptionError>(options.error());
  return std::make_unique<Made>(*options);
}

}  // namespace wend
