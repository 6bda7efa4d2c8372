// Tests settings for light effects. Any thread.
#pragma once
#include "settings/settings.h"

namespace gluray::scene {

/// Whether path tracing replaces the local look.
inline bool wantsPaths(const Settings& s) {
  return s.integrator == LightIntegrator::path || s.integrator == LightIntegrator::whitted;
}
inline bool wantsOcclusion(const Settings& s) {
  return !wantsPaths(s) && (s.ao.enabled || s.integrator == LightIntegrator::ao) && s.ao.strength > 0;
}
inline bool wantsShadows(const Settings& s) {
  return !wantsPaths(s) && s.shadows.enabled && s.shadows.strength > 0;
}
/// Whether colours depend on secondary rays, and so on other surfaces and on noisy samples.
inline bool wantsLight(const Settings& s) { return wantsPaths(s) || wantsOcclusion(s) || wantsShadows(s); }
/// Whether surfaces are lit otherwise than by the program's lights and lighting equation alone.
inline bool changesLight(const Settings& s) {
  return wantsLight(s) || s.lights.rig != LightRig::program || !s.lights.file.empty();
}
/// Leaves surfaces the program's own light.
inline void dropLight(Settings& s) {
  s.ao.enabled = false, s.shadows.enabled = false;
  s.integrator = LightIntegrator::local;
  s.lights.rig = LightRig::program, s.lights.file.clear();
}
/// Whether scenes get a ground. A catcher needs a light effect.
inline bool wantsGround(const Settings& s) {
  if (s.look == Look::honest) return false;
  return s.ground.kind == GroundKind::plane || (s.ground.kind == GroundKind::catcher && wantsLight(s));
}
inline bool wantsCatcher(const Settings& s) { return wantsGround(s) && s.ground.kind == GroundKind::catcher; }
inline bool wantsBackdrop(const Settings& s) { return s.background.kind != BackgroundKind::program; }

}  // namespace gluray::scene
