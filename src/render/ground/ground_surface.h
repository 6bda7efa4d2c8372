// The ground as a surface: mesh, material and lights. Made once a frame; any thread.
#pragma once
#include "render/ground/ground_place.h"
#include "scene/snapshot.h"

namespace gluray::render {

struct GroundSurface {
  scene::Instance instance;  // without its index of a shading
  scene::Shading shading;
};

/// Diffuse on both sides and lit by the lights of the snapshot's first lit surface; without lights if there
/// is none. Equal places have meshes with equal content, so that one acceleration structure serves them.
GroundSurface makeGround(const scene::Snapshot&, const GroundPlace&);

}  // namespace gluray::render
