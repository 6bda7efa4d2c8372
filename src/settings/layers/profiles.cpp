#include "settings/layers/profiles.h"

#include "settings/built_in_profiles.gen.h"

#include <toml++/toml.h>

#include <string>

namespace gluray {

std::vector<FileSetting> shippedProfile(std::string_view program) {
  const Section section{Section::Kind::program, std::string(program)};
  // Most programs have no profile: in that case nothing is parsed.
  if (std::string_view(kBuiltInProfiles).find("[program." + section.name + "]\n") == std::string_view::npos)
    return {};
  try {
    std::vector<FileSetting> settings = shippedProfiles();
    std::erase_if(settings,
                  [&](const FileSetting& s) { return !(s.section == section) || !s.wrong.empty(); });
    return settings;
  } catch (const toml::parse_error&) { return {}; }  // a test would fail
}

std::vector<FileSetting> shippedProfiles() { return readConfigText(kBuiltInProfiles); }

}  // namespace gluray
