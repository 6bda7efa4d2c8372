#include "say.h"

#include "base/files.h"
#include "base/guarded_write.h"
#include "base/printable.h"
#include "control/link/said_once.h"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace gluray::launcher {

void say(const std::string& text) {
  constexpr int kPatienceMs = 100;
  std::string said = text;
  if (!control::saysLineHere(said)) return;
  const std::string line = "gluray: " + printable(said) + "\n";
  const GlurayOutput out = glurayOutputOf(STDERR_FILENO);
  int error = 0;
  glurayWrite(&out, line.data(), line.size(), kPatienceMs, &error);
}

std::string jsonText(const nlohmann::json& value) {
  return value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

void writeFile(const std::string& path, const std::string& text) {
  if (const std::string why = files::replace(path, text); !why.empty())
    throw std::runtime_error("cannot write " + path + ": " + why);
}

}  // namespace gluray::launcher
