#include "programs/own_osmesa.h"

#include "base/environment_variable.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;
constexpr const char* kLibrary = "libOSMesa.so.8";
constexpr const char* kFolder = "osmesa";

bool isIn(const std::string& folder) {
  std::error_code error;
  return !folder.empty() && fs::exists(fs::path(folder) / kLibrary, error);
}

/// The cache lists names of libraries as text between zero bytes.
bool isInCache() {
  std::ifstream file("/etc/ld.so.cache", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return bytes.find(std::string(kLibrary) + '\0') != std::string::npos;
}

bool machineHasOne() {
  std::istringstream folders(environmentVariable("LD_LIBRARY_PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (isIn(folder) && !isOwnOsMesa(folder + "/" + kLibrary)) return true;
  for (const char* folder : {"/lib", "/usr/lib", "/lib64", "/usr/lib64"})
    if (isIn(folder)) return true;
  return isInCache();
}

}  // namespace

std::string ownOsMesa(const std::string& libraryDirectory) {
  const std::string folder = libraryDirectory + "/" + kFolder;
  return isIn(folder) && !machineHasOne() ? folder : "";
}

bool isOwnOsMesa(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return path == "not" || (folder.filename() == kFolder && folder.parent_path().filename() == "gluray");
}

}  // namespace gluray::launcher
