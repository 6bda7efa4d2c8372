#include "settings/quirks.h"

#include "base/log.h"

#include <array>
#include <atomic>

namespace gluray {
namespace {

constexpr std::array<QuirkText, kQuirkCount> kTexts{{
#define X(id, name, reason, test) {name, reason, test},
    GLURAY_QUIRKS(X)
#undef X
}};

std::array<std::atomic<uint64_t>, kQuirkCount> g_uses{};

std::string allNames() {
  std::string names;
  for (const QuirkText& text : kTexts) names.append(names.empty() ? "" : ", ").append(text.name);
  return names;
}

/// Parses one "NAME=on|off"; returns an error line, or empty.
std::string readOne(std::string_view entry, QuirkSet& quirks) {
  const size_t sign = entry.find('=');
  const std::string_view name = entry.substr(0, sign),
                         value = sign == entry.npos ? "" : entry.substr(sign + 1);
  if (value != "on" && value != "off") return std::string(entry) + ": use NAME=on or NAME=off";
  if (quirks.set(name, value == "on")) return "";
  return std::string(name) + ": no such quirk; there is: " + allNames();
}

}  // namespace

const QuirkText& describe(Quirk quirk) { return kTexts[static_cast<size_t>(quirk)]; }

bool QuirkSet::set(std::string_view name, bool on) {
  for (int i = 0; i < kQuirkCount; ++i) {
    const auto quirk = static_cast<Quirk>(i);
    if (describe(quirk).name != name) continue;
    off_ = on ? off_ & ~bit(quirk) : off_ | bit(quirk);
    return true;
  }
  return false;
}

std::string readQuirks(std::string_view text, QuirkSet& quirks) {
  std::string wrong;
  while (!text.empty()) {
    const size_t comma = text.find(',');
    const std::string_view entry = text.substr(0, comma);
    text = comma == text.npos ? std::string_view() : text.substr(comma + 1);
    if (entry.empty()) continue;
    if (const std::string line = readOne(entry, quirks); wrong.empty()) wrong = line;
  }
  return wrong;
}

std::string printQuirks(const QuirkSet& quirks) {
  std::string text;
  for (int i = 0; i < kQuirkCount; ++i) {
    const auto quirk = static_cast<Quirk>(i);
    if (quirks.has(quirk) == QuirkSet{}.has(quirk)) continue;
    text.append(text.empty() ? "" : ",").append(describe(quirk).name);
    text.append(quirks.has(quirk) ? "=on" : "=off");
  }
  return text;
}

void noteUse(Quirk quirk) noexcept {
  if (g_uses[static_cast<size_t>(quirk)].fetch_add(1, std::memory_order_relaxed) != 0) return;
  try {
    log::write(log::Level::info, "quirk " + std::string(describe(quirk).name) +
                                     " is active: " + std::string(describe(quirk).reason));
  } catch (...) {  // the log line is lost
  }
}

uint64_t useCount(Quirk quirk) noexcept {
  return g_uses[static_cast<size_t>(quirk)].load(std::memory_order_relaxed);
}

}  // namespace gluray
