#include "settings/values.h"

#include "settings/value_text.h"

#include <type_traits>
#include <variant>

namespace gluray {
namespace {

/// The place of a setting in a session, for reading only.
Place placeOf(const Row& row, const Session& session) { return row.place(const_cast<Session&>(session)); }

}  // namespace

std::string readValue(const Row& row, std::string_view text, Session& session) {
  return std::visit([&](auto* value) { return readText(row, text, *value); }, row.place(session));
}

std::string printValue(const Row& row, const Session& session) {
  return std::visit([&](const auto* value) { return printText(row, *value); }, placeOf(row, session));
}

bool sameValue(const Row& row, const Session& a, const Session& b) {
  return std::visit([&](auto* value) { return *value == *std::get<decltype(value)>(placeOf(row, b)); },
                    placeOf(row, a));
}

void keepBetweenFrames(Settings& next, const Settings& old) {
  Session from, to;
  from.settings = old, to.settings = next;
  for (const Row& row : settingRows()) {
    if (row.applies != Applies::context) continue;
    std::visit([&](auto* value) { *value = *std::get<decltype(value)>(row.place(from)); }, row.place(to));
  }
  next = to.settings;
}

}  // namespace gluray
