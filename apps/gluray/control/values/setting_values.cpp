#include "control/values/setting_values.h"

#include "base/printable.h"
#include "control/messages/members.h"
#include "control/messages/value.h"
#include "settings/chosen_settings.h"
#include "settings/values.h"

#include <nlohmann/json.hpp>

namespace gluray::launcher {
using nlohmann::json;

json sentValue(const std::string& name, const std::string& text) {
  const Row& row = *findSetting(name);
  if (row.type == Type::quirks) return text;  // only those that it names change
  Session session;
  readValue(row, row.files ? absoluteFiles(row, text) : text, session);
  return control::valueOf(row, printValue(row, session));
}

std::string valueText(const std::string& name, const json& value) {
  const Row* row = findSetting(name);
  std::string text;
  if (row)
    text = control::textOf(*row, value).text;
  else if (value.is_string())
    text = value.get<std::string>();
  else if (!value.is_null())
    text = value.dump();
  return text.empty() ? "-" : printable(text);
}

std::string originText(const json& described) {
  const std::string layer = control::textIn(described, "layer"), place = control::textIn(described, "place");
  return printable(layer.empty() ? "-" : layer) +
         (place.empty() || place == layer ? "" : ": " + printable(place));
}

std::string valuesText(const json& values) {
  std::string text;
  if (!values.is_object()) return text;
  for (const auto& [name, value] : values.items())
    text += (text.empty() ? "" : ", ") + printable(name) + " = " + valueText(name, value);
  return text;
}

}  // namespace gluray::launcher
