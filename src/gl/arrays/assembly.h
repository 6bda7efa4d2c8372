// Primitive assembly: maps the vertices of a draw to separate primitives. GL thread.
#pragma once
#include "base/hash.h"
#include "gl/real/elements.h"
#include "gl/real/real.h"

#include <GL/gl.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace gluray::gl {

struct Assembly {
  GLenum mode = GL_TRIANGLES;       // or quads, a strip, a fan
  bool firstProvokes = false;       // GL_FIRST_VERTEX_CONVENTION
  std::optional<uint32_t> restart;  // vertex number that begins a new strip or fan, and drops unfinished ones

  /// Hash of `name` and of the primitive restart and provoking vertex; `name` itself if these do not matter.
  Hash128 added(const Hash128& name) const;
  /// Corners of the primitives, in the order of the real OpenGL: three each, or four for quads.
  std::vector<uint32_t> corners(std::vector<uint32_t> numbers) const;
};

Assembly assemblyOf(const RealGl& real, bool firstProvokes, GLenum mode, const Elements& elements);

/// Disables primitive restart during its lifetime.
class WithoutRestart {
 public:
  explicit WithoutRestart(const RealGl& real);
  ~WithoutRestart();
  WithoutRestart(const WithoutRestart&) = delete;
  WithoutRestart& operator=(const WithoutRestart&) = delete;

 private:
  const RealGl& real_;
  std::array<GLenum, 2> off_{};  // the disabled state
};

}  // namespace gluray::gl
