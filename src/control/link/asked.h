// Members of requests, checked: nobody trusts who sends them. Any thread.
#pragma once
#include "control/messages/members.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace gluray::control {

class Asked {
 public:
  static constexpr size_t kMostOfName = 256;  // bytes of an id, a name, a gesture

  explicit Asked(const nlohmann::json& message) : message_(message) {}

  /// The member; null: there is none.
  const nlohmann::json* at(const char* name) const { return member(message_, name); }
  /// A text; none: it is missing, longer than kMostOfName, or something else.
  std::optional<std::string> text(const char* name) const {
    const nlohmann::json* const value = at(name);
    if (!value || !value->is_string()) return std::nullopt;
    auto found = value->get<std::string>();
    return found.size() <= kMostOfName ? std::optional(std::move(found)) : std::nullopt;
  }
  /// A whole number from 0 to kMostFrame.
  std::optional<uint64_t> number(const char* name) const {
    const auto found = wholeNumber(at(name), 0, kMostFrame);
    return found ? std::optional(static_cast<uint64_t>(*found)) : std::nullopt;
  }
  bool isTrue(const char* name) const {
    const nlohmann::json* const value = at(name);
    return value && value->is_boolean() && value->get<bool>();
  }
  /// The id that the answer repeats; null: it has none, or no valid one.
  const nlohmann::json* id(const char* name = "id") const {
    const nlohmann::json* const value = at(name);
    return value && (value->is_number() || text(name)) ? value : nullptr;
  }

 private:
  const nlohmann::json& message_;
};

}  // namespace gluray::control
