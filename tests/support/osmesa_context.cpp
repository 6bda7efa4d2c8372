#include "tests/support/osmesa_context.h"

#include "intercept/window_systems/osmesa_api.h"

#include <GL/glext.h>
#include <dlfcn.h>

#include <utility>

namespace gluray::test {
namespace {

/// The function of this name, with its type in RealGl.
template <class Function>
Function osmesaFunction(const char* name) {
  return reinterpret_cast<Function>(OSMesaGetProcAddress(name));
}

thread_local GLenum g_refused = GL_NO_ERROR;

/// Refuses queries that core profiles lack, as the specification and Mesa 25 do; Mesa 22 answers them.
void APIENTRY strictGetIntegerv(GLenum name, GLint* value) {
  switch (name) {
    case GL_RED_BITS:
    case GL_GREEN_BITS:
    case GL_BLUE_BITS:
    case GL_ALPHA_BITS:
    case GL_DEPTH_BITS:
    case GL_STENCIL_BITS: g_refused = GL_INVALID_ENUM; return;
    default: {
      static const auto real = osmesaFunction<decltype(gl::RealGl::GetIntegerv)>("glGetIntegerv");
      real(name, value);
    }
  }
}

GLenum APIENTRY strictGetError() {
  static const auto real = osmesaFunction<decltype(gl::RealGl::GetError)>("glGetError");
  const GLenum below = real();
  const GLenum refused = std::exchange(g_refused, GLenum{GL_NO_ERROR});
  return below != GL_NO_ERROR ? below : refused;
}

/// Whether OSMesa is GLuRay's, which has no accumulation buffers.
bool isOverEgl() { return dlsym(RTLD_DEFAULT, "OSMesaIsOverEgl") != nullptr; }

}  // namespace

std::unique_ptr<OsmesaContext> OsmesaContext::create(const ContextWish& wish, const OsmesaContext* share) {
  std::vector<int> attributes = {
      OSMESA_FORMAT,       OSMESA_RGBA,
      OSMESA_DEPTH_BITS,   24,
      OSMESA_STENCIL_BITS, 8,
      OSMESA_ACCUM_BITS,   isOverEgl() ? 0 : 16,
      OSMESA_PROFILE,      wish.core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE};
  if (wish.major) {
    attributes.insert(attributes.end(), {OSMESA_CONTEXT_MAJOR_VERSION, wish.major});
    attributes.insert(attributes.end(), {OSMESA_CONTEXT_MINOR_VERSION, wish.minor});
  }
  attributes.push_back(0);
  OSMesaContext made = OSMesaCreateContextAttribs(
      attributes.data(), share ? static_cast<OSMesaContext>(share->context_) : nullptr);
  if (!made) return nullptr;
  std::unique_ptr<OsmesaContext> context(new OsmesaContext);
  context->wish_ = wish;
  context->context_ = made;
  context->buffer_.resize(static_cast<size_t>(wish.width) * static_cast<size_t>(wish.height));
  if (!context->makeCurrent()) return nullptr;
  gl::loadRealGl(
      context->real_,
      [](void*, const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }, nullptr);
  // What a new framebuffer holds is undefined: over EGL, it may be what was drawn into another.
  if (isOverEgl()) context->real_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  if (wish.core) {
    context->real_.GetIntegerv = strictGetIntegerv;
    context->real_.GetError = strictGetError;
  }
  return context;
}

OsmesaContext::~OsmesaContext() {
  if (OSMesaGetCurrentContext() == context_) OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  OSMesaDestroyContext(static_cast<OSMesaContext>(context_));
}

bool OsmesaContext::makeCurrent() {
  return OSMesaMakeCurrent(static_cast<OSMesaContext>(context_), buffer_.data(), GL_UNSIGNED_BYTE,
                           wish_.width, wish_.height) == GL_TRUE;
}

std::vector<uint32_t> OsmesaContext::colors() const {
  std::vector<uint32_t> pixels(static_cast<size_t>(wish_.width) * static_cast<size_t>(wish_.height));
  real_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  real_.ReadPixels(0, 0, wish_.width, wish_.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

std::vector<float> OsmesaContext::depths() const {
  std::vector<float> pixels(static_cast<size_t>(wish_.width) * static_cast<size_t>(wish_.height));
  real_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  real_.ReadPixels(0, 0, wish_.width, wish_.height, GL_DEPTH_COMPONENT, GL_FLOAT, pixels.data());
  return pixels;
}

}  // namespace gluray::test
