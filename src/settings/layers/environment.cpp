#include "base/processes/usable_cores.h"
#include "settings/layers/settings_layers.h"

#include <string>

namespace gluray {

namespace {

/// 0: as many as the process may use.
int threadsWithout(const Surroundings& here) {
  const ThreadCount chosen = chosenThreads(0, here);
  return chosen.isLimit ? 0 : chosen.threads;
}

}  // namespace

int threadsOfRank(int cores, int allowed, int ranks) {
  Surroundings here;
  here.root = "/dev/null";  // no quota
  here.variable = [](const char*) { return std::string(); };
  here.hostCores = cores, here.affinity = allowed, here.ranksHere = ranks;
  return threadsWithout(here);
}

int threadsOfThisRank() { return threadsWithout(surroundingsOfThisProcess()); }

Session sessionFromEnvironment(const Complain& complain) {
  Session session = readLayers(sourcesOfProcess(), complain).session;
  if (session.settings.threads == 0) session.settings.threads = threadsOfThisRank();
  return session;
}

}  // namespace gluray
