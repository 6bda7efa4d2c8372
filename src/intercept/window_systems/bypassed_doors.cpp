#include "intercept/window_systems/bypassed_doors.h"

#include <dlfcn.h>

#include <algorithm>
#include <string_view>

namespace gluray::intercept {

std::string walkedPast() {
  constexpr std::string_view kDrivers[] = {"libGLX_", "libEGL_", "libglapi", "libgallium"};
  const void* function = dlsym(RTLD_DEFAULT, "glDrawArrays");
  Dl_info info{};
  if (!function || !dladdr(function, &info) || !info.dli_fname) return "";
  const std::string file = info.dli_fname;
  const std::string_view name = std::string_view(file).substr(file.rfind('/') + 1);
  const bool driver = std::any_of(std::begin(kDrivers), std::end(kDrivers),
                                  [&](std::string_view start) { return name.starts_with(start); });
  return driver ? file : "";
}

}  // namespace gluray::intercept
