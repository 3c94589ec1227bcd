#include "wend/control/controller.hpp"

namespace wend {

#define WEND_CONTROLLER(name) ControllerInfo name##_controller();
#include "wend/control/controllers.def"
#undef WEND_CONTROLLER

const Registry<ControllerInfo>& controllers() {
  static const Registry<ControllerInfo> registry({
#define WEND_CONTROLLER(name) name##_controller(),
#include "wend/control/controllers.def"
#undef WEND_CONTROLLER
  });
  return registry;
}

std::optional<std::string> why_unfit(const ControllerInfo& info, const MotionModel& model) {
  if (!info.turns_in_place || model.turning_radius() == 0) return std::nullopt;
  return "the controller '" + info.name + "' turns in place, and a bicycle cannot";
}

}  // namespace wend
