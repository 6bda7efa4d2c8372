#include "gl/capture/material_latch.h"

#include "gl/capture/replay.h"
#include "gl/state/extensions.h"
#include "gl/state/state.h"
#include "settings/quirks.h"

namespace gluray::gl {
bool MaterialLatch::isIn(const RealGl& real) {
  const int mesa = mesaVersionOf(real.GetString(GL_VERSION));
  return mesa > 0 && mesa < 2300;
}

void MaterialLatch::letGo(const RealGl& real) const {
  if (!on_) return;
  // The first question makes Mesa store what is waiting but keep it; the next makes it let go.
  GLfloat shininess = 0;
  for (int i = 0; i < 2; ++i) real.GetMaterialfv(GL_FRONT, GL_SHININESS, &shininess);
}

void MaterialLatch::restore(const RealGl& real) const {
  if (!on_ || (!waiting_.front && !waiting_.back)) return;
  letGo(real);
  State now;
  readMaterial(real, now);
  // What colour material has replaced since then must stay as it is.
  MaterialChange again = waiting_;
  again.front &= sameParameters(again.values.front, now.material.front);
  again.back &= sameParameters(again.values.back, now.material.back);
  if (again.front || again.back) noteUse(Quirk::materialLatch);
  sendMaterial(real, again);
}

}  // namespace gluray::gl
