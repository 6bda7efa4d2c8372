// Reads members of untrusted messages. Any thread.
#pragma once
#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace gluray::control {

inline constexpr size_t kMaxCharacters = 64;  // of an id, a gesture, a name of a call
inline constexpr int kMaxRanks = 1 << 20;     // of an MPI job
// The largest whole number that every JSON reader keeps.
inline constexpr int64_t kMaxFrame = int64_t{1} << 53;

/// The member of an object; null where there is none, or `object` is none.
const nlohmann::json* member(const nlohmann::json& object, const char* name);

/// A whole number from `least` to `most`; 1.0 and true are none.
std::optional<int64_t> wholeNumber(const nlohmann::json* value, int64_t least, int64_t most);

/// A text of at most `characters` Unicode characters.
bool isText(const nlohmann::json* value, size_t characters = kMaxCharacters);

/// Whether it is the boolean true.
bool isTrue(const nlohmann::json* value);

/// Whether an answer can repeat it: a number or a text of at most kMaxCharacters.
bool isId(const nlohmann::json* value);

/// The text of a member, `otherwise` where there is none; nothing where it is no text, or a longer one.
std::optional<std::string> textMember(const nlohmann::json& object, const char* name, size_t characters,
                                      const char* otherwise = nullptr);

/// The text of a member; empty where there is none.
std::string textIn(const nlohmann::json& object, const char* name);

/// The number of a member; `otherwise` where there is none.
template <class Number>
Number numberIn(const nlohmann::json& object, const char* name, Number otherwise) {
  const nlohmann::json* const value = member(object, name);
  return value && value->is_number() ? value->get<Number>() : otherwise;
}

}  // namespace gluray::control
