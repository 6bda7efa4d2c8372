#include "settings/object_rule.h"

#include "settings/nearest.h"
#include "settings/values.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <vector>

namespace gluray {
namespace {

constexpr uint8_t kAllRays = (1u << std::size(kRayWords)) - 1;

std::string_view nextWord(std::string_view& text) {
  const size_t begin = std::min(text.find_first_not_of(' '), text.size());
  text.remove_prefix(begin);
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

std::string quoted(std::string_view text) { return std::string("'").append(text.substr(0, 40)).append("'"); }

/// Parses "camera+shadow", "all" or "none".
std::string readRays(std::string_view text, uint8_t& bits) {
  bits = text == "all" ? kAllRays : 0;
  if (text == "all" || text == "none") return "";
  while (true) {
    const std::string_view word = text.substr(0, text.find('+'));
    const auto* const found = std::find(std::begin(kRayWords), std::end(kRayWords), word);
    if (found == std::end(kRayWords))
      return "hidden-from=" + std::string(word.substr(0, 40)) +
             ": use all, none, or some of camera, shadow, occlusion and reflection with + between them";
    bits = static_cast<uint8_t>(bits | 1u << (found - std::begin(kRayWords)));
    if (word.size() == text.size()) return "";
    text.remove_prefix(word.size() + 1);
  }
}

std::string unknownKey(std::string_view key) {
  std::vector<std::string_view> keys{"hidden-from"};
  for (const Row& row : settingRows())
    if (row.name.starts_with("material.") && row.applies == Applies::frame && row.type != Type::path &&
        row.type != Type::list)
      keys.push_back(row.name.substr(std::string_view("material.").size()));
  const std::string_view near = nearest(key, keys);
  std::string text = "objects have no " + quoted(key);
  return near.empty() ? text : text.append("; did you mean ").append(quoted(near)).append("?");
}

std::string readField(std::string_view key, std::string_view value, Session& session) {
  const Row* const row = findSetting("material." + std::string(key));
  if (!row || row->type == Type::path || row->type == Type::list) return unknownKey(key);
  const std::string why = readValue(*row, value, session);
  return why.empty() ? "" : std::string(key) + "=" + std::string(value.substr(0, 40)) + ": " + why;
}

}  // namespace

uint32_t objectOf(std::string_view entry) noexcept {
  const std::string_view word = nextWord(entry);
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size() ? number : 0;
}

std::string readObjectRule(std::string_view entry, const Settings::Material& otherwise, ObjectRule& rule) {
  rule = {};
  rule.object = objectOf(entry);
  if (rule.object == 0) return quoted(entry) + ": an entry begins with the number of an object, from 1";
  nextWord(entry);
  Session session;
  session.settings.material = otherwise;
  for (std::string_view word = nextWord(entry); !word.empty(); word = nextWord(entry)) {
    const size_t equals = word.find('=');
    const std::string_view key = word.substr(0, equals);
    std::string why;
    if (equals == word.npos) {
      why = readValue(*findSetting("material"), word, session);
      if (!why.empty()) why = quoted(word) + ": " + why;
    } else if (key == "hidden-from") {
      uint8_t bits = 0;
      why = readRays(word.substr(equals + 1), bits);
      rule.hiddenFrom = bits;
    } else {
      why = readField(key, word.substr(equals + 1), session);
    }
    if (!why.empty()) return "object " + std::to_string(rule.object) + ": " + why;
    rule.looks |= key != "hidden-from";
  }
  rule.material = session.settings.material;
  return "";
}

std::string checkObjectRule(std::string_view entry) {
  ObjectRule rule;
  return readObjectRule(entry, Settings::Material(), rule);
}

}  // namespace gluray
