#include "gl/real.h"

#include <cstring>
#include <string_view>
#include <unordered_map>

namespace gluray::gl {
namespace {

// x86-64 and AArch64 calling conventions let a function ignore arguments it was given.
uintptr_t doNothing() { return 0; }

}  // namespace

void* missingCommand() { return reinterpret_cast<void*>(&doNothing); }

void loadRealGl(RealGl& table, Lookup lookup, void* user) {
  void* pointers[kCommandCount];
  std::unordered_map<std::string_view, int> index;
  for (int i = 0; i < kCommandCount; ++i) {
    pointers[i] = lookup(user, kCommandNames[i].name);
    index.emplace(kCommandNames[i].name, i);
  }
  for (int i = 0; i < kCommandCount; ++i) {
    if (pointers[i] || !kCommandNames[i].alias) continue;
    const auto alias = index.find(kCommandNames[i].alias);
    if (alias != index.end()) pointers[i] = pointers[alias->second];
  }
  // Where only the alias exists (an old driver with ARB names), it serves the core name too.
  for (int i = 0; i < kCommandCount; ++i) {
    if (!pointers[i] || !kCommandNames[i].alias) continue;
    const auto core = index.find(kCommandNames[i].alias);
    if (core != index.end() && !pointers[core->second]) pointers[core->second] = pointers[i];
  }
  for (void*& p : pointers)
    if (!p) p = missingCommand();
  std::memcpy(&table, pointers, sizeof table);
}

}  // namespace gluray::gl
