#include "gl/culled/draw_content.h"

#include "gl/arrays/array_indices.h"

#include <algorithm>

namespace gluray::gl {

CullReason readContent(ShadowState& shadow, const ArrayState& arrays, const ArraySource& positions,
                       int components, GLenum mode, const Elements& e, DrawContent& content) {
  const bool inBuffers = positions.buffer && (!e.type || arrays.elements);
  const bool always = shadow.settings.cull.draws == Culling::always;
  if (!positions.enabled || (!inBuffers && !always)) return CullReason::arrayState;
  ArrayState& read = content.arrays;
  read.vertex = positions, read.vertex.size = std::min(positions.size, components);
  read.elements = arrays.elements;
  if (arrays.reason == Reason::deletedBuffer) return CullReason::deletedBuffer;
  if (foreignReason(read) != Reason::traced) return CullReason::foreignBuffer;
  content.assembly = assemblyOf(shadow.real, shadow.raster().firstVertexProvokes, mode, e);
  if (content.assembly.restart && !inBuffers) return CullReason::arrayState;
  content.name = content.assembly.added(contentOf(shadow.real, read, mode, e));
  return CullReason::culled;
}

}  // namespace gluray::gl
