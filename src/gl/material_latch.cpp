#include "gl/material_latch.h"

#include "gl/replay.h"

namespace gluray::gl {

void MaterialLatch::restore(const RealGl& real) const {
  if (!waiting_.front && !waiting_.back) return;
  // The first question makes Mesa store what is waiting but keep it; the second makes it let go.
  GLfloat shininess = 0;
  for (int i = 0; i < 2; ++i) real.GetMaterialfv(GL_FRONT, GL_SHININESS, &shininess);
  sendMaterial(real, waiting_);
}

}  // namespace gluray::gl
