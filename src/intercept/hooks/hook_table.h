// A table of hooks by name, used by glx.cpp, egl.cpp and osmesa.cpp. Any thread.
#pragma once
#include <cstring>
#include <iterator>

namespace gluray::intercept {

struct Hook {
  const char* name;
  void* function;
};

/// The hook for `name`, or null.
template <size_t N>
void* findHook(const Hook (&hooks)[N], const char* name) {
  for (const Hook& hook : hooks)
    if (std::strcmp(hook.name, name) == 0) return hook.function;
  return nullptr;
}

}  // namespace gluray::intercept
