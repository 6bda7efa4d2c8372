// The frame benchmark's image as a snapshot, which frame::Renderer traces without OpenGL.
#pragma once
#include "bench/data/orbit.h"
#include "bench/data/triangle_mesh.h"
#include "scene/snapshot.h"

namespace gluray::bench {

/// The mesh with a light along the view axis, diffuse, over the whole of the benchmark's image. It reads
/// `mesh` in place, which must outlive it and every renderer that has seen it.
scene::Snapshot waveletSnapshot(const TriangleMesh& mesh);

/// Puts the camera there.
void lookFrom(scene::Snapshot& snapshot, const CameraPose& pose);

}  // namespace gluray::bench
