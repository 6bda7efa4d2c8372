// The depth of surfaces that were traced, drawn once more by the real OpenGL, so that later passes over them
// meet it to the bit (gl/draws/multipass_surfaces.h). GL thread, outside glBegin/glEnd.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/present/features.h"
#include "scene/snapshot.h"

namespace gluray::present {

/// Gives what is seen of the fixed-function instances, which were traced before, the depth that the real
/// OpenGL has for them. Nothing else differs afterwards. False where that is not possible (no depth textures
/// of the framebuffer's kind), with the depth as it was.
bool drawDepthAgain(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot);

/// The same of one mesh, which a shader program put into the snapshot's region by a matrix.
bool drawDepthAgain(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                    const gl::PresentTarget::ByMatrix& surface);

}  // namespace gluray::present
