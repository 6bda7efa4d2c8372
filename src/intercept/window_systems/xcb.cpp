#include "intercept/window_systems/xcb.h"

#include <dlfcn.h>

#include <algorithm>
#include <bit>

namespace gluray::intercept {
namespace {

template <class Pointer>
void find(void* library, const char* name, Pointer*& pointer) {
  pointer = library ? reinterpret_cast<Pointer*>(dlsym(library, name)) : nullptr;
}

}  // namespace

Xcb::Xcb() {
  void* const bridge = dlopen("libX11-xcb.so.1", RTLD_LAZY | RTLD_LOCAL);
  find(bridge, "XGetXCBConnection", connectionOf);
  void* const core = dlopen("libxcb.so.1", RTLD_LAZY | RTLD_LOCAL);
  find(core, "xcb_connect", connect);
  find(core, "xcb_disconnect", disconnect);
  find(core, "xcb_connection_has_error", failed);
  find(core, "xcb_get_file_descriptor", descriptorOf);
  find(core, "xcb_put_image_checked", putWords);
  find(core, "xcb_get_maximum_request_length", longestRequest);
  find(core, "xcb_get_image", askImage);
  find(core, "xcb_get_image_reply", image);
  find(core, "xcb_get_image_data", imageBytes);
  find(core, "xcb_get_image_data_length", imageLength);
  find(core, "xcb_get_geometry", askGeometry);
  find(core, "xcb_get_geometry_reply", geometry);
  find(core, "xcb_query_tree", askTree);
  find(core, "xcb_query_tree_reply", tree);
  find(core, "xcb_translate_coordinates", askPlace);
  find(core, "xcb_translate_coordinates_reply", place);
  find(core, "xcb_intern_atom", askAtom);
  find(core, "xcb_intern_atom_reply", atom);
  find(core, "xcb_get_property", askProperty);
  find(core, "xcb_get_property_reply", property);
  find(core, "xcb_get_window_attributes", askWindow);
  find(core, "xcb_get_window_attributes_reply", window);
  find(core, "xcb_get_setup", setup);
  find(core, "xcb_setup_roots_iterator", roots);
  find(core, "xcb_screen_next", nextRoot);
  find(core, "xcb_screen_allowed_depths_iterator", depths);
  find(core, "xcb_depth_next", nextDepth);
  find(core, "xcb_depth_visuals_iterator", visuals);
  find(core, "xcb_visualtype_next", nextVisual);
  find(core, "xcb_setup_pixmap_formats", formats);
  find(core, "xcb_setup_pixmap_formats_length", formatCount);
  find(core, "xcb_generate_id", newId);
  find(core, "xcb_create_gc_checked", createGc);
  find(core, "xcb_free_gc", freeGc);
  find(core, "xcb_request_check", check);
  find(core, "xcb_flush", flush);
  find(core, "xcb_send_event", sendEvent);
  find(core, "xcb_get_extension_data", extension);
  void* const shm = dlopen("libxcb-shm.so.0", RTLD_LAZY | RTLD_LOCAL);
  find(shm, "xcb_shm_id", shmId);
  find(shm, "xcb_shm_attach_checked", attach);
  find(shm, "xcb_shm_detach", detach);
  find(shm, "xcb_shm_put_image_checked", putImage);
  void* const glx = dlopen("libxcb-glx.so.0", RTLD_LAZY | RTLD_LOCAL);
  find(glx, "xcb_glx_get_drawable_attributes", askAttributes);
  find(glx, "xcb_glx_get_drawable_attributes_reply", attributes);
  find(glx, "xcb_glx_get_drawable_attributes_attribs", list);
}

/// Checks one function per library: the other functions then exist, too.
bool Xcb::canPut() const { return connectionOf && flush && putImage; }

const Xcb& xcb() {
  static const Xcb once;
  return once;
}

namespace {

const xcb_visualtype_t* visualOf(const xcb_setup_t* setup, xcb_visualid_t id) {
  for (auto root = xcb().roots(setup); root.rem; xcb().nextRoot(&root))
    for (auto depth = xcb().depths(root.data); depth.rem; xcb().nextDepth(&depth))
      for (auto visual = xcb().visuals(depth.data); visual.rem; xcb().nextVisual(&visual))
        if (visual.data->visual_id == id) return visual.data;
  return nullptr;
}

/// Whether a pixel of that depth is a 32-bit word in this machine's byte order.
bool hasWords(const xcb_setup_t* setup, uint8_t depth) {
  static_assert(std::endian::native == std::endian::little);
  if (setup->image_byte_order != XCB_IMAGE_ORDER_LSB_FIRST) return false;
  const xcb_format_t *begin = xcb().formats(setup), *end = begin + xcb().formatCount(setup);
  return std::any_of(begin, end, [&](const xcb_format_t& f) {
    return f.depth == depth && f.bits_per_pixel == 32 && f.scanline_pad == 32;
  });
}

bool hasKnownColors(const xcb_visualtype_t* visual) {
  return visual && visual->_class == XCB_VISUAL_CLASS_TRUE_COLOR && visual->red_mask == 0xff0000 &&
         visual->green_mask == 0xff00 && visual->blue_mask == 0xff;
}

}  // namespace

bool hasPlainPixels(xcb_connection_t* connection, uint8_t depth, xcb_visualid_t visual) {
  const xcb_setup_t* const setup = xcb().setup(connection);
  return hasWords(setup, depth) && hasKnownColors(visualOf(setup, visual));
}

}  // namespace gluray::intercept
