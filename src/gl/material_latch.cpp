#include "gl/material_latch.h"

#include "gl/extensions.h"
#include "gl/replay.h"
#include "gl/state.h"
#include "settings/quirks.h"

namespace gluray::gl {
namespace {

/// Those of the parameters `set` whose values the material still has.
uint16_t kept(uint16_t set, const scene::Material& values, const scene::Material& now) {
  uint16_t same = 0;
  if (values.ambient == now.ambient) same |= MaterialChange::ambient;
  if (values.diffuse == now.diffuse) same |= MaterialChange::diffuse;
  if (values.specular == now.specular) same |= MaterialChange::specular;
  if (values.emission == now.emission) same |= MaterialChange::emission;
  if (values.shininess == now.shininess) same |= MaterialChange::shininess;
  return set & same;
}

}  // namespace

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
  again.front = kept(again.front, again.values.front, now.material.front);
  again.back = kept(again.back, again.values.back, now.material.back);
  if (again.front || again.back) noteUse(Quirk::materialLatch);
  sendMaterial(real, again);
}

}  // namespace gluray::gl
