// XCB functions, loaded when needed: programs that draw without an X server may lack these libraries. XCB
// returns errors to the caller, whereas Xlib ends the program. Any thread.
#pragma once
#include <xcb/glx.h>
#include <xcb/shm.h>
#include <xcb/xcb.h>

#include <cstdint>
#include <cstdlib>
#include <memory>

/// Xlib's Display. Its header is not included, because it defines common words as macros.
struct _XDisplay;

namespace gluray::intercept {

/// The functions; null if their library is missing.
struct Xcb {
  xcb_connection_t* (*connectionOf)(_XDisplay*);
  decltype(xcb_connect)* connect;
  decltype(xcb_disconnect)* disconnect;
  decltype(xcb_connection_has_error)* failed;
  decltype(xcb_get_file_descriptor)* descriptorOf;
  decltype(xcb_put_image_checked)* putWords;
  decltype(xcb_get_maximum_request_length)* longestRequest;
  decltype(xcb_get_image)* askImage;
  decltype(xcb_get_image_reply)* image;
  decltype(xcb_get_image_data)* imageBytes;
  decltype(xcb_get_image_data_length)* imageLength;
  decltype(xcb_get_geometry)* askGeometry;
  decltype(xcb_get_geometry_reply)* geometry;
  decltype(xcb_query_tree)* askTree;
  decltype(xcb_query_tree_reply)* tree;
  decltype(xcb_translate_coordinates)* askPlace;
  decltype(xcb_translate_coordinates_reply)* place;
  decltype(xcb_intern_atom)* askAtom;
  decltype(xcb_intern_atom_reply)* atom;
  decltype(xcb_get_property)* askProperty;
  decltype(xcb_get_property_reply)* property;
  decltype(xcb_get_window_attributes)* askWindow;
  decltype(xcb_get_window_attributes_reply)* window;
  decltype(xcb_get_setup)* setup;
  decltype(xcb_setup_roots_iterator)* roots;
  decltype(xcb_screen_next)* nextRoot;
  decltype(xcb_screen_allowed_depths_iterator)* depths;
  decltype(xcb_depth_next)* nextDepth;
  decltype(xcb_depth_visuals_iterator)* visuals;
  decltype(xcb_visualtype_next)* nextVisual;
  decltype(xcb_setup_pixmap_formats)* formats;
  decltype(xcb_setup_pixmap_formats_length)* formatCount;
  decltype(xcb_generate_id)* newId;
  decltype(xcb_create_gc_checked)* createGc;
  decltype(xcb_free_gc)* freeGc;
  decltype(xcb_request_check)* check;
  decltype(xcb_flush)* flush;
  decltype(xcb_send_event)* sendEvent;
  decltype(xcb_get_extension_data)* extension;
  xcb_extension_t* shmId;
  decltype(xcb_shm_attach_checked)* attach;
  decltype(xcb_shm_detach)* detach;
  decltype(xcb_shm_put_image_checked)* putImage;
  decltype(xcb_glx_get_drawable_attributes)* askAttributes;
  decltype(xcb_glx_get_drawable_attributes_reply)* attributes;
  decltype(xcb_glx_get_drawable_attributes_attribs)* list;

  Xcb();
  /// Whether all functions for showing images exist.
  bool canPut() const;
};

const Xcb& xcb();

/// Whether pixels of that depth and visual are 32-bit words in this machine's byte order, with eight bits
/// each for red, green and blue, blue in the lowest byte.
bool hasPlainPixels(xcb_connection_t* connection, uint8_t depth, xcb_visualid_t visual);

struct Freed {
  void operator()(void* reply) const { std::free(reply); }
};
template <class Reply>
using ReplyPtr = std::unique_ptr<Reply, Freed>;

/// The reply to `cookie`, or null if the server returned an error.
template <class Reply, class Cookie>
ReplyPtr<Reply> replyTo(Reply* (*wait)(xcb_connection_t*, Cookie, xcb_generic_error_t**),
                        xcb_connection_t* connection, Cookie cookie) {
  xcb_generic_error_t* error = nullptr;
  ReplyPtr<Reply> reply(wait(connection, cookie, &error));
  std::free(error);
  return reply;
}

}  // namespace gluray::intercept
