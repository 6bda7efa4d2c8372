#include "saved/shot/picture_settings.h"

#include "settings/values.h"

#include <algorithm>
#include <stdexcept>

namespace gluray::saved {

std::function<Settings(const Settings&)> withValues(std::vector<std::string> values) {
  if (values.empty()) return {};
  return [values = std::move(values)](const Settings& settings) {
    Session session;
    session.settings = settings;
    for (const std::string& text : values) {
      const size_t equals = text.find('=');
      const std::string name = text.substr(0, equals);
      const Row* const row = findSetting(name);
      if (!row) throw std::runtime_error(unknownSetting(name));
      const std::string why = readValue(*row, equals == text.npos ? "" : text.substr(equals + 1), session);
      if (!why.empty()) throw std::runtime_error(name + ": " + why);
    }
    return session.settings;
  };
}

int edgeSamplesFor(const std::vector<std::string>& values) {
  constexpr int kEdgeSamples = 4;
  const bool chosen = std::any_of(values.begin(), values.end(),
                                  [](const std::string& text) { return text.starts_with("spp="); });
  return chosen ? 1 : kEdgeSamples;
}

}  // namespace gluray::saved
