// Sends captured vertices to the real OpenGL, call by call, as the program sent them. GL thread.
#pragma once
#include "gl/capture/captured_vertices.h"
#include "gl/real/real.h"
#include "scene/mesh.h"

#include <span>

namespace gluray::gl {

/// Sets one attribute in the real OpenGL. Ignores kMaterialNumber: use sendMaterial.
void sendAttribute(const RealGl& real, Slot slot, const float* values);

/// Calls glMaterial for every parameter that `change` sets.
void sendMaterial(const RealGl& real, const MaterialChange& change);

/// Sends all primitives of `captured`. `inherited`: slots that are not sent for its first vertices, which
/// take the current values.
void replay(const RealGl& real, const CapturedVertices& captured,
            std::span<const InheritedSlot> inherited = {});

/// Sends glBegin and all vertices that the open primitive has so far.
void replayOpen(const RealGl& real, const CapturedVertices& captured, const Primitive& open,
                std::span<const InheritedSlot> inherited);

/// Sends the primitives of a capture whose vertices were moved into `mesh` (see buildMesh).
void replay(const RealGl& real, const scene::Mesh& mesh, std::span<const Primitive> primitives,
            std::span<const MaterialChange> materials);

}  // namespace gluray::gl
