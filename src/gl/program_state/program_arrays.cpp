// Reads the vertex arrays of shader programs.
#include "gl/program_state/program_state.h"
#include "gl/programs/vertex_inputs.h"
#include "gl/real/state_queries.h"
#include "gl/sharing/share_group.h"

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

/// The array of a generic attribute. Since OpenGL 4.3 an array's format and buffer are separate, and the
/// buffer is always that of the attribute's binding.
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

/// Whether the colour attribute, which vertices and instances share, has an element for each instance.
bool hasInstanceColors(const RealGl& real, ShareGroup& group, const Program& program, const Family& family) {
  if (family.instanceColor.empty() || family.instanceColor != family.color) return false;
  const ProgramAttribute* a = program.attribute(family.color);
  if (!a || a->location < 0) return false;
  const ArraySource source = readGeneric(real, group, a->location);
  return source.enabled && source.divisor > 0;
}

}  // namespace

const std::string& mapTexcoord(const Program& program, const Family& family) {
  return hasVertexInput(program, family, family.mapTexcoord) ? family.mapTexcoord : family.texcoord;
}

bool hasTwoTexcoords(const Program& program, const Family& family) {
  const std::string& map = mapTexcoord(program, family);
  if (family.pulling.given())
    return map != family.texcoord && hasVertexInput(program, family, family.texcoord);
  const ProgramAttribute* ofMap = program.attribute(map);
  const ProgramAttribute* ofTextures = program.attribute(family.texcoord);
  return ofMap && ofTextures && ofMap->location != ofTextures->location;
}

namespace {

/// Reads arrays of a program's attributes.
class AttributeReader {
 public:
  AttributeReader(const RealGl& real, ShareGroup& group, const KnownProgram* program, ArrayState& out)
      : real_(real), group_(group), program_(program), out_(out) {}

  void read() {
    if (program_ && program_->family) {
      out_.shape = program_->family->impostors.shape;
      if (!program_->family->pulling.given()) readVertices(*program_->family);
    }
    readOthers();
    if (program_ && program_->family) readInstances(*program_->family);
    // Client memory may change before the draw is replayed.
    const auto keep = [&](const ArraySource& s) { plain_ = plain_ && (!s.enabled || s.buffer); };
    out_.forEach(keep);
    for (const ArraySource& source : out_.generic) keep(source);
  }
  /// Whether all arrays that the family names can be read for each vertex or instance.
  bool isPlain() const { return plain_; }

 private:
  const ProgramAttribute* attribute(const std::string& name) const {
    return name.empty() ? nullptr : program_->program.attribute(name);
  }
  void take(const std::string& name, ArraySource& source);
  void takeOfInstances(const std::string& name, int columns, std::vector<ArraySource>& sources);
  void readVertices(const Family& family);
  void readOthers();
  void readInstances(const Family& family);

  const RealGl& real_;
  ShareGroup& group_;
  const KnownProgram* program_;
  ArrayState& out_;
  std::vector<GLint> named_;  // locations of the arrays that the family names
  bool plain_ = true, colorsInstances_ = false;
};

void AttributeReader::take(const std::string& name, ArraySource& source) {
  const ProgramAttribute* a = attribute(name);
  if (!a || a->location < 0) return;
  source = readPlaced(real_, group_, a->location);
  named_.push_back(a->location);
  const GLuint divisor = program_->family->impostors.instances && source.enabled ? 1 : 0;
  plain_ = plain_ && isReadable(source) && source.divisor == divisor;
}

void AttributeReader::readVertices(const Family& family) {
  colorsInstances_ = hasInstanceColors(real_, group_, program_->program, family);
  take(family.position, out_.vertex);
  take(family.normal, out_.normal);
  if (!colorsInstances_) take(family.color, out_.color);
  const bool two = hasTwoTexcoords(program_->program, family);
  const bool mapped = two || !program_->program.attribute(family.texcoord);
  take(mapped ? mapTexcoord(program_->program, family) : family.texcoord, out_.texcoord);
  if (two) out_.texcoordsAbove.resize(1), take(family.texcoord, out_.texcoordsAbove.front());
  if (attribute(family.tangent)) {
    out_.texcoordsAbove.resize(scene::PbrSurface::kTangentUnit);
    take(family.tangent, out_.texcoordsAbove.back());
  }
  take(family.impostors.radius.uniform, out_.radius);
  take(family.impostors.axis, out_.axis);
  out_.sentBillboards = family.impostors.sent;
  out_.ofInstances = family.impostors.instances;
  out_.radiusInPosition = family.impostors.radiusInPosition;
  out_.radiusInCorners = family.impostors.radiusInCorners;
  take(family.impostors.corners, out_.corners), take(family.impostors.end, out_.end);
  take(family.impostors.endColor, out_.endColor), take(family.impostors.caps, out_.caps);
}

/// All other enabled arrays.
void AttributeReader::readOthers() {
  const GLint most = integer(real_, GL_MAX_VERTEX_ATTRIBS);
  for (GLint i = 0; i < most; ++i) {
    if (std::find(named_.begin(), named_.end(), i) != named_.end()) continue;
    ArraySource source = readPlaced(real_, group_, i);
    if (source.enabled) out_.generic.push_back(std::move(source));
  }
}

/// Copies the arrays of a per-instance matrix with `columns` columns from the other arrays to `sources`.
void AttributeReader::takeOfInstances(const std::string& name, int columns,
                                      std::vector<ArraySource>& sources) {
  const ProgramAttribute* a = attribute(name);
  for (int i = 0; a && i < columns; ++i) {
    const auto found = std::find_if(out_.generic.begin(), out_.generic.end(),
                                    [&](const ArraySource& s) { return s.location == a->location + i; });
    const bool fine = found != out_.generic.end() && isReadable(*found) && found->divisor > 0;
    plain_ = plain_ && fine;
    if (fine) sources.push_back(*found);
  }
}

void AttributeReader::readInstances(const Family& family) {
  std::vector<ArraySource> color;
  takeOfInstances(family.instanceTransform, 4, out_.instanceTransform);
  takeOfInstances(family.instanceShift, 1, out_.instanceTransform);
  takeOfInstances(family.instanceNormal, 3, out_.instanceNormal);
  if (colorsInstances_ || family.instanceColor != family.color)
    takeOfInstances(family.instanceColor, 1, color);
  if (!color.empty()) out_.instanceColor = color.front();
}

}  // namespace

void readAttributes(const RealGl& real, ShareGroup& group, const KnownProgram* program, ArrayState& arrays) {
  arrays = {};
  arrays.restart = readRestart(real);
  arrays.elements = bufferNamed(group, static_cast<GLuint>(integer(real, GL_ELEMENT_ARRAY_BUFFER_BINDING)));
  const bool pulls = program && program->family && program->family->pulling.given();
  AttributeReader reader(real, group, program, arrays);
  reader.read();
  if (const Reason foreign = foreignReason(arrays); foreign != Reason::traced)
    arrays.reason = foreign;
  else if (!reader.isPlain() || !(arrays.vertex.enabled || pulls))
    arrays.reason = Reason::arrayState;
}

}  // namespace gluray::gl
