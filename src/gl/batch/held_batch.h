// A batch that was taken but is not in the framebuffer yet, with all that is needed to write it there later.
#pragma once
#include "gl/batch/batch.h"
#include "gl/batch/program_draw.h"
#include "scene/snapshot.h"

#include <vector>

namespace gluray::gl {

struct HeldBatch {
  BatchKey key;
  scene::SnapshotPtr snapshot;
  std::vector<ProgramDraw> draws;  // for the real OpenGL, if it must draw the batch

  bool readsImages() const { return gl::readImages(draws); }
  bool readsBuffer(GLuint buffer) const { return gl::readsBuffer(draws, buffer); }
};

}  // namespace gluray::gl
