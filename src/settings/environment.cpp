#include "settings/config_file.h"
#include "settings/keys.h"

#include <sched.h>
#include <unistd.h>

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

/// MPI processes on this host, as their launchers tell (Open MPI, MPICH and its kin, MVAPICH); 1 without MPI.
int localRanks() {
  for (const char* name : {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", "MV2_COMM_WORLD_LOCAL_SIZE"})
    if (const char* value = std::getenv(name)) return std::max(std::atoi(value), 1);
  return 1;
}

int coresAllowed() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

}  // namespace

int threadsOfRank(int cores, int allowed, int ranks) {
  // A launcher that binds ranks to cores has shared them out already.
  if (ranks <= 1 || allowed < cores) return 0;
  return std::max(1, cores / ranks);
}

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
  if (session.settings.threads == 0)
    session.settings.threads =
        threadsOfRank(static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN)), coresAllowed(), localRanks());
  return session;
}

}  // namespace gluray
