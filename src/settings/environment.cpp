#include "settings/config_file.h"
#include "settings/keys.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace gluray {
namespace {

/// "log-level" -> "GLURAY_LOG_LEVEL".
std::string variableOf(std::string_view key) {
  std::string name = "GLURAY_";
  for (const char c : key)
    name += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

}  // namespace

Session sessionFromEnvironment(void (*complain)(const std::string& line)) {
  Session session;
  const char* named = std::getenv("GLURAY_CONFIG");
  readConfigFile(configFile(), named && *named, session, complain);
  for (const std::string_view key : settingKeys()) {
    const std::string name = variableOf(key);
    const char* value = std::getenv(name.c_str());
    if (!value || !*value) continue;
    if (const std::string why = setSetting(session, key, value); !why.empty())
      complain(name + "=" + value + ": " + why);
  }
  return session;
}

}  // namespace gluray
