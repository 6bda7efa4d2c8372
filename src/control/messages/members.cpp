#include "control/messages/members.h"

#include <algorithm>
#include <limits>

namespace gluray::control {
namespace {

using nlohmann::json;

/// Number of characters in a UTF-8 text.
size_t charactersIn(const std::string& text) {
  return static_cast<size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u;  // not a continuation byte
  }));
}

}  // namespace

const json* member(const json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

std::optional<int64_t> wholeNumber(const json* value, int64_t least, int64_t most) {
  if (!value || !value->is_number_integer()) return std::nullopt;
  if (value->is_number_unsigned() &&
      value->get<uint64_t>() > static_cast<uint64_t>(std::numeric_limits<int64_t>::max()))
    return std::nullopt;
  const auto number = value->get<int64_t>();
  if (number < least || number > most) return std::nullopt;
  return number;
}

bool isText(const json* value, size_t characters) {
  return value && value->is_string() && charactersIn(value->get_ref<const std::string&>()) <= characters;
}

bool isTrue(const json* value) { return value && value->is_boolean() && value->get<bool>(); }

bool isId(const json* value) { return value && (value->is_number() || isText(value)); }

std::optional<std::string> textMember(const json& object, const char* name, size_t characters,
                                      const char* otherwise) {
  const json* value = member(object, name);
  if (!value) return otherwise ? std::optional<std::string>(otherwise) : std::nullopt;
  if (!isText(value, characters)) return std::nullopt;
  return value->get<std::string>();
}

std::string textIn(const json& object, const char* name) {
  const json* const value = member(object, name);
  return value && value->is_string() ? value->get<std::string>() : "";
}

}  // namespace gluray::control
