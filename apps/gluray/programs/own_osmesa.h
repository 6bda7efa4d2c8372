// The libOSMesa that GLuRay brings (src/osmesa), for machines whose Mesa has none any more.
#pragma once
#include <string>

namespace gluray::launcher {

/// The folder of our libOSMesa below the folder of GLuRay's libraries; empty: it is not installed, or the
/// machine has a libOSMesa.so.8 of its own, in LD_LIBRARY_PATH, the loader's cache or its standard folders.
std::string ownOsMesa(const std::string& libraryDirectory);

/// Whether a library of the loader's list (path, or "not") is ours or will be: what it draws comes through
/// EGL, and so through the vendor door.
bool isOwnOsMesa(const std::string& path);

}  // namespace gluray::launcher
