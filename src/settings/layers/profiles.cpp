#include "settings/layers/profiles.h"

#include "settings/built_in_profiles.gen.h"

#include <toml++/toml.h>

#include <string>

namespace gluray {

std::vector<FileSetting> shippedProfile(std::string_view program) {
  const Section section{Section::Kind::program, std::string(program)};
  // Most programs have no profile: nothing is parsed for them.
  if (std::string_view(kBuiltInProfiles).find("[program." + section.name + "]\n") == std::string_view::npos)
    return {};
  try {
    std::vector<FileSetting> settings = shippedProfiles();
    std::erase_if(settings,
                  [&](const FileSetting& s) { return !(s.section == section) || !s.wrong.empty(); });
    return settings;
  } catch (const toml::parse_error&) { return {}; }  // which a test would show
}

std::vector<FileSetting> shippedProfiles() { return readConfigText(kBuiltInProfiles); }

}  // namespace gluray
