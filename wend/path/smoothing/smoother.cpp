#include "wend/path/smoothing/smoother.hpp"

namespace wend {

// The list may be another one: lab/wasm/first has none.
#define WEND_SMOOTHER(name) SmootherInfo name##_smoother();
#include "wend/path/smoothing/smoothers.def"

const Registry<SmootherInfo>& smoothers() {
  static const Registry<SmootherInfo> registry({
#define WEND_SMOOTHER(name) name##_smoother(),
#include "wend/path/smoothing/smoothers.def"
  });
  return registry;
}

SmootherResult make_smoother(std::string_view name, const OptionValues& options) {
  const auto info = smoothers().named("smoother", name);
  if (!info) return Unexpected<Error>(info.error());
  return (*info)->make(options);
}

}  // namespace wend
