#include "control/link/registration.h"

#include "base/files.h"
#include "control/process_start.h"
#include "control/runtime_directory.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace gluray::control {
namespace {

/// Objects of this library must not be destroyed on a thread of the program: their destructor allocates, and
/// ends the program if memory runs out. Texts are safe.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

std::string registrationFile(const std::string& directory) {
  return directory + "/programs/" + std::to_string(getpid());
}

std::string leaveRegistration(const std::string& directory, const Registration& registration) {
  std::string why = makeRuntimeDirectory(directory);
  if (why.empty()) why = makeRuntimeDirectory(directory + "/programs");
  if (!why.empty()) return why;
  const std::string line = "{\"pid\": " + std::to_string(getpid()) +
                           ", \"name\": " + quoted(registration.name) +
                           ", \"display\": " + quoted(registration.display) +
                           ", \"window\": " + std::to_string(registration.window) +
                           ", \"since\": " + std::to_string(statOf(getpid()).started) + "}\n";
  return files::replace(registrationFile(directory), line);
}

}  // namespace gluray::control
