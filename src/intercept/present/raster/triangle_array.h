// The triangles of one mesh in our own vertex array, to draw their depth (depth_redraw.cpp). GL thread.
#pragma once
#include "intercept/present/raster/raster_fallback.h"
#include "intercept/present/state/state_guard.h"
#include "scene/snapshot.h"

namespace gluray::present {

class TriangleArray {
 public:
  /// Needs OpenGL 3.2. Both must outlive it.
  TriangleArray(const gl::RealGl& real, const Features& features, const scene::Mesh& mesh);
  ~TriangleArray();
  TriangleArray(const TriangleArray&) = delete;
  TriangleArray& operator=(const TriangleArray&) = delete;

  /// Draws only their depth into the region of the snapshot, by a program with the uniform MCDCMatrix and the
  /// attribute 0. Restores all queryable state.
  void draw(const scene::Snapshot& snapshot, const glm::dmat4& clipFromObject, GLenum depthFunc,
            const DepthPass& pass) const;

 private:
  const gl::RealGl& real_;
  const Features& features_;
  GLuint array_ = 0, buffer_ = 0;
  GLsizei count_ = 0;
};

}  // namespace gluray::present
