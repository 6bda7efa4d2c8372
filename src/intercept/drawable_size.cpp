#include "intercept/drawable_size.h"

#include <dlfcn.h>
#include <xcb/glx.h>
#include <xcb/xcb.h>

#include <cstdint>
#include <cstdlib>
#include <memory>

namespace gluray::intercept {
namespace {

struct Freed {
  void operator()(void* reply) const { std::free(reply); }
};
template <class Reply>
using ReplyPtr = std::unique_ptr<Reply, Freed>;

template <class Function>
void find(void* library, const char* name, Function*& function) {
  function = library ? reinterpret_cast<Function*>(dlsym(library, name)) : nullptr;
}

/// XCB hands errors to who asked, where Xlib ends the program. Opened when needed: programs that draw
/// without an X server may have none of these libraries.
struct Xcb {
  xcb_connection_t* (*connectionOf)(Display*);
  decltype(xcb_get_geometry)* askGeometry;
  decltype(xcb_get_geometry_reply)* geometry;
  decltype(xcb_glx_get_drawable_attributes)* askAttributes;
  decltype(xcb_glx_get_drawable_attributes_reply)* attributes;
  decltype(xcb_glx_get_drawable_attributes_attribs)* list;

  Xcb() {
    void* const bridge = dlopen("libX11-xcb.so.1", RTLD_LAZY | RTLD_LOCAL);
    void* const core = dlopen("libxcb.so.1", RTLD_LAZY | RTLD_LOCAL);
    void* const glx = dlopen("libxcb-glx.so.0", RTLD_LAZY | RTLD_LOCAL);
    find(bridge, "XGetXCBConnection", connectionOf);
    find(core, "xcb_get_geometry", askGeometry);
    find(core, "xcb_get_geometry_reply", geometry);
    find(glx, "xcb_glx_get_drawable_attributes", askAttributes);
    find(glx, "xcb_glx_get_drawable_attributes_reply", attributes);
    find(glx, "xcb_glx_get_drawable_attributes_attribs", list);
  }
};

const Xcb& xcb() {
  static const Xcb once;
  return once;
}

/// Of windows and pixmaps of X.
glm::ivec2 sizeOfX(xcb_connection_t* connection, uint32_t drawable) {
  if (!xcb().askGeometry || !xcb().geometry) return glm::ivec2(0);
  xcb_generic_error_t* error = nullptr;
  const auto cookie = xcb().askGeometry(connection, drawable);
  const ReplyPtr<xcb_get_geometry_reply_t> reply(xcb().geometry(connection, cookie, &error));
  std::free(error);
  return reply ? glm::ivec2(reply->width, reply->height) : glm::ivec2(0);
}

/// Of windows, pixmaps and pbuffers that have names of GLX alone (GLX 1.4, 3.3.4 to 3.3.6).
glm::ivec2 sizeOfGlx(xcb_connection_t* connection, uint32_t drawable) {
  if (!xcb().askAttributes || !xcb().attributes || !xcb().list) return glm::ivec2(0);
  xcb_generic_error_t* error = nullptr;
  const auto cookie = xcb().askAttributes(connection, drawable);
  const ReplyPtr<xcb_glx_get_drawable_attributes_reply_t> reply(xcb().attributes(connection, cookie, &error));
  std::free(error);
  glm::ivec2 size(0);
  if (!reply) return size;
  const uint32_t* pair = xcb().list(reply.get());
  for (uint32_t i = 0; i < reply->num_attribs; ++i, pair += 2) {
    if (pair[0] == GLX_WIDTH) size.x = static_cast<int>(pair[1]);
    if (pair[0] == GLX_HEIGHT) size.y = static_cast<int>(pair[1]);
  }
  return size;
}

}  // namespace

glm::ivec2 drawableSize(Display* display, GLXDrawable drawable) noexcept {
  if (!display || !drawable || !xcb().connectionOf) return glm::ivec2(0);
  xcb_connection_t* const connection = xcb().connectionOf(display);
  if (!connection) return glm::ivec2(0);
  const auto name = static_cast<uint32_t>(drawable);
  const glm::ivec2 size = sizeOfX(connection, name);
  return size.x > 0 ? size : sizeOfGlx(connection, name);
}

}  // namespace gluray::intercept
