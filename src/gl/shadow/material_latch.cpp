#include "gl/shadow/material_latch.h"

#include "gl/capture/replay.h"
#include "gl/real/extensions.h"
#include "gl/state/state.h"
#include "settings/quirks.h"

namespace gluray::gl {
bool MaterialLatch::isIn(const RealGl& real) {
  const int mesa = mesaVersionOf(real.GetString(GL_VERSION));
  return mesa > 0 && mesa < 2300;
}

void MaterialLatch::letGo(const RealGl& real) const {
  if (!on_) return;
  // The first query makes Mesa store the held-back materials but keep them; the second makes it forget them.
  GLfloat shininess = 0;
  for (int i = 0; i < 2; ++i) real.GetMaterialfv(GL_FRONT, GL_SHININESS, &shininess);
}

void MaterialLatch::restore(const RealGl& real) const {
  restoreMaterials(real);
  current_.restore(real);
}

void MaterialLatch::restoreMaterials(const RealGl& real) const {
  if (!on_ || (!waiting_.front && !waiting_.back)) return;
  letGo(real);
  scene::MaterialPair now;
  readMaterial(real, now);
  // Parameters that GL_COLOR_MATERIAL has replaced since then must keep their values.
  MaterialChange again = waiting_;
  again.front &= sameParameters(again.values.front, now.front);
  again.back &= sameParameters(again.values.back, now.back);
  if (again.front || again.back) noteUse(Quirk::materialLatch);
  sendMaterial(real, again);
}

}  // namespace gluray::gl
