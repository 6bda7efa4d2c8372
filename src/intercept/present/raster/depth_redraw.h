// Redraws the depth of traced surfaces with the real OpenGL, so that later passes over them find
// bit-identical depths (gl/history/multipass_surfaces.h). GL thread, outside glBegin/glEnd.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/present/state/features.h"
#include "scene/snapshot.h"

namespace gluray::present {

/// Replaces the depth of the visible parts of traced fixed-function instances by the real OpenGL's. Changes
/// nothing else. False, with the depth unchanged, if that is impossible (no depth textures of the
/// framebuffer's kind).
bool drawDepthAgain(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot);

/// The same for one mesh, which a shader program transformed by a matrix.
bool drawDepthAgain(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                    const gl::PresentTarget::ByMatrix& surface);

}  // namespace gluray::present
