// FamilyReader: volumes.
#include "gl/families/files/family_reader.h"

namespace gluray::gl {

void FamilyReader::readVolume() {
  FamilyVolume& v = family_.volume;
  name("grid", v.grid);
  if (!v.given()) fail(here(), "volume needs grid");
  choice("blend", kVolumeBlends, v.blend, v.blendSlot);
  value("scale", v.scale), value("bias", v.bias);
  name("opacity", v.opacity), name("color", v.color), name("gradient_opacity", v.gradientOpacity);
  name("depth", v.depth), value("depth_texel", v.depthTexel), value("depth_origin", v.depthOrigin);
  names("texture_from_data", v.textureFromData), names("data_from_world", v.dataFromWorld);
  name("viewer", v.viewer), name("viewer_in_world", v.viewerInWorld),
      name("direction_in_world", v.directionInWorld);
  name("jitter", v.jitter);
  value("step", v.step), value("lower", v.lower), value("upper", v.upper);
  value("cell_step", v.cellStep), value("cell_spacing", v.cellSpacing);
  value("range", v.range), value("averaged", v.averaged);
  value("color_scale", v.colorScale), value("color_bias", v.colorBias);
  name("two_sided", v.twoSided);
  value("ambient", v.ambient), value("diffuse", v.diffuse), value("specular", v.specular),
      value("shininess", v.shininess);
  value("light_diffuse", v.lightDiffuse), value("light_specular", v.lightSpecular);
  if (v.opacity.empty() || v.color.empty() || v.textureFromData.empty() || !v.step.given())
    fail(here(), "volume needs opacity, color, texture_from_data and step");
  if (v.dataFromWorld.empty() && !(v.viewerInWorld.empty() && v.directionInWorld.empty()))
    fail(here(), "viewer_in_world and direction_in_world need data_from_world");
}

}  // namespace gluray::gl
