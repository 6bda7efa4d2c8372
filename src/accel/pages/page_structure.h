// The structure that represents a page: one box. The page's own structure is built when a ray hits the box.
// Called by BlasCache, between frames.
#pragma once
#include "accel/meshes/blas.h"
#include "scene/mesh.h"

namespace gluray::accel {

class PageCache;

/// `pages` must outlive the structure.
BlasPtr createPage(const Device&, PageCache& pages, const scene::Mesh&);

}  // namespace gluray::accel
