// Complex indices of refraction of metals at 650, 550 and 450 nm, for red, green and blue. Measured by
// Johnson and Christy (1972, 1974) and Rakic (1995), as tabulated by refractiveindex.info; see
// THIRD-PARTY.md. Plain data.
#pragma once
#include <glm/glm.hpp>

namespace gluray::render::bsdf {

struct Metal {
  glm::vec3 eta, k;
};

inline constexpr Metal kSilver{{0.15943f, 0.14512f, 0.13547f}, {3.9291f, 3.1900f, 2.3808f}};
inline constexpr Metal kAluminium{{1.3456f, 0.96521f, 0.61722f}, {7.4746f, 6.3995f, 5.3031f}};
inline constexpr Metal kGold{{0.18299f, 0.42108f, 1.3734f}, {3.4242f, 2.3459f, 1.7704f}};
inline constexpr Metal kChromium{{3.1071f, 3.1812f, 2.3230f}, {3.3314f, 3.3291f, 3.1350f}};
inline constexpr Metal kCopper{{0.27105f, 0.67693f, 1.3164f}, {3.6092f, 2.6248f, 2.2921f}};
inline constexpr Metal kIron{{2.9114f, 2.9497f, 2.5845f}, {3.0893f, 2.9318f, 2.7670f}};

}  // namespace gluray::render::bsdf
