#include "doctor/host.h"

#include "base/environment_variable.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;

enum class Manager { apt, dnf, zypper, pacman };

struct System {
  std::string_view id;  // in ID or ID_LIKE
  Manager manager;
  const char* program;
  const char* install;  // the command, without its packages
  const char* glx;      // packages of OpenGL
  const char* egl;
};
constexpr System kSystems[] = {
    {"debian", Manager::apt, "apt", "apt install", "libgl1 libglx-mesa0 libgl1-mesa-dri",
     "libegl1 libegl-mesa0 libgl1-mesa-dri"},
    {"ubuntu", Manager::apt, "apt", "apt install", "libgl1 libglx-mesa0 libgl1-mesa-dri",
     "libegl1 libegl-mesa0 libgl1-mesa-dri"},
    {"fedora", Manager::dnf, "dnf", "dnf install", "libglvnd-glx mesa-libGL mesa-dri-drivers",
     "libglvnd-egl mesa-libEGL mesa-dri-drivers"},
    {"rhel", Manager::dnf, "dnf", "dnf install", "libglvnd-glx mesa-libGL mesa-dri-drivers",
     "libglvnd-egl mesa-libEGL mesa-dri-drivers"},
    {"suse", Manager::zypper, "zypper", "zypper install", "Mesa-libGL1 Mesa-dri", "Mesa-libEGL1 Mesa-dri"},
    {"arch", Manager::pacman, "pacman", "pacman -S", "libglvnd mesa", "libglvnd mesa"},
};

const System* systemOf(const Host& host) {
  std::istringstream words(host.ids);
  for (std::string word; words >> word;)
    for (const System& system : kSystems)
      if (word == system.id || (system.id == "suse" && word.starts_with("opensuse"))) return &system;
  return nullptr;
}

std::string inPath(const std::string& program) {
  std::istringstream folders(environmentVariable("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const std::string file = folder + "/" + program; access(file.c_str(), X_OK) == 0) return file;
  return "";
}

/// The command that installs these packages, or whom to ask.
std::string installing(const System& system, const std::string& packages, const Host& host) {
  if (host.isRoot) return std::string(system.install) + " " + packages;
  if (host.hasSudo) return std::string("sudo ") + system.install + " " + packages;
  return "ask an administrator to install " + packages;
}

/// What apt does with the package gluray, or `request`, for those who cannot run it.
std::string aptCommand(const std::string& action, const char* request, const Host& host) {
  const std::string command = "apt " + action + " gluray";
  if (host.isRoot) return command;
  return host.hasSudo ? "sudo " + command : request;
}

/// Debian policy 8.1: the name without ".so", a dash if it ends in a digit, then the version.
std::optional<std::string> debianPackage(const std::string& name) {
  const size_t so = name.find(".so.");
  if (so == name.npos) return std::nullopt;
  std::string package = name.substr(0, so);
  std::transform(package.begin(), package.end(), package.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  std::replace(package.begin(), package.end(), '_', '-');
  if (std::isdigit(static_cast<unsigned char>(package.back()))) package += "-";
  return package + name.substr(so + 4);
}

bool isThere(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

/// PREFIX of PREFIX/lib/gluray.
fs::path prefixOf(const std::string& libraryDirectory) {
  return fs::path(libraryDirectory).parent_path().parent_path();
}

bool isInWheel(const fs::path& prefix) {
  std::error_code error;
  for (const char* lib : {"lib", "lib64"})
    for (fs::directory_iterator python(prefix / lib, error), end; !error && python != end;
         python.increment(error))
      if (python->path().filename().string().starts_with("python"))
        for (const char* packages : {"site-packages", "dist-packages"}) {
          std::error_code ignored;
          for (fs::directory_iterator one(python->path() / packages, ignored);
               !ignored && one != fs::directory_iterator(); one.increment(ignored))
            if (const std::string name = one->path().filename();
                name.starts_with("gluray-") && name.ends_with(".dist-info"))
              return true;
        }
  return false;
}

}  // namespace

Host thisHost() {
  Host host;
  std::ifstream file("/etc/os-release");
  for (std::string line; std::getline(file, line);)
    for (const char* key : {"ID=", "ID_LIKE="})
      if (line.starts_with(key)) {
        std::string value = line.substr(std::string_view(key).size());
        std::erase(value, '"');
        host.ids += (host.ids.empty() ? "" : " ") + value;
      }
  host.isRoot = geteuid() == 0;
  host.hasSudo = !inPath("sudo").empty();
  const System* const system = systemOf(host);
  host.hasManager = system && !inPath(system->program).empty();
  return host;
}

std::string adviceForLibrary(const std::string& name, const Host& host) {
  const System* const system = systemOf(host);
  if (!system || !host.hasManager) return "install the package that has " + name;
  const std::string capability = "'" + name + "()(64bit)'";
  switch (system->manager) {
    case Manager::apt: {
      const auto package = debianPackage(name);
      return package ? installing(*system, *package, host) : "apt-file search " + name;
    }
    case Manager::dnf:
    case Manager::zypper: return installing(*system, capability, host);
    case Manager::pacman: return "pacman -F " + name + " names the package that has it";
  }
  return "";
}

std::string adviceForOpenGl(const std::string& api, const Host& host) {
  const System* const system = systemOf(host);
  if (!system || !host.hasManager)
    return api == "glx" ? "install Mesa's or a graphics card's OpenGL for X (libGL.so.1 of libglvnd)"
                        : "install Mesa's or a graphics card's EGL (libEGL.so.1 of libglvnd)";
  return installing(*system, api == "glx" ? system->glx : system->egl, host);
}

Installed howInstalled(const std::string& libraryDirectory) {
  const fs::path prefix = prefixOf(libraryDirectory);
  if (isThere(prefix / "CMakeCache.txt")) return Installed::build;
  if (isInWheel(prefix)) return Installed::wheel;
  if (prefix == "/usr" && isThere("/var/lib/dpkg/info/gluray.list")) return Installed::package;
  if (isThere(fs::path(libraryDirectory) / "private/libgluray-substitutes.so")) return Installed::archive;
  return Installed::other;
}

std::string described(Installed how, const std::string& libraryDirectory) {
  const std::string prefix = prefixOf(libraryDirectory);
  switch (how) {
    case Installed::archive: return "the archive in " + prefix;
    case Installed::wheel: return "the Python wheel in " + prefix;
    case Installed::package: return "Debian's package";
    case Installed::build: return "the build folder " + prefix;
    case Installed::other: break;
  }
  return "in " + libraryDirectory;
}

std::string adviceToRemove(Installed how, const std::string& libraryDirectory, const Host& host) {
  switch (how) {
    case Installed::archive: return "rm -r '" + prefixOf(libraryDirectory).string() + "'";
    case Installed::wheel: return "pip uninstall gluray";
    case Installed::package:
      return aptCommand("purge", "ask an administrator to remove the package gluray", host);
    case Installed::build: return "remove the checkout";
    case Installed::other: break;
  }
  return "remove bin/gluray*, lib/gluray and share/doc/gluray below its prefix";
}

std::string adviceToReinstall(Installed how, const Host& host) {
  switch (how) {
    case Installed::archive: return "unpack the archive again";
    case Installed::wheel: return "pip install --force-reinstall --no-deps gluray";
    case Installed::package:
      return aptCommand("install --reinstall", "ask an administrator to install the package gluray again",
                        host);
    case Installed::build: return "scripts/build";
    case Installed::other: break;
  }
  return "install GLuRay again: cmake --install BUILD --prefix DIR";
}

}  // namespace gluray::launcher
