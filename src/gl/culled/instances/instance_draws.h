// Draws a range of a draw's instances, with a base instance, or with array pointers to later elements. A part
// of CulledDraws, GL thread, context current.
#pragma once
#include "gl/arrays/arrays.h"
#include "gl/basics/reasons.h"
#include "gl/culled/instances/instance_units.h"
#include "gl/real/elements.h"
#include "gl/real/real.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace gluray::gl {

/// Finds the units of a draw's instances. Returns CullReason::culled, or the reason why they cannot be drawn
/// separately.
CullReason findUnits(const RealGl& real, const ArrayState& arrays, const Elements& elements,
                     std::optional<InstanceUnits>& units);

/// Draws parts of a draw during its lifetime. The destructor restores the arrays.
class InstanceDraws {
 public:
  /// `units`: from findUnits() for the same arrays and draw.
  InstanceDraws(const RealGl& real, const ArrayState& arrays, const InstanceUnits& units);
  ~InstanceDraws() { moveTo(0); }
  InstanceDraws(const InstanceDraws&) = delete;
  InstanceDraws& operator=(const InstanceDraws&) = delete;

  /// Returns `elements` restricted to these instances, to be drawn before the next call.
  Elements elementsOf(Elements elements, const InstancePart& part);

 private:
  /// A vertex buffer binding, or an attribute's array if OpenGL has no bindings.
  struct Moved {
    GLuint index = 0, buffer = 0;
    GLintptr offset = 0;
    GLsizei stride = 0;    // as the program set it; without bindings, 0 means tightly packed
    GLsizei distance = 0;  // between elements
    uint32_t divisor = 1;
    GLint size = 4;
    GLenum type = GL_FLOAT;
    bool normalized = false, integers = false;
  };
  void find(const ArrayState& arrays);
  Moved attributeOf(const ArraySource& array) const;
  Moved bindingOf(const ArraySource& array) const;
  /// Moves the arrays to begin with the elements of instance `first`.
  void moveTo(uint32_t first);

  const RealGl& real_;
  const bool byArrays_;  // otherwise by base instance
  bool hasBindings_ = false;
  const InstanceUnits& units_;
  std::vector<Moved> moved_;
  uint32_t at_ = 0;  // first instance of the arrays
};

}  // namespace gluray::gl
