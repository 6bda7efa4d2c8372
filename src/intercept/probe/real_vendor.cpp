#include "intercept/probe/real_vendor.h"

#include "base/environment_variable.h"

#include <dlfcn.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace gluray::probe {
namespace {

constexpr int kPatienceMs = 2000;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

bool loads(const std::string& library) { return dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL) != nullptr; }

/// The library that a vendor's JSON file names; empty if the file cannot be read.
std::string libraryOf(const std::string& file) {
  std::ifstream stream(file);
  const auto parsed = nlohmann::json::parse(stream, nullptr, /*allow_exceptions=*/false);
  const nlohmann::json::json_pointer where("/ICD/library_path");
  return parsed.is_object() && parsed.contains(where) && parsed[where].is_string()
             ? parsed[where].get<std::string>()
             : "";
}

/// The X server's vendor names for its first screen (GLX_EXT_libglvnd), for instance "mesa". Loads the C
/// binding of the GLX protocol with dlopen, so that it needs no header and loads no OpenGL library.
std::string vendorsOfDisplay() {
  constexpr unsigned kVendorNames = 0x20F6;  // GLX_VENDOR_NAMES_EXT
  struct Cookie {
    unsigned sequence;
  };
  void* xcb = dlopen("libxcb.so.1", RTLD_NOW);
  void* glx = dlopen("libxcb-glx.so.0", RTLD_NOW);
  if (!xcb || !glx || environmentVariable("DISPLAY").empty()) return "";
  const auto connect = reinterpret_cast<void* (*)(const char*, int*)>(dlsym(xcb, "xcb_connect"));
  const auto hasError = reinterpret_cast<int (*)(void*)>(dlsym(xcb, "xcb_connection_has_error"));
  const auto query =
      reinterpret_cast<Cookie (*)(void*, unsigned, unsigned)>(dlsym(glx, "xcb_glx_query_server_string"));
  const auto reply =
      reinterpret_cast<void* (*)(void*, Cookie, void**)>(dlsym(glx, "xcb_glx_query_server_string_reply"));
  const auto text =
      reinterpret_cast<const char* (*)(const void*)>(dlsym(glx, "xcb_glx_query_server_string_string"));
  const auto length =
      reinterpret_cast<int (*)(const void*)>(dlsym(glx, "xcb_glx_query_server_string_string_length"));
  if (!connect || !hasError || !query || !reply || !text || !length) return "";
  int screen = 0;
  void* connection = connect(nullptr, &screen);
  if (hasError(connection)) return "";
  void* error = nullptr;
  const void* answer =
      reply(connection, query(connection, static_cast<unsigned>(screen), kVendorNames), &error);
  if (!answer) return "";
  const std::string names(text(answer), static_cast<size_t>(std::max(0, length(answer))));
  return names.substr(0, names.find('\0'));
}

std::string findGlx() {
  std::string chosen = environmentVariable("__GLX_VENDOR_LIBRARY_NAME");
  if (chosen == "gluray") chosen = environmentVariable("GLURAY_REAL_GLX");
  std::vector<std::string> names = chosen.empty() ? split(vendorsOfDisplay(), ' ') : std::vector{chosen};
  names.push_back("mesa");
  for (const std::string& name : names)
    if (loads(name.find(".so") == std::string::npos ? "libGLX_" + name + ".so.0" : name)) return name;
  return "";
}

/// The EGL driver of the GLX driver's vendor if there is one, otherwise the first that can be loaded.
std::string findEgl(const std::string& glx) {
  std::string files = environmentVariable("__EGL_VENDOR_LIBRARY_FILENAMES");
  if (files.find("gluray_egl.json") != std::string::npos) return environmentVariable("GLURAY_REAL_EGL");
  std::vector<std::string> libraries =
      split(eglVendorLibraries(files, environmentVariable("__EGL_VENDOR_LIBRARY_DIRS")), ':');
  std::stable_partition(libraries.begin(), libraries.end(), [&](const std::string& library) {
    return !glx.empty() && library.find("_" + glx + ".") != std::string::npos;
  });
  const auto found = std::find_if(libraries.begin(), libraries.end(), loads);
  return found == libraries.end() ? "" : *found;
}

/// Writes the child process's result into `pipe`: two lines.
void answer(int pipe) {
  const std::string glx = findGlx();
  const std::string lines = glx + "\n" + findEgl(glx) + "\n";
  const ssize_t written = write(pipe, lines.data(), lines.size());
  _exit(written == static_cast<ssize_t>(lines.size()) ? 0 : 1);
}

std::string readUntilClosed(int pipe) {
  std::string text;
  char buffer[512];
  pollfd waiting{pipe, POLLIN, 0};
  while (poll(&waiting, 1, kPatienceMs) > 0) {
    const ssize_t bytes = read(pipe, buffer, sizeof buffer);
    if (bytes <= 0) break;
    text.append(buffer, static_cast<size_t>(bytes));
  }
  return text;
}

}  // namespace

std::vector<std::string> eglVendorFiles(const std::string& fileNames, const std::string& directories) {
  std::vector<std::string> files = split(fileNames, ':');
  std::erase_if(files, [](const std::string& file) { return file.ends_with("/gluray_egl.json"); });
  if (!files.empty()) return files;
  const std::string places =
      directories.empty() ? "/etc/glvnd/egl_vendor.d:/usr/share/glvnd/egl_vendor.d" : directories;
  for (const std::string& directory : split(places, ':')) {
    std::vector<std::string> here;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(directory, error), end; !error && entry != end;
         entry.increment(error))
      if (entry->path().extension() == ".json") here.push_back(entry->path());
    std::sort(here.begin(), here.end());
    files.insert(files.end(), here.begin(), here.end());
  }
  return files;
}

std::string eglVendorLibraries(const std::string& fileNames, const std::string& directories) {
  std::string libraries;
  for (const std::string& file : eglVendorFiles(fileNames, directories))
    if (const std::string library = libraryOf(file); !library.empty())
      libraries += (libraries.empty() ? "" : ":") + library;
  return libraries;
}

RealVendors findRealVendors() {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) answer(ends[1]);
  close(ends[1]);
  const std::string lines = child > 0 ? readUntilClosed(ends[0]) : "";
  close(ends[0]);
  if (child > 0) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
  const auto parts = [&] {
    std::vector<std::string> result(2);
    std::istringstream stream(lines);
    for (std::string& line : result) std::getline(stream, line);
    return result;
  }();
  // The X server does not answer, and the program will also wait for it. Mesa is the most likely driver.
  if (lines.empty()) return {"mesa", "libEGL_mesa.so.0"};
  return {parts[0], parts[1]};
}

}  // namespace gluray::probe
