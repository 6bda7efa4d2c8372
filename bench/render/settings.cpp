#include "bench/render/settings.h"

#include "settings/values.h"

#include <stdexcept>

namespace gluray::bench {

void set(Settings& settings, const std::string& assignment) {
  const size_t equals = assignment.find('=');
  const Row* row = findSetting(assignment.substr(0, equals));
  if (!row || equals == std::string::npos) throw std::runtime_error(unknownSetting(assignment));
  Session session;
  session.settings = settings;
  const std::string wrong = readValue(*row, assignment.substr(equals + 1), session);
  if (!wrong.empty()) throw std::runtime_error(assignment + ": " + wrong);
  settings = session.settings;
}

}  // namespace gluray::bench
