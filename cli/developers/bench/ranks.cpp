#include "cli/developers/bench/ranks.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "cli/developers/bench/mpi/mpi_ranks.hpp"
#include "cli/exit_code.hpp"

namespace wend::cli {
namespace {

constexpr const char* kPackages =
    "(in Debian: libopenmpi-dev to build wend, openmpi-bin to run it)";

void* load_module() {
#ifdef WEND_MPI_MODULE
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto file = (program.parent_path() / WEND_MPI_MODULE).lexically_normal();
  // MPI loads parts of its own, which look for it.
  void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (module != nullptr) return module;
  throw InputError(fmt::format("--distributed needs MPI {}: {}", kPackages, dlerror()));
#else
  throw InputError(
      fmt::format("--distributed needs MPI {}, and wend was built without it", kPackages));
#endif
}

template <class Function>
Function* function(void* module, const char* name) {
  void* const found = dlsym(module, name);
  if (found == nullptr) throw InputError(fmt::format("--distributed: {}", dlerror()));
  return reinterpret_cast<Function*>(found);
}

}  // namespace

Ranks::Ranks() : module_(load_module()) {
  auto* const start = function<decltype(wend_mpi_start)>(module_, "wend_mpi_start");
  if (!start(&rank_, &count_)) throw InputError("--distributed: MPI cannot be started");
}

Ranks::~Ranks() { function<decltype(wend_mpi_finish)>(module_, "wend_mpi_finish")(); }

void Ranks::wait_for_all() {
  if (function<decltype(wend_mpi_wait_for_all)>(module_, "wend_mpi_wait_for_all")()) return;
  throw InputError("--distributed: a rank cannot be reached");
}

void Ranks::end_all(int exit_code) {
  function<decltype(wend_mpi_abort)>(module_, "wend_mpi_abort")(exit_code);
  std::_Exit(exit_code);
}

}  // namespace wend::cli
