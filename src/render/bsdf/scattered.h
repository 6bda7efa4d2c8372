// What the models of this folder have in common. A model is a plain value with
//   glm::vec3 evaluate(wo, wi)      BSDF times |cos(wi)|; 0 for perfectly specular lobes
//   float pdf(wo, wi)               density of sample() in solid angle
//   Scattered sample(wo, u, lobe)   samples the direction of incident light
// `wo` points to the viewer, `wi` to the light, both of unit length, away from the surface and in the local
// frame, whose z is the normal; wo.z > 0, but for bodies of glass, whose rays leave from inside too. `u` and
// `lobe` are in [0, 1). Any thread.
#pragma once
#include "render/bsdf/local_frame.h"

namespace gluray::render::bsdf {

struct Scattered {
  glm::vec3 wi{0};
  glm::vec3 weight{0};  // BSDF * |cos(wi)| / density; 0: the light is absorbed
  float pdf = 0;        // solid angle; of no meaning if `exact`
  bool exact = false;   // perfectly specular: the only direction of its lobe
};

}  // namespace gluray::render::bsdf
