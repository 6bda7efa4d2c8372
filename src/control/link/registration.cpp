#include "control/link/registration.h"

#include "base/files.h"
#include "control/messages/message.h"
#include "control/runtime_directory.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace gluray::control {

std::string registrationFile(const std::string& directory) {
  return directory + "/programs/" + std::to_string(getpid());
}

std::string leaveRegistration(const std::string& directory, const Registration& registration) {
  std::string why = makeRuntimeDirectory(directory);
  if (why.empty()) why = makeRuntimeDirectory(directory + "/programs");
  if (!why.empty()) return why;
  return files::replace(registrationFile(directory), lineOf({{"pid", getpid()},
                                                             {"name", registration.name},
                                                             {"display", registration.display},
                                                             {"window", registration.window}}));
}

}  // namespace gluray::control
