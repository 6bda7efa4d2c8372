// How a family's shader programs cast rays through a volume. Part of Family.
#pragma once
#include "gl/families/family_light.h"
#include "scene/volumes/volume.h"

#include <string>
#include <utility>
#include <vector>

namespace gluray::gl {

inline constexpr std::pair<const char*, scene::VolumeBlend> kVolumeBlends[] = {
    {"composite", scene::VolumeBlend::composite},
    {"maximum", scene::VolumeBlend::maximum},
    {"minimum", scene::VolumeBlend::minimum},
    {"average", scene::VolumeBlend::average},
    {"additive", scene::VolumeBlend::additive},
    {"isosurface", scene::VolumeBlend::isosurface},
    {"slice", scene::VolumeBlend::composite},  // of one sample
    {"refined_maximum", scene::VolumeBlend::refinedMaximum},
    {"refined_minimum", scene::VolumeBlend::refinedMinimum},
    {"attenuated_maximum", scene::VolumeBlend::attenuatedMaximum},
    {"over", scene::VolumeBlend::over},
    {"screened", scene::VolumeBlend::screened},
    {"mean", scene::VolumeBlend::mean},
    {"surface", scene::VolumeBlend::surface}};

inline constexpr std::pair<const char*, scene::VolumeChannels> kVolumeChannels[] = {
    {"one", scene::VolumeChannels::one},
    {"independent", scene::VolumeChannels::independent},
    {"color_and_opacity", scene::VolumeChannels::colorAndOpacity},
    {"colors", scene::VolumeChannels::colors},
    {"table", scene::VolumeChannels::table},
    {"labels", scene::VolumeChannels::labels}};

inline constexpr std::pair<const char*, scene::VolumeShading::Model> kVolumeLightings[] = {
    {"none", scene::VolumeShading::Model::none},
    {"viewer", scene::VolumeShading::Model::viewerReflected},
    {"viewer_halfway", scene::VolumeShading::Model::viewerHalfway},
    {"lights", scene::VolumeShading::Model::lightsReflected},
    {"lights_halfway", scene::VolumeShading::Model::lightsHalfway}};

/// Whether clip planes meet rays where FamilyVolume::textureFromCrop puts these.
inline constexpr std::pair<const char*, bool> kVolumeClipSpaces[] = {{"texture", false}, {"crop", true}};

/// Which component of what the texture returns counts.
inline constexpr std::pair<const char*, int> kVolumeComponents[] = {{"red", 0}, {"green", 1}};

/// Whether pixels get the depth of what they show, or that of the face.
inline constexpr std::pair<const char*, bool> kVolumeDepths[] = {{"face", false}, {"shown", true}};

/// Rays that end on the faces (scene::VolumeSpan). Functions are placeholders.
struct FamilyVolumeSpan {
  std::string clip, view, viewInverse;  // functions: from data space to clip and view coordinates, and back
  FamilyValue size, shift;
  bool showsDepth = false;
  std::string depthSlot;
  std::string window;            // uniform: least and greatest x, least and greatest y of pixels
  std::string windowFromPixels;  // function: only the identity is traced
  bool given() const { return !view.empty(); }
};

/// scene::VolumeLevels.
struct FamilyVolumeLevels {
  FamilyValue limits, gamma, leastMaximum, mostMinimum, attenuation, threshold, opacity;
  std::string planePoint, planeNormal;  // uniforms, followed by the number of a plane
  std::string planeFromData;            // function
  int component = 0;                    // kVolumeComponents
  std::string componentSlot;
};

/// Names are those of uniforms. Arrays have one element for each channel or light.
struct FamilyVolumeLight {
  scene::VolumeShading::Model model = scene::VolumeShading::Model::viewerReflected;  // if `diffuse` is active
  std::string modelSlot;
  std::string twoSided;                                                       // not 0: gradients have no sign
  FamilyValue materialAmbient, materialDiffuse, materialSpecular, shininess;  // arrays
  FamilyValue ambient, diffuse, specular;                                     // arrays
  // Of the models with several lights:
  FamilyValue count;         // of lights
  FamilyValue positional;    // how many of them, the first ones, are positional
  std::string isPositional;  // array in its place: not 0
  std::string direction, position, attenuation, coneAngle, exponent;  // arrays: scene::VolumeLight
  std::vector<std::string> eyeFromTexture, eyeFromGradient;  // matrices, multiplied from left to right
};

/// Names are those of uniforms. "Data space" is that of the attribute `vertex.position`.
struct FamilyVolume {
  std::string grid;         // sampler3D; empty: the family draws no volumes
  FamilyValue scale, bias;  // scene::VolumeChannel: a component for each channel
  scene::VolumeBlend blend = scene::VolumeBlend::composite;
  std::string blendSlot;  // "@group": the program's word of the group replaces `blend`; likewise below
  scene::VolumeChannels channels = scene::VolumeChannels::one;
  std::string channelsSlot;
  FamilyValue gradientChannel, weights;  // scene::Volume; a component for each channel
  // Samplers of tables, or arrays: one for each channel. Of blends that take levels, `color` is a function.
  std::string opacity, color, gradientOpacity;
  std::string table;        // sampler: of VolumeChannels::table, in place of `opacity` and `color`
  std::string depth;        // sampler: window depths of what ends rays
  FamilyValue depthTexel;   // width and height of a pixel in its coordinates
  FamilyValue depthOrigin;  // window coordinates of its lower left corner
  std::vector<std::string> textureFromData;  // matrices, multiplied from left to right
  // scene::VolumeView, in data space or, with the matrices dataFromWorld from left to right, in world space.
  // Those that are active count. Without a direction, rays come from the viewer.
  std::string viewer, viewerInWorld, directionInWorld;
  std::vector<std::string> dataFromWorld;
  std::string jitter;                 // sampler: scene::VolumeView
  FamilyValue step, lower, upper;     // scene::VolumeView
  FamilyValue cellStep, cellSpacing;  // scene::Volume; components of the spacing are above 0
  FamilyValue range, averaged;        // scene::VolumeChannel, scene::Volume
  FamilyValue colorScale, colorBias;
  FamilyVolumeLight light;
  std::string cropPlanes;                    // array of six numbers: two for each axis
  std::vector<std::string> textureFromCrop;  // matrices from their space to texture space
  std::string cropFlags;                     // array: flags of the 27 boxes, from element 1 on
  std::string clipPlanes;  // array: six times their number; for each, a point and a normal in world space
  bool clipsCropSpace = false;
  std::string clipSlot;
  std::string mask;    // sampler3D: samples where it is 0 are skipped; of VolumeChannels::labels: the labels
  std::string labels;  // sampler of their colours and opacities
  FamilyValue labelShare, labelScale, labelBias, labelCount;
  std::string contours;  // array of values of data
  FamilyValue contourCount;
  FamilyVolumeSpan span;
  FamilyVolumeLevels levels;
  std::string slicePoint, sliceNormal;  // world space: of VolumeView::slice, if they are active
  bool given() const { return !grid.empty(); }
};

}  // namespace gluray::gl
