#include "gl/replay.h"

#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

namespace gluray::gl {

void sendAttribute(const RealGl& real, Slot slot, const float* v) {
  switch (slot) {
    case kPosition:
    case kPositionW:
    case kMaterialNumber: break;
    case kNormal: real.Normal3fv(v); break;
    case kColor: real.Color4fv(v); break;
    case kSecondaryColor: real.SecondaryColor3fv(v); break;
    case kFogCoord: real.FogCoordfv(v); break;
    case kEdgeFlag: real.EdgeFlag(v[0] != 0 ? GL_TRUE : GL_FALSE); break;
    case kIndex: real.Indexf(v[0]); break;
    case kTexCoord0: real.TexCoord4fv(v); break;
    default:
      if (slot < kGeneric1)
        real.MultiTexCoord4fv(static_cast<GLenum>(GL_TEXTURE0 + (slot - kTexCoord0)), v);
      else
        real.VertexAttrib4fv(static_cast<GLuint>(slot - kGeneric1 + 1), v);
  }
}

namespace {

void sendFace(const RealGl& real, GLenum face, const scene::Material& m, uint16_t set) {
  if (set & MaterialChange::ambient) real.Materialfv(face, GL_AMBIENT, glm::value_ptr(m.ambient));
  if (set & MaterialChange::diffuse) real.Materialfv(face, GL_DIFFUSE, glm::value_ptr(m.diffuse));
  if (set & MaterialChange::specular) real.Materialfv(face, GL_SPECULAR, glm::value_ptr(m.specular));
  if (set & MaterialChange::emission) real.Materialfv(face, GL_EMISSION, glm::value_ptr(m.emission));
  if (set & MaterialChange::shininess) real.Materialf(face, GL_SHININESS, m.shininess);
}

/// Calls glBegin, each(vertex number) for the primitive's vertices, glEnd.
template <class Each>
void sendPrimitive(const RealGl& real, const Primitive& primitive, const uint32_t* indices, Each&& each) {
  real.Begin(primitive.mode);
  for (uint32_t i = 0; i < primitive.count; ++i)
    each(indices ? indices[primitive.first + i] : primitive.first + i);
  real.End();
}

}  // namespace

void sendMaterial(const RealGl& real, const MaterialChange& change) {
  sendFace(real, GL_FRONT, change.values.front, change.front);
  sendFace(real, GL_BACK, change.values.back, change.back);
}

namespace {

/// Sends single vertices of a capture with all they carry.
class VertexSender {
 public:
  VertexSender(const RealGl& real, const Captured& captured) : real_(real), captured_(captured) {}

  void operator()(uint32_t i) {
    const VertexLayout& layout = captured_.layout;
    const float* v = captured_.vertex(i);
    if (layout.has(kMaterialNumber))
      sendMaterialNumber(static_cast<uint32_t>(v[layout.offset[kMaterialNumber]]));
    for (int s = kNormal; s < kSlotCount; ++s)
      if (layout.has(static_cast<Slot>(s))) sendAttribute(real_, static_cast<Slot>(s), v + layout.offset[s]);
    real_.Vertex4f(v[0], v[1], v[2], layout.has(kPositionW) ? v[layout.offset[kPositionW]] : 1.0f);
  }

 private:
  void sendMaterialNumber(uint32_t number) {
    if (number != material_ && number > 0) sendMaterial(real_, captured_.materials[number - 1]);
    material_ = number;
  }
  const RealGl& real_;
  const Captured& captured_;
  uint32_t material_ = 0;
};

}  // namespace

void replay(const RealGl& real, const Captured& captured) {
  VertexSender send(real, captured);
  const uint32_t* indices = captured.indices.empty() ? nullptr : captured.indices.data();
  for (const Primitive& p : captured.primitives) sendPrimitive(real, p, indices, send);
}

void replayOpen(const RealGl& real, const Captured& captured, const Primitive& open) {
  VertexSender send(real, captured);
  const uint32_t* indices = captured.indices.empty() ? nullptr : captured.indices.data();
  real.Begin(open.mode);
  for (uint32_t i = open.first; i < open.first + open.count; ++i) send(indices ? indices[i] : i);
}

void replay(const RealGl& real, const scene::Mesh& mesh, std::span<const Primitive> primitives,
            std::span<const MaterialChange> materials) {
  uint32_t material = 0;
  const auto send = [&](uint32_t i) {
    if (mesh.materials) {
      const uint32_t next =
          *reinterpret_cast<const uint32_t*>(mesh.materials.data + size_t{i} * mesh.materials.stride);
      if (next != material && next > 0) sendMaterial(real, materials[next - 1]);
      material = next;
    }
    if (mesh.normals) real.Normal3fv(glm::value_ptr(scene::fetch(mesh.normals, i)));
    if (mesh.colors) real.Color4fv(glm::value_ptr(scene::fetch(mesh.colors, i)));
    if (mesh.secondaryColors) real.SecondaryColor3fv(glm::value_ptr(scene::fetch(mesh.secondaryColors, i)));
    if (mesh.fogCoords) real.FogCoordfv(glm::value_ptr(scene::fetch(mesh.fogCoords, i)));
    if (mesh.texcoords) real.TexCoord4fv(glm::value_ptr(scene::fetch(mesh.texcoords, i)));
    for (uint32_t unit = 1; unit <= mesh.texcoordsAbove.size(); ++unit)
      if (const scene::Attribute* texcoords = mesh.texcoordsOf(unit))
        sendAttribute(real, texCoordSlot(unit), glm::value_ptr(scene::fetch(*texcoords, i)));
    real.Vertex3fv(glm::value_ptr(mesh.position(i)));
  };
  // Welded triangles are replayed through their indices; everything else kept its vertices in the order they
  // came.
  const bool welded = primitives.size() == 1 && primitives[0].mode == GL_TRIANGLES && mesh.indices;
  const auto* indices = welded ? reinterpret_cast<const uint32_t*>(mesh.indices.data) : nullptr;
  for (const Primitive& p : primitives) sendPrimitive(real, p, indices, send);
}

}  // namespace gluray::gl
