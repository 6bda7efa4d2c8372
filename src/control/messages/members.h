// Reads members of untrusted messages. Any thread.
#pragma once
#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace gluray::control {

inline constexpr size_t kMaxCharacters = 64;  // of an id, a gesture, the name of a call
inline constexpr int kMaxRanks = 1 << 20;     // of an MPI job
// The largest integer that every JSON reader preserves.
inline constexpr int64_t kMaxFrame = int64_t{1} << 53;

/// The member of an object; null if it is missing, or `object` is not an object.
const nlohmann::json* member(const nlohmann::json& object, const char* name);

/// An integer from `least` to `most`; nullopt otherwise, also for 1.0 and true.
std::optional<int64_t> wholeNumber(const nlohmann::json* value, int64_t least, int64_t most);

/// Whether the value is a text of at most `characters` Unicode characters.
bool isText(const nlohmann::json* value, size_t characters = kMaxCharacters);

/// Whether the value is the boolean true.
bool isTrue(const nlohmann::json* value);

/// Whether an answer can repeat the value as an id: a number, or a text of at most kMaxCharacters characters.
bool isId(const nlohmann::json* value);

/// The text of a member, or `otherwise` if it is missing. Nullopt if it is not a text or is too long.
std::optional<std::string> textMember(const nlohmann::json& object, const char* name, size_t characters,
                                      const char* otherwise = nullptr);

/// The text of a member; empty if it is missing.
std::string textIn(const nlohmann::json& object, const char* name);

/// The number of a member; `otherwise` if it is missing.
template <class Number>
Number numberIn(const nlohmann::json& object, const char* name, Number otherwise) {
  const nlohmann::json* const value = member(object, name);
  return value && value->is_number() ? value->get<Number>() : otherwise;
}

}  // namespace gluray::control
