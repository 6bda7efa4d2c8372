// Shared by the benchmark's fixed-function programs: one light at the viewer, one camera.
#pragma once

namespace gluray::bench {

/// Sets, in the current context, background, depth test, a light that shines from the viewer and a frustum
/// for the data (bench/data) at `distance` from it; the matrix mode is then GL_MODELVIEW.
void setScene(double distance);

}  // namespace gluray::bench
