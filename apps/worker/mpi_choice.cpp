#include "mpi_choice.h"

#include "cluster/ranks/alone.h"
#include "cluster/ranks/mpi_plugin.h"

#include <dlfcn.h>

#include <cstring>
#include <filesystem>
#include <system_error>

namespace gluray::worker {
namespace {

/// The library for an implementation: beside the engine, found relative to this program.
std::string libraryOf(const std::string& name) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* way : {"../lib/gluray", "../../lib/gluray"})
    if (const auto path = folder / way / ("libgluray-mpi-" + name + ".so");
        std::filesystem::exists(path, error))
      return path.lexically_normal();
  return "";
}

}  // namespace

std::string launchersMpi(const std::function<std::string(const char*)>& variable) {
  const auto isSet = [&](const char* name) { return !variable(name).empty(); };
  if (isSet("OMPI_COMM_WORLD_SIZE")) return "openmpi";
  if (isSet("PMI_RANK") || isSet("PMI_SIZE")) return "mpich";
  if (isSet("PMIX_RANK")) return "openmpi";  // srun --mpi=pmix
  return "none";
}

std::unique_ptr<cluster::Ranks> startRanks(const std::string& name, int* argc, char*** argv,
                                           std::string& why) {
  if (name == "none") return std::make_unique<cluster::Alone>();
  const std::string path = name.find('/') == std::string::npos ? libraryOf(name) : name;
  if (path.empty()) {
    why = "this GLuRay was built without " + name +
          "; build it where that is installed, or name a library with --mpi";
    return nullptr;
  }
  // Global: MPI's own plugins look for its symbols.
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!library) {
    why = std::string("MPI cannot be loaded: ") + dlerror();
    return nullptr;
  }
  const auto plugin = reinterpret_cast<cluster::MpiPluginVersion>(dlsym(library, cluster::kMpiPluginVersion));
  const auto make = reinterpret_cast<cluster::MakeMpiRanks>(dlsym(library, cluster::kMakeMpiRanks));
  if (!plugin || !make || std::strcmp(plugin(), GLURAY_VERSION) != 0) {
    why = path + " belongs to another GLuRay than this " GLURAY_VERSION;
    return nullptr;
  }
  char reason[512] = {};
  std::unique_ptr<cluster::Ranks> ranks(make(argc, argv, reason, sizeof reason));
  if (!ranks) why = reason;
  return ranks;
}

}  // namespace gluray::worker
