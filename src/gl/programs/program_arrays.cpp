// Reads the vertex arrays of shader programs.
#include "gl/programs/program_state.h"
#include "gl/share_group.h"
#include "gl/state/state_queries.h"

#include <algorithm>

namespace gluray::gl {
namespace {

ArraySource readGeneric(const RealGl& real, ShareGroup& group, GLint location) {
  ArraySource source;
  source.location = location;
  source.binding = static_cast<GLuint>(location);
  source.symmetric = true;
  const auto index = static_cast<GLuint>(location);
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    real.GetVertexAttribiv(index, name, &value);
    return value;
  };
  source.enabled = location >= 0 && ask(GL_VERTEX_ATTRIB_ARRAY_ENABLED) != 0;
  if (!source.enabled) return source;
  source.size = ask(GL_VERTEX_ATTRIB_ARRAY_SIZE);
  source.type = static_cast<GLenum>(ask(GL_VERTEX_ATTRIB_ARRAY_TYPE));
  source.normalized = ask(GL_VERTEX_ATTRIB_ARRAY_NORMALIZED) != 0;
  source.stride = ask(GL_VERTEX_ATTRIB_ARRAY_STRIDE);
  if (source.stride == 0) source.stride = static_cast<GLsizei>(sizeOfType(source.type)) * source.size;
  void* pointer = nullptr;
  real.GetVertexAttribPointerv(index, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
  source.pointer = static_cast<const std::byte*>(pointer);
  source.buffer = bufferNamed(group, static_cast<GLuint>(ask(GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING)));
  if (isPresent(real.VertexAttribDivisor))
    source.divisor = static_cast<GLuint>(ask(GL_VERTEX_ATTRIB_ARRAY_DIVISOR));
  return source;
}

/// The array of a generic attribute. Since OpenGL 4.3 format and buffer are separate, and the buffer is that
/// of the attribute's binding, whichever way it was set.
ArraySource readPlaced(const RealGl& real, ShareGroup& group, GLint location) {
  ArraySource source = readGeneric(real, group, location);
  if (!source.enabled || !isPresent(real.BindVertexBuffer)) return source;
  GLint binding = 0, relative = 0, stride = 0, buffer = 0;
  GLint64 offset = 0;
  const auto index = static_cast<GLuint>(location);
  real.GetVertexAttribiv(index, GL_VERTEX_ATTRIB_BINDING, &binding);
  real.GetVertexAttribiv(index, GL_VERTEX_ATTRIB_RELATIVE_OFFSET, &relative);
  const auto slot = static_cast<GLuint>(binding);
  source.binding = slot;
  real.GetIntegeri_v(GL_VERTEX_BINDING_STRIDE, slot, &stride);
  real.GetIntegeri_v(GL_VERTEX_BINDING_BUFFER, slot, &buffer);
  real.GetInteger64i_v(GL_VERTEX_BINDING_OFFSET, slot, &offset);
  if (buffer == 0) return source;  // the program's own memory
  source.stride = stride;
  source.pointer = reinterpret_cast<const std::byte*>(static_cast<size_t>(offset + relative));
  source.buffer = bufferNamed(group, static_cast<GLuint>(buffer));
  return source;
}

/// Whether the attribute for colours, of vertices or instances, has an element for each instance.
bool hasInstanceColors(const RealGl& real, ShareGroup& group, const Program& program, const Family& family) {
  if (family.instanceColor.empty() || family.instanceColor != family.color) return false;
  const ProgramAttribute* a = program.attribute(family.color);
  if (!a || a->location < 0) return false;
  const ArraySource source = readGeneric(real, group, a->location);
  return source.enabled && source.divisor > 0;
}

}  // namespace

const std::string& mapTexcoord(const Program& program, const Family& family) {
  return program.attribute(family.mapTexcoord) ? family.mapTexcoord : family.texcoord;
}

bool hasTwoTexcoords(const Program& program, const Family& family) {
  const ProgramAttribute* map = program.attribute(mapTexcoord(program, family));
  const ProgramAttribute* textures = program.attribute(family.texcoord);
  return map && textures && map->location != textures->location;
}

void readAttributes(const RealGl& real, ShareGroup& group, const KnownProgram* program, ArrayState& arrays) {
  arrays = {};
  arrays.elements = bufferNamed(group, static_cast<GLuint>(integer(real, GL_ELEMENT_ARRAY_BUFFER_BINDING)));
  const Family* family = program ? program->family.get() : nullptr;
  std::vector<GLint> named;
  bool plain = true;
  const auto take = [&](const std::string& name, ArraySource& source) {
    const ProgramAttribute* a = name.empty() || !family ? nullptr : program->program.attribute(name);
    if (!a || a->location < 0) return;
    source = readPlaced(real, group, a->location);
    named.push_back(a->location);
    plain = plain && isReadable(source) && source.divisor == 0;
  };
  const bool colorsInstances = family && hasInstanceColors(real, group, program->program, *family);
  if (family) {
    take(family->position, arrays.vertex);
    take(family->normal, arrays.normal);
    if (!colorsInstances) take(family->color, arrays.color);
    const bool two = hasTwoTexcoords(program->program, *family);
    const bool mapped = two || !program->program.attribute(family->texcoord);
    take(mapped ? mapTexcoord(program->program, *family) : family->texcoord, arrays.texcoord);
    if (two) arrays.texcoordsAbove.resize(1), take(family->texcoord, arrays.texcoordsAbove.front());
    arrays.shape = family->impostors.shape;
    take(family->impostors.radius.uniform, arrays.radius);
    take(family->impostors.axis, arrays.axis);
    arrays.sentBillboards = family->impostors.sent;
    arrays.radiusInPosition = family->impostors.radiusInPosition;
    take(family->impostors.corners, arrays.corners), take(family->impostors.end, arrays.end);
    take(family->impostors.endColor, arrays.endColor), take(family->impostors.caps, arrays.caps);
  }
  const GLint most = integer(real, GL_MAX_VERTEX_ATTRIBS);
  for (GLint i = 0; i < most; ++i) {
    if (std::find(named.begin(), named.end(), i) != named.end()) continue;
    ArraySource source = readPlaced(real, group, i);
    if (source.enabled) arrays.generic.push_back(std::move(source));
  }
  const auto ofInstances = [&](const std::string& name, int columns, std::vector<ArraySource>& sources) {
    const ProgramAttribute* a = name.empty() || !family ? nullptr : program->program.attribute(name);
    for (int i = 0; a && i < columns; ++i) {
      const auto found = std::find_if(arrays.generic.begin(), arrays.generic.end(),
                                      [&](const ArraySource& s) { return s.location == a->location + i; });
      const bool fine = found != arrays.generic.end() && isReadable(*found) && found->divisor > 0;
      plain = plain && fine;
      if (fine) sources.push_back(*found);
    }
  };
  if (family) {
    std::vector<ArraySource> color;
    ofInstances(family->instanceTransform, 4, arrays.instanceTransform);
    ofInstances(family->instanceShift, 1, arrays.instanceTransform);
    ofInstances(family->instanceNormal, 3, arrays.instanceNormal);
    if (colorsInstances || family->instanceColor != family->color)
      ofInstances(family->instanceColor, 1, color);
    if (!color.empty()) arrays.instanceColor = color.front();
  }
  // Client memory may change before the draw is replayed.
  const auto keep = [&](const ArraySource& s) { plain = plain && (!s.enabled || s.buffer); };
  arrays.forEach(keep);
  for (const ArraySource& source : arrays.generic) keep(source);
  if (const Reason foreign = foreignReason(arrays); foreign != Reason::traced)
    arrays.reason = foreign;
  else if (!plain || !arrays.vertex.enabled || restartsPrimitives(real))
    arrays.reason = Reason::arrayState;
}

}  // namespace gluray::gl
