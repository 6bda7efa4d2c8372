#include "say.h"

#include "base/files.h"
#include "base/printable.h"

#include <nlohmann/json.hpp>

#include <iostream>
#include <stdexcept>

namespace gluray::launcher {

void say(const std::string& text) { std::cerr << "gluray: " << printable(text) << "\n"; }

std::string jsonText(const nlohmann::json& value) {
  return value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

void writeFile(const std::string& path, const std::string& text) {
  if (const std::string why = files::replace(path, text); !why.empty())
    throw std::runtime_error("cannot write " + path + ": " + why);
}

}  // namespace gluray::launcher
