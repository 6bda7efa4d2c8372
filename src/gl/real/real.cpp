#include "gl/real/real.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <string_view>

namespace gluray::gl {
namespace {

// Under the x86-64 and AArch64 calling conventions a function may ignore arguments that it is given.
uintptr_t doNothing() { return 0; }

}  // namespace

void* missingCommand() { return reinterpret_cast<void*>(&doNothing); }

namespace {

/// Finds command numbers by name. Allocates nothing, because without this table the program would show
/// nothing.
class CommandIndex {
 public:
  CommandIndex() {
    std::iota(byName_.begin(), byName_.end(), 0);
    std::sort(byName_.begin(), byName_.end(), [](int a, int b) { return name(a) < name(b); });
  }
  /// -1 if no command has that name.
  int find(std::string_view wanted) const {
    const auto it = std::lower_bound(byName_.begin(), byName_.end(), wanted,
                                     [](int i, std::string_view n) { return name(i) < n; });
    return it != byName_.end() && name(*it) == wanted ? *it : -1;
  }

 private:
  static std::string_view name(int i) { return kCommandNames[i].name; }
  std::array<int, kCommandCount> byName_;
};

}  // namespace

void loadRealGl(RealGl& table, Lookup lookup, void* user) {
  // Works in the table itself, because the program's stack may be small.
  static_assert(sizeof table == kCommandCount * sizeof(void*));
  const auto at = [&](int i) {
    return reinterpret_cast<char*>(&table) + static_cast<size_t>(i) * sizeof(void*);
  };
  const auto set = [&](int i, void* pointer) { std::memcpy(at(i), &pointer, sizeof pointer); };
  const auto get = [&](int i) {
    void* pointer;
    std::memcpy(&pointer, at(i), sizeof pointer);
    return pointer;
  };
  for (int i = 0; i < kCommandCount; ++i) set(i, lookup(user, kCommandNames[i].name));
  static const CommandIndex index;
  for (int i = 0; i < kCommandCount; ++i) {
    if (get(i) || !kCommandNames[i].alias) continue;
    if (const int alias = index.find(kCommandNames[i].alias); alias >= 0) set(i, get(alias));
  }
  // If only the alias exists (an old driver with ARB names), it serves the core name too.
  for (int i = 0; i < kCommandCount; ++i) {
    if (!get(i) || !kCommandNames[i].alias) continue;
    const int core = index.find(kCommandNames[i].alias);
    if (core >= 0 && !get(core)) set(core, get(i));
  }
  for (int i = 0; i < kCommandCount; ++i)
    if (!get(i)) set(i, missingCommand());
}

}  // namespace gluray::gl
