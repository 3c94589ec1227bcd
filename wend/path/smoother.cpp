#include "wend/path/smoother.hpp"

namespace wend {

#define WEND_SMOOTHER(name) SmootherInfo name##_smoother();
#include "wend/path/smoothers.def"

const Registry<SmootherInfo>& smoothers() {
  static const Registry<SmootherInfo> registry({
#define WEND_SMOOTHER(name) name##_smoother(),
#include "wend/path/smoothers.def"
  });
  return registry;
}

}  // namespace wend
