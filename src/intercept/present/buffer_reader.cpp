#include "intercept/present/buffer_reader.h"

#include "gl/real/state_queries.h"
#include "intercept/present/read_back/point_trial.h"
#include "intercept/present/state/state_guard.h"

#include <exception>

namespace gluray::present {
namespace {

/// Resizes `out` to one value per pixel. False if out of memory.
template <class T>
bool makeRoom(const scene::Region& region, std::vector<T>& out) noexcept {
  try {
    out.resize(static_cast<size_t>(region.width) * static_cast<size_t>(region.height));
    return true;
  } catch (const std::exception&) { return false; }
}

}  // namespace

bool BufferReader::read(const gl::RealGl& real, const scene::Region& region, GLenum format, GLenum type,
                        void* out) noexcept {
  try {
    const Features& has = shared_.features(real);
    if (!has.readFramebuffers) return false;
    StateGuard guard(real, has);
    guard.plainPack();
    guard.readFrom(static_cast<GLuint>(gl::integer(real, GL_DRAW_FRAMEBUFFER_BINDING)),
                   static_cast<GLenum>(gl::integer(real, GL_DRAW_BUFFER0)));
    real.ReadPixels(region.x, region.y, region.width, region.height, format, type, out);
    return takeErrors(real).empty();
  } catch (const std::exception&) { return false; }
}

gl::PresentResult BufferReader::bindFinished(const gl::RealGl& real, const scene::Region& region) noexcept {
  try {
    return finished_.bind(real, shared_, region);
  } catch (const std::exception&) { return {}; }  // out of memory: the program reads what is there
}

bool BufferReader::keep(const gl::RealGl& real, const scene::Region& region) noexcept {
  try {
    return kept_.keep(real, shared_, region);
  } catch (const std::exception&) { return false; }
}

void BufferReader::putBack(const gl::RealGl& real) noexcept {
  try {
    kept_.putBack(real, shared_);
  } catch (const std::exception&) {}  // no memory for the state guard's list
}

bool BufferReader::replacesColors(const gl::RealGl& real) noexcept {
  try {
    return blending_.passes(real, shared_.features(real));
  } catch (const std::exception&) { return false; }
}

std::optional<glm::vec2> BufferReader::pointCoordinateShift(const gl::RealGl& real, int samples) noexcept {
  try {
    return tryPointCoordinates(real, shared_.features(real), samples);
  } catch (const std::exception&) { return std::nullopt; }
}

bool BufferReader::readDepth(const gl::RealGl& real, const scene::Region& region,
                             std::vector<float>& out) noexcept {
  return makeRoom(region, out) && read(real, region, GL_DEPTH_COMPONENT, GL_FLOAT, out.data());
}

bool BufferReader::readFarthest(const gl::RealGl& real, const scene::Region& region, bool least,
                                std::vector<float>& out) noexcept {
  try {
    return makeRoom(region, out) &&
           shared_.samples.readFarthest(real, shared_.features(real), region, least, out.data());
  } catch (const std::exception&) { return false; }
}

bool BufferReader::readResolved(const gl::RealGl& real, const scene::Region& region,
                                std::vector<uint32_t>& out) noexcept {
  try {
    return makeRoom(region, out) && shared_.samples.resolve(real, shared_.features(real), region, out.data());
  } catch (const std::exception&) { return false; }
}

bool BufferReader::readSamples(const gl::RealGl& real, const scene::Region& region,
                               std::vector<uint32_t>& out) noexcept {
  try {
    return shared_.samples.readAll(real, shared_.features(real), region, out);
  } catch (const std::exception&) { return false; }
}

bool BufferReader::bindCopy(const gl::RealGl& real, const scene::Region& region, bool colors) noexcept {
  try {
    return shared_.samples.bindCopy(real, shared_.features(real), region, colors);
  } catch (const std::exception&) { return false; }
}

bool BufferReader::readColors(const gl::RealGl& real, const scene::Region& region,
                              std::vector<uint32_t>& out) noexcept {
  return makeRoom(region, out) && read(real, region, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
}

bool BufferReader::readFloatColors(const gl::RealGl& real, const scene::Region& region,
                                   std::vector<glm::vec4>& out) noexcept {
  // Programs may let OpenGL clamp what is read.
  return gl::integer(real, GL_CLAMP_READ_COLOR) != GL_TRUE && makeRoom(region, out) &&
         read(real, region, GL_RGBA, GL_FLOAT, out.data());
}

}  // namespace gluray::present
