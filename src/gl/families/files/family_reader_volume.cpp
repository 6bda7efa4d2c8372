// FamilyReader: volumes.
#include "gl/families/files/family_reader.h"

namespace gluray::gl {

void FamilyReader::readVolumeLight(FamilyVolumeLight& light) {
  choice("lighting", kVolumeLightings, light.model, light.modelSlot);
  name("two_sided", light.twoSided);
  value("ambient", light.materialAmbient), value("diffuse", light.materialDiffuse);
  value("specular", light.materialSpecular), value("shininess", light.shininess);
  value("light_ambient", light.ambient), value("light_diffuse", light.diffuse),
      value("light_specular", light.specular);
  value("light_count", light.count), value("light_positional_count", light.positional);
  name("light_positional", light.isPositional);
  name("light_direction", light.direction), name("light_position", light.position);
  name("light_attenuation", light.attenuation);
  name("light_cone_angle", light.coneAngle), name("light_exponent", light.exponent);
  names("eye_from_texture", light.eyeFromTexture), names("eye_from_gradient", light.eyeFromGradient);
}

void FamilyReader::readVolumeSpan(FamilyVolume& volume) {
  FamilyVolumeSpan& span = volume.span;
  name("clip_from_data", span.clip), name("view_from_data", span.view);
  name("data_from_view", span.viewInverse);
  value("size", span.size), value("shift", span.shift);
  choice("depth_shown", kVolumeDepths, span.showsDepth, span.depthSlot);
  name("window", span.window), name("window_from_pixels", span.windowFromPixels);
  FamilyVolumeLevels& levels = volume.levels;
  choice("component", kVolumeComponents, levels.component, levels.componentSlot);
  value("limits", levels.limits), value("gamma", levels.gamma), value("threshold", levels.threshold);
  value("least_maximum", levels.leastMaximum), value("most_minimum", levels.mostMinimum);
  value("attenuation", levels.attenuation), value("opacity_factor", levels.opacity);
  name("plane_point", levels.planePoint), name("plane_normal", levels.planeNormal);
  name("plane_from_data", levels.planeFromData);
  if (!span.given()) return;
  if (span.clip.empty() || span.viewInverse.empty() || !span.size.given() || !volume.step.given() ||
      volume.color.empty())
    fail(here(), "view_from_data needs clip_from_data, data_from_view, size, step and color");
  for (const std::string* function : {&span.clip, &span.view, &span.viewInverse, &volume.color})
    if (!isPlaceholder(*function)) fail(here(), "\"" + *function + "\" is no placeholder of a function");
}

void FamilyReader::readVolume() {
  FamilyVolume& v = family_.volume;
  name("grid", v.grid);
  if (!v.given()) fail(here(), "volume needs grid");
  choice("blend", kVolumeBlends, v.blend, v.blendSlot);
  choice("channels", kVolumeChannels, v.channels, v.channelsSlot);
  value("gradient_channel", v.gradientChannel), value("weights", v.weights);
  value("scale", v.scale), value("bias", v.bias);
  name("opacity", v.opacity), name("color", v.color), name("gradient_opacity", v.gradientOpacity);
  name("table", v.table);
  name("depth", v.depth), value("depth_texel", v.depthTexel), value("depth_origin", v.depthOrigin);
  names("texture_from_data", v.textureFromData), names("data_from_world", v.dataFromWorld);
  name("viewer", v.viewer), name("viewer_in_world", v.viewerInWorld),
      name("direction_in_world", v.directionInWorld);
  name("jitter", v.jitter);
  value("step", v.step), value("lower", v.lower), value("upper", v.upper);
  value("cell_step", v.cellStep), value("cell_spacing", v.cellSpacing);
  value("range", v.range), value("averaged", v.averaged);
  value("color_scale", v.colorScale), value("color_bias", v.colorBias);
  name("crop_planes", v.cropPlanes), name("crop_flags", v.cropFlags),
      names("texture_from_crop", v.textureFromCrop);
  name("clip_planes", v.clipPlanes);
  choice("clip_space", kVolumeClipSpaces, v.clipsCropSpace, v.clipSlot);
  name("mask", v.mask), name("labels", v.labels), value("label_share", v.labelShare);
  value("label_scale", v.labelScale), value("label_bias", v.labelBias), value("label_count", v.labelCount);
  name("contours", v.contours), value("contour_count", v.contourCount);
  name("slice_point", v.slicePoint), name("slice_normal", v.sliceNormal);
  readVolumeLight(v.light);
  readVolumeSpan(v);
  if (v.span.given()) return;
  if (v.opacity.empty() || v.color.empty() || v.textureFromData.empty() || !v.step.given())
    fail(here(), "volume needs opacity, color, texture_from_data and step");
  if (v.table.empty() && v.channels == scene::VolumeChannels::table)
    fail(here(), "channels = \"table\" needs table");
  if ((v.labels.empty() || v.mask.empty()) && v.channels == scene::VolumeChannels::labels)
    fail(here(), "channels = \"labels\" needs mask and labels");
  if (v.dataFromWorld.empty() && !(v.viewerInWorld.empty() && v.directionInWorld.empty()))
    fail(here(), "viewer_in_world and direction_in_world need data_from_world");
  if (v.dataFromWorld.empty() && !(v.clipPlanes.empty() && v.slicePoint.empty()))
    fail(here(), "clip_planes and slice_point need data_from_world");
  if (v.cropPlanes.empty() != v.cropFlags.empty() || (v.textureFromCrop.empty() && !v.cropPlanes.empty()))
    fail(here(), "crop_planes, crop_flags and texture_from_crop need each other");
  if (v.slicePoint.empty() != v.sliceNormal.empty())
    fail(here(), "slice_point and slice_normal need each other");
  if (v.textureFromCrop.empty() && !v.slicePoint.empty()) fail(here(), "slice_point needs texture_from_crop");
}

}  // namespace gluray::gl
