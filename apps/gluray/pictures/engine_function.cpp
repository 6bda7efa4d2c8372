#include "pictures/engine_function.h"

#include "programs/doors.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace gluray::launcher {

void* engineSymbol(const char* name) {
  const std::string library = libraryDirectory() + "/libgluray-engine.so";
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error(std::string("install GLuRay again: ") + dlerror());
  void* const found = dlsym(handle, name);
  if (!found) throw std::runtime_error("install GLuRay again: another one's library is " + library);
  return found;
}

}  // namespace gluray::launcher
