// Sends captured vertices to the real OpenGL, call by call, as the program sent them. GL thread.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/real.h"
#include "scene/mesh.h"

#include <span>

namespace gluray::gl {

/// Sets one attribute in the real OpenGL. For kMaterialNumber use setMaterial.
void sendAttribute(const RealGl& real, Slot slot, const float* values);

/// glMaterial for every parameter that `change` holds.
void sendMaterial(const RealGl& real, const MaterialChange& change);

/// All primitives of `captured`.
void replay(const RealGl& real, const CapturedVertices& captured);

/// glBegin and the vertices so far of a primitive that is still open.
void replayOpen(const RealGl& real, const CapturedVertices& captured, const Primitive& open);

/// The primitives of a capture whose vertices live on in `mesh` only (see buildMesh).
void replay(const RealGl& real, const scene::Mesh& mesh, std::span<const Primitive> primitives,
            std::span<const MaterialChange> materials);

}  // namespace gluray::gl
