#include "cluster/stream/settings_codec.h"

#include "settings/values.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace gluray::cluster {
namespace {

constexpr uint16_t kEnd = 0xFFFF;  // after the last setting

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

void put(ByteWriter& out, const std::string& text) {
  out.put(static_cast<uint64_t>(text.size()));
  out.put(text.data(), text.size());
}
void put(ByteWriter& out, const std::vector<std::string>& list) {
  out.put(static_cast<uint64_t>(list.size()));
  for (const std::string& entry : list) put(out, entry);
}
void put(ByteWriter& out, const QuirkSet& quirks) { put(out, printQuirks(quirks)); }
void put(ByteWriter& out, const bool& value) { out.put(static_cast<uint8_t>(value)); }
template <class T>
void put(ByteWriter& out, const T& value) {
  out.put(value);
}

void get(ByteReader& in, const Row&, std::string& text) {
  const auto bytes = in.readBytes(in.count(1));
  text.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}
void get(ByteReader& in, const Row& row, std::vector<std::string>& list) {
  for (size_t left = in.count(8); left > 0; --left) {
    get(in, row, list.emplace_back());
    if (row.check && !row.check(list.back()).empty())
      throw Malformed(std::string(row.name) + ": an entry is wrong");
  }
}
void get(ByteReader& in, const Row& row, QuirkSet& quirks) {
  std::string text;
  get(in, row, text);
  if (!readQuirks(text, quirks).empty()) throw Malformed("an unknown quirk");
}
void get(ByteReader& in, const Row& row, bool& value) {
  const auto byte = in.get<uint8_t>();
  if (byte > 1) throw Malformed(std::string(row.name) + ": neither on nor off");
  value = byte != 0;
}
void get(ByteReader& in, const Row& row, uint8_t& word) {
  word = in.get<uint8_t>();
  if (word >= row.words.size()) throw Malformed(std::string(row.name) + ": no such word");
}
void get(ByteReader& in, const Row&, glm::vec3& value) { value = in.get<glm::vec3>(); }
template <class T>
requires std::is_arithmetic_v<T>
void get(ByteReader& in, const Row& row, T& value) {
  value = in.get<T>();
  if (row.ranged && !(value >= row.least && value <= row.most))
    throw Malformed(std::string(row.name) + ": out of range");
}

}  // namespace

void writeSettings(ByteWriter& out, const Settings& settings) {
  static const Session defaults;
  Session session;
  session.settings = settings;
  uint16_t index = 0;
  for (const Row& row : settingRows()) {
    if (isOfSnapshots(row) && !sameValue(row, session, defaults)) {
      out.put(index);
      std::visit([&](const auto* value) { put(out, *value); }, row.place(session));
    }
    ++index;
  }
  out.put(kEnd);
}

Settings readSettings(ByteReader& in) {
  Session session;
  int last = -1;
  for (auto index = in.get<uint16_t>(); index != kEnd; index = in.get<uint16_t>()) {
    if (index >= settingRows().size() || index <= last || !isOfSnapshots(settingRows()[index]))
      throw Malformed("there is no such setting");
    const Row& row = settingRows()[index];
    std::visit([&](auto* value) { get(in, row, *value); }, row.place(session));
    last = index;
  }
  return session.settings;
}

}  // namespace gluray::cluster
