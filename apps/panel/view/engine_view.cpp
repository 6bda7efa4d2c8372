#include "view/engine_view.h"

#include <dlfcn.h>

#include <stdexcept>

namespace gluray::panel {
namespace {

template <class Function>
void find(void* library, const char* name, Function& into) {
  into = reinterpret_cast<Function>(dlsym(library, name));
  if (!into) throw std::runtime_error("install GLuRay again: its library is of another version");
}

}  // namespace

EngineView::EngineView(const std::string& libraryFile, const std::string& scene) {
  void* const handle = dlopen(libraryFile.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error(std::string("install GLuRay again: ") + dlerror());
  find(handle, "glurayViewOpen", library_.open), find(handle, "glurayViewClose", library_.close);
  find(handle, "glurayViewShow", library_.show), find(handle, "glurayViewPoint", library_.point);
  char why[1024] = "";
  view_ = library_.open(kGlurayRenderVersion, scene.c_str(), &facts_, why, sizeof why);
  if (!view_) throw std::runtime_error(why);
}

EngineView::~EngineView() { library_.close(view_); }

bool EngineView::show(const GlurayViewRequest& request, const GlurayViewSink& sink, std::string& why) {
  char line[1024] = "";
  const bool whole = library_.show(view_, &request, &sink, line, sizeof line) != 0;
  why = line;
  return whole;
}

bool EngineView::point(const GlurayViewRequest& request, int x, int y, double (&at)[3]) {
  return library_.point(view_, &request, x, y, at) != 0;
}

}  // namespace gluray::panel
