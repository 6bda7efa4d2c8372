// How a family's shader programs cast rays through a volume. Part of Family.
#pragma once
#include "gl/families/family_light.h"
#include "scene/volume.h"

#include <string>
#include <utility>
#include <vector>

namespace gluray::gl {

inline constexpr std::pair<const char*, scene::VolumeBlend> kVolumeBlends[] = {
    {"composite", scene::VolumeBlend::composite},
    {"maximum", scene::VolumeBlend::maximum},
    {"minimum", scene::VolumeBlend::minimum},
    {"average", scene::VolumeBlend::average},
    {"additive", scene::VolumeBlend::additive}};

/// Names are those of uniforms. "Data space" is that of the attribute `vertex.position`.
struct FamilyVolume {
  std::string grid;         // sampler3D; empty: the family draws no volumes
  FamilyValue scale, bias;  // scene::Volume
  scene::VolumeBlend blend = scene::VolumeBlend::composite;
  std::string blendSlot;                        // "@group": the program's word of the group replaces `blend`
  std::string opacity, color, gradientOpacity;  // samplers of tables
  std::string depth;                            // sampler: window depths of what ends rays
  FamilyValue depthTexel;                       // width and height of a pixel in its coordinates
  FamilyValue depthOrigin;                      // window coordinates of its lower left corner
  std::vector<std::string> textureFromData;     // matrices, multiplied from left to right
  // scene::VolumeView, in data space or, with the matrices dataFromWorld from left to right, in another one.
  // Those that are active count. Without a direction, rays come from the viewer.
  std::string viewer, viewerInWorld, directionInWorld;
  std::vector<std::string> dataFromWorld;
  std::string jitter;                 // sampler: scene::VolumeView
  FamilyValue step, lower, upper;     // scene::VolumeView
  FamilyValue cellStep, cellSpacing;  // scene::Volume; components of the spacing are above 0
  FamilyValue range, averaged;        // scene::Volume
  FamilyValue colorScale, colorBias;
  std::string twoSided;                               // uniform; not 0: gradients have no sign
  FamilyValue ambient, diffuse, specular, shininess;  // of the material
  FamilyValue lightDiffuse, lightSpecular;            // of a light at the viewer, if they are active
  bool given() const { return !grid.empty(); }
};

}  // namespace gluray::gl
