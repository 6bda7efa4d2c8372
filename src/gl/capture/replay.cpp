#include "gl/capture/replay.h"

#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <array>

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

}  // namespace

void sendMaterial(const RealGl& real, const MaterialChange& change) {
  sendFace(real, GL_FRONT, change.values.front, change.front);
  sendFace(real, GL_BACK, change.values.back, change.back);
}

namespace {

/// Sends material changes between vertices. Changes made outside glBegin and glEnd are sent outside, too:
/// inside a primitive, Mesa's lists would also store parameters that follow the colour (GL_COLOR_MATERIAL).
class MaterialSender {
 public:
  MaterialSender(const RealGl& real, std::span<const MaterialChange> changes)
      : real_(real), changes_(changes) {}

  /// Sends glBegin. `number`: the material change of the first vertex, or 0.
  void begin(GLenum mode, uint32_t number) {
    mode_ = mode;
    send(lastOutside(number));
    real_.Begin(mode);
  }
  /// Sends the material change of the next vertex.
  void vertex(uint32_t number) {
    if (number == sent_) return;
    if (const uint32_t outside = lastOutside(number)) {
      real_.End();
      send(outside);
      real_.Begin(mode_);
    }
    send(number);
  }

 private:
  /// The last unsent change up to `number` that was made outside; 0 if there is none.
  uint32_t lastOutside(uint32_t number) const {
    while (number > sent_ && !changes_[number - 1].outside) --number;
    return number > sent_ ? number : 0;
  }
  void send(uint32_t number) {
    if (number == 0 || number == sent_) return;
    const MaterialChange& change = changes_[number - 1];
    sendMaterial(real_, sent_ ? change.since(changes_[sent_ - 1]) : change);
    sent_ = number;
  }

  const RealGl& real_;
  std::span<const MaterialChange> changes_;
  GLenum mode_ = GL_POINTS;
  uint32_t sent_ = 0;
};

/// Sends glBegin, then for each vertex its material and each(vertex number).
template <class MaterialOf, class Each>
void sendOpen(MaterialSender& materials, const Primitive& primitive, const uint32_t* indices,
              MaterialOf&& materialOf, Each&& each) {
  const auto vertexOf = [&](uint32_t i) {
    return indices ? indices[primitive.first + i] : primitive.first + i;
  };
  materials.begin(primitive.mode, primitive.count > 0 ? materialOf(vertexOf(0)) : 0);
  for (uint32_t i = 0; i < primitive.count; ++i) {
    materials.vertex(materialOf(vertexOf(i)));
    each(vertexOf(i));
  }
}

/// Sends primitives of a capture, with all attributes of their vertices.
class CaptureSender {
 public:
  CaptureSender(const RealGl& real, const CapturedVertices& captured,
                std::span<const InheritedSlot> inherited)
      : real_(real), captured_(captured), materials_(real, captured.materials) {
    for (const InheritedSlot& slot : inherited) inheriting_[slot.slot] = slot.vertices;
  }

  void sendOpen(const Primitive& primitive) {
    const uint32_t* indices = captured_.indices.empty() ? nullptr : captured_.indices.data();
    gl::sendOpen(
        materials_, primitive, indices, [&](uint32_t i) { return materialOf(i); },
        [&](uint32_t i) { sendVertex(i); });
  }

 private:
  uint32_t materialOf(uint32_t i) const {
    if (!captured_.layout.has(kMaterialNumber)) return 0;
    return static_cast<uint32_t>(captured_.vertex(i)[captured_.layout.offset[kMaterialNumber]]);
  }
  void sendVertex(uint32_t i) const {
    const VertexLayout& layout = captured_.layout;
    const float* v = captured_.vertex(i);
    for (int s = kNormal; s < kSlotCount; ++s)
      if (layout.has(static_cast<Slot>(s)) && i >= inheriting_[static_cast<size_t>(s)])
        sendAttribute(real_, static_cast<Slot>(s), v + layout.offset[s]);
    real_.Vertex4f(v[0], v[1], v[2], layout.has(kPositionW) ? v[layout.offset[kPositionW]] : 1.0f);
  }

  const RealGl& real_;
  const CapturedVertices& captured_;
  MaterialSender materials_;
  std::array<uint32_t, kSlotCount> inheriting_{};  // number of first vertices that inherit the slot
};

}  // namespace

void replay(const RealGl& real, const CapturedVertices& captured, std::span<const InheritedSlot> inherited) {
  CaptureSender sender(real, captured, inherited);
  for (const Primitive& p : captured.primitives) sender.sendOpen(p), real.End();
}

void replayOpen(const RealGl& real, const CapturedVertices& captured, const Primitive& open,
                std::span<const InheritedSlot> inherited) {
  CaptureSender(real, captured, inherited).sendOpen(open);
}

void replay(const RealGl& real, const scene::Mesh& mesh, std::span<const Primitive> primitives,
            std::span<const MaterialChange> materials) {
  const auto materialOf = [&](uint32_t i) {
    if (!mesh.materials) return 0u;
    return *reinterpret_cast<const uint32_t*>(mesh.materials.data + size_t{i} * mesh.materials.stride);
  };
  const auto send = [&](uint32_t i) {
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
  // Welded triangles are replayed through their indices; all other vertices are still in the order sent.
  const bool welded = primitives.size() == 1 && primitives[0].mode == GL_TRIANGLES && mesh.indices;
  const auto* indices = welded ? reinterpret_cast<const uint32_t*>(mesh.indices.data) : nullptr;
  MaterialSender sender(real, materials);
  for (const Primitive& p : primitives) sendOpen(sender, p, indices, materialOf, send), real.End();
}

}  // namespace gluray::gl
