#include "gl/real/elements.h"

namespace gluray::gl {

void drawReal(const RealGl& real, GLenum mode, const Elements& e) {
  if (e.instances >= 0) {
    if (!e.type && !e.baseInstance) return real.DrawArraysInstanced(mode, e.first, e.count, e.instances);
    if (!e.type)
      return real.DrawArraysInstancedBaseInstance(mode, e.first, e.count, e.instances, e.baseInstance);
    if (!e.base && !e.baseInstance)
      return real.DrawElementsInstanced(mode, e.count, e.type, e.indices, e.instances);
    if (!e.baseInstance)
      return real.DrawElementsInstancedBaseVertex(mode, e.count, e.type, e.indices, e.instances, e.base);
    return real.DrawElementsInstancedBaseVertexBaseInstance(mode, e.count, e.type, e.indices, e.instances,
                                                            e.base, e.baseInstance);
  }
  if (!e.type) return real.DrawArrays(mode, e.first, e.count);
  if (e.base) return real.DrawElementsBaseVertex(mode, e.count, e.type, e.indices, e.base);
  real.DrawElements(mode, e.count, e.type, e.indices);
}

}  // namespace gluray::gl
