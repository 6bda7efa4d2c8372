#include "gl/families/sent_billboard_keys.h"

namespace gluray::gl {
namespace {

bool hasKeysOfSticks(const FamilyImpostors& f) {
  return !f.end.empty() || !f.endColor.empty() || !f.caps.empty() || !f.roundCaps.empty() ||
         !f.halvesBlend.empty();
}

bool hasKeysOfSent(const FamilyImpostors& f) {
  return !f.corners.empty() || f.parallelView || f.radiusInPosition || f.radiusInObject || f.zeroScaleIsOne;
}

}  // namespace

std::string mistakeInSentBillboards(const Family& family) {
  const FamilyImpostors& f = family.impostors;
  const bool sticks = f.shape == scene::Shape::sticks;
  if (sticks && !f.sent) return "sticks need impostors.billboards = \"sent\"";
  if (sticks && f.end.empty()) return "sticks need impostors.end";
  if (!sticks && hasKeysOfSticks(f))
    return "end, end_color, caps, round_caps and halves_blend are for sticks alone";
  if (!f.sent && hasKeysOfSent(f))
    return "corners, viewer, radius_in_position, radius_in_object_space and zero_scale_is_one need "
           "impostors.billboards = \"sent\"";
  if (!f.sent) return "";
  if (f.shape != scene::Shape::spheres && !sticks)
    return "billboards = \"sent\" is for spheres and sticks only";
  if (f.corners.empty()) return "sent billboards need impostors.corners";
  if (family.eyeFromObject.empty()) return "sent billboards need transform.eye_from_object";
  if (!family.viewer.empty()) return "sent billboards have no transform.viewer";
  if (family.code.empty()) return "sent billboards need match.code";
  if (family.geometryShader || !family.clipPlanes.empty() || !family.instanceTransform.empty())
    return "sent billboards have neither geometry shaders nor clip planes nor instances";
  return "";
}

}  // namespace gluray::gl
