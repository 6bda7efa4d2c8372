#include "control/messages/value.h"

#include "settings/values.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>

namespace gluray::control {
namespace {

using nlohmann::json;

constexpr std::string_view kTypes[] = {"boolean", "integer", "real", "choice", "color",
                                       "vector",  "text",    "path", "list",   "quirks"};
constexpr std::string_view kApplies[] = {"frame", "context", "process"};

bool holdsNumbers(const Row& row) { return row.type == Type::vector || row.type == Type::color; }

json numberOf(std::string_view text) {
  const json number = json::parse(text, nullptr, false);
  return number.is_number() ? number : json(text);
}

json listOf(const Row& row, std::string_view text) {
  json list = json::array();
  const char separator = holdsNumbers(row) ? ',' : separatorOf(row);
  while (!text.empty()) {
    const size_t end = std::min(text.find(separator), text.size());
    list.push_back(holdsNumbers(row) ? numberOf(text.substr(0, end)) : json(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return list;
}

std::string scalarText(const json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_string()) return value.get<std::string>();
  return value.is_number() ? value.dump() : "";
}

/// A layer's value, converted to the setting's type.
json typedValue(const Row& row, const std::string& text) {
  Session session;
  const bool partly = row.type == Type::quirks;  // a layer names only some quirks
  return !partly && readValue(row, text, session).empty() ? valueOf(row, printValue(row, session))
                                                          : json(text);
}

}  // namespace

json valueOf(const Row& row, const std::string& text) {
  switch (row.type) {
    case Type::boolean: return text == "true";
    case Type::integer:
    case Type::real: return numberOf(text);
    case Type::color: return text.starts_with('#') ? json(text) : listOf(row, text);
    case Type::vector:
    case Type::list: return listOf(row, text);
    default: return text;
  }
}

TextOrWhy textOf(const Row& row, const json& value) {
  const auto wrong = [&] {
    return TextOrWhy{"", std::string(row.name) + ": use a boolean, a number, a string or a list of these"};
  };
  if (!value.is_array())
    return value.is_null() || value.is_object() ? wrong() : TextOrWhy{scalarText(value), ""};
  std::string text;
  for (const json& entry : value) {
    if (entry.is_structured() || entry.is_null()) return wrong();
    if (!text.empty()) text += holdsNumbers(row) ? ',' : separatorOf(row);
    text += scalarText(entry);
  }
  return {text, ""};
}

json layersOf(const Layers& layers, const Row& row) {
  json list = json::array();
  for (size_t i = 0; i < kLayerCount; ++i) {
    const auto layer = static_cast<Layer>(i);
    bool any = layer == Layer::builtIn;
    if (any)
      list.push_back(
          {{"layer", nameOf(layer)}, {"value", valueOf(row, printValue(row, Session{}))}, {"place", ""}});
    for (const Given& g : layers.given)
      if (g.row == &row && g.layer == layer) {
        any = true;
        list.push_back({{"layer", nameOf(layer)}, {"value", typedValue(row, g.value)}, {"place", g.place}});
      }
    if (!any) list.push_back({{"layer", nameOf(layer)}, {"value", nullptr}, {"place", ""}});
  }
  return list;
}

json description(const Row& row) {
  json words = json::array();
  for (const Word& word : row.words) words.push_back({{"word", word.word}, {"help", word.help}});
  return {{"name", row.name},
          {"title", row.title},
          {"type", kTypes[static_cast<size_t>(row.type)]},
          {"default", valueOf(row, printValue(row, Session{}))},
          {"least", row.ranged ? json(row.least) : json()},
          {"most", row.ranged ? json(row.most) : json()},
          {"leastMeans", row.leastMeans},
          {"words", words},
          {"unit", row.unit},
          {"help", row.help},
          {"more", row.more},
          {"group", row.group},
          {"level", nameOf(row.level)},
          {"values", allowedValues(row)},
          {"applies", kApplies[static_cast<size_t>(row.applies)]},
          {"changesPicture", row.changes == Changes::image}};
}

}  // namespace gluray::control
