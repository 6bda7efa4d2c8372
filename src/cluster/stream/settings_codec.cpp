#include "cluster/stream/settings_codec.h"

#include "settings/values.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>

namespace gluray::cluster {
namespace {

/// Whether the setting is one of Settings, not of Session alone.
bool isOfSnapshots(const Row& row) {
  static Session session;
  const auto* const begin = reinterpret_cast<const std::byte*>(&session.settings);
  return std::visit(
      [&](const auto* place) {
        const auto* const at = reinterpret_cast<const std::byte*>(place);
        return std::less_equal<>()(begin, at) && std::less<>()(at, begin + sizeof(Settings));
      },
      row.place(session));
}

void put(ByteWriter& out, std::string_view text) {
  out.put(static_cast<uint64_t>(text.size()));
  out.put(text.data(), text.size());
}

std::string getText(ByteReader& in) {
  const auto bytes = in.readBytes(in.count(1));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

void writeSettings(ByteWriter& out, const Settings& settings) {
  static const Session defaults;
  Session session;
  session.settings = settings;
  for (const Row& row : settingRows()) {
    if (!isOfSnapshots(row) || sameValue(row, session, defaults)) continue;
    put(out, row.name), put(out, printValue(row, session));
  }
  put(out, "");
}

Settings readSettings(ByteReader& in) {
  Session session;
  for (std::string name = getText(in); !name.empty(); name = getText(in)) {
    const Row* const row = findSetting(name);
    if (!row || !isOfSnapshots(*row)) throw Malformed("no setting is called " + name);
    const std::string why = readValue(*row, getText(in), session);
    if (!why.empty()) throw Malformed(name + ": " + why);
  }
  return session.settings;
}

}  // namespace gluray::cluster
