// A batch that was taken before its image is in the framebuffer: what it takes to write it there later.
#pragma once
#include "gl/batch/batch.h"
#include "gl/batch/program_draw.h"
#include "scene/snapshot.h"

#include <vector>

namespace gluray::gl {

struct HeldBatch {
  BatchKey key;
  scene::SnapshotPtr snapshot;
  std::vector<ProgramDraw> draws;  // with which the real OpenGL draws it, if it must

  bool readsImages() const { return gl::readImages(draws); }
  bool readsBuffer(GLuint buffer) const { return gl::readsBuffer(draws, buffer); }
};

}  // namespace gluray::gl
