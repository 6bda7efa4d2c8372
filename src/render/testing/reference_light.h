// Reference implementation of the lighting equation, in double and in the specification's order, for the
// tests of render/.
#pragma once
#include "scene/shading.h"

#include <algorithm>
#include <cmath>

namespace gluray::test {

struct ReferenceLit {
  glm::dvec4 primary{0};
  glm::dvec3 secondary{0};
};

inline double clampedDot(const glm::dvec3& a, const glm::dvec3& b) { return std::max(glm::dot(a, b), 0.0); }

/// GL 2.1, 2.14.1, equations 2.1 to 2.5, at eye-space point V with unit normal n. Unclamped.
inline ReferenceLit referenceLight(const scene::Shading& s, const scene::Material& m, const glm::dvec3& V,
                                   const glm::dvec3& n) {
  using glm::dvec3;
  ReferenceLit out;
  dvec3 primary = dvec3(m.emission) + dvec3(m.ambient) * dvec3(s.globalAmbient), specular(0);
  for (const scene::Light& light : s.lights) {
    const bool positional = light.position.w != 0;
    const dvec3 P =
        positional ? dvec3(light.position) / static_cast<double>(light.position.w) : dvec3(light.position);
    const dvec3 VP = glm::normalize(positional ? P - V : P);
    const double d = glm::length(P - V);
    const double att =
        positional ? 1 / (light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d) : 1;
    double spot = 1;
    if (light.spotCutoff != 180) {
      const double cosine = glm::dot(-VP, glm::normalize(dvec3(light.spotDirection)));
      const bool inside = cosine >= std::cos(light.spotCutoff * M_PI / 180);
      spot = inside ? std::pow(std::max(cosine, 0.0), light.spotExponent) : 0;
    }
    const dvec3 h = glm::normalize(VP + (s.localViewer ? glm::normalize(-V) : dvec3(0, 0, 1)));
    const double f = clampedDot(n, VP) != 0 ? 1 : 0;
    primary += att * spot *
               (dvec3(m.ambient) * dvec3(light.ambient) +
                clampedDot(n, VP) * dvec3(m.diffuse) * dvec3(light.diffuse));
    specular +=
        att * spot * f * std::pow(clampedDot(n, h), m.shininess) * dvec3(m.specular) * dvec3(light.specular);
  }
  if (s.separateSpecular)
    out.secondary = specular;
  else
    primary += specular;
  out.primary = {primary, m.diffuse.a};
  return out;
}

/// The colour of an untextured fragment, 0 .. 255, alpha included.
inline glm::vec4 referenceColor(const ReferenceLit& lit) {
  const auto clamp = [](const glm::dvec4& v) { return glm::clamp(v, 0.0, 1.0); };
  const glm::dvec4 sum = clamp(lit.primary) + clamp(glm::dvec4(lit.secondary, 0));
  return glm::vec4(clamp(sum) * 255.0);
}

}  // namespace gluray::test
