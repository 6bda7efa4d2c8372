#include "gl/families/files/family_mistakes.h"

#include "gl/glsl/built_in_variables.h"

namespace gluray::gl {
namespace {

bool hasKeysOfSticks(const FamilyImpostors& f) {
  return !f.end.empty() || !f.endColor.empty() || !f.caps.empty() || !f.roundCaps.empty() ||
         !f.halvesBlend.empty();
}

bool hasKeysOfSent(const FamilyImpostors& f) {
  return !f.corners.empty() || f.parallelView || f.radiusInPosition || f.radiusInCorners ||
         f.radiusInObject || f.zeroScaleIsOne || f.hemispheres;
}

std::string mistakeInSentBillboards(const Family& family) {
  const FamilyImpostors& f = family.impostors;
  const bool sticks = f.shape == scene::Shape::sticks;
  if (sticks && !f.sent) return "sticks need impostors.billboards = \"sent\"";
  if (sticks && f.end.empty()) return "sticks need impostors.end";
  if (!sticks && hasKeysOfSticks(f))
    return "end, end_color, caps, round_caps and halves_blend are for sticks alone";
  if (!f.sent && hasKeysOfSent(f))
    return "corners, viewer, hemispheres, radius_in_position, radius_in_corners, radius_in_object_space and "
           "zero_scale_is_one need impostors.billboards = \"sent\"";
  if (!f.sent) return "";
  if (f.shape != scene::Shape::spheres && !sticks)
    return "billboards = \"sent\" is for spheres and sticks only";
  if (sticks && (f.hemispheres || f.radiusInCorners))
    return "hemispheres and radius_in_corners are for spheres alone";
  if (f.hemispheres && f.parallelView) return "hemispheres have no impostors.viewer";
  if (f.radiusInCorners && (f.radiusInPosition || f.radius.given()))
    return "radius_in_corners replaces radius and radius_in_position";
  if (f.corners.empty()) return "sent billboards need impostors.corners";
  if (family.eyeFromObject.empty()) return "sent billboards need transform.eye_from_object";
  if (!family.viewer.empty()) return "sent billboards have no transform.viewer";
  if (family.code.empty()) return "sent billboards need match.code";
  if (family.geometryShader || !family.clipPlanes.empty() || !family.instanceTransform.empty())
    return "sent billboards have neither geometry shaders nor clip planes nor instances";
  return "";
}

std::string mistakeInLines(const Family& family) {
  if (!family.lineSize.given()) return "";
  return family.onlySolids ? "" : "lines.size needs match.only_lines_and_points";
}

/// Built-in variables must be known ones, in a program whose statements are compared.
std::string mistakeInBuiltIns(const Family& family) {
  for (const std::string& name : family.mentioned)
    if (isBuiltIn(name) && !isBuiltInAttribute(name) && builtInUniformType(name) == 0)
      return "unknown built-in variable " + name;
  if (family.hasBuiltInVertices() && family.code.empty()) return "programs with gl_Vertex need match.code";
  if (family.hasBuiltInVertices() &&
      (family.impostors.given() || family.pass != Family::Pass::none || !family.colorMap.empty()))
    return "programs with gl_Vertex have neither impostors nor passes nor colour maps";
  if (family.hasBuiltInVertices() && !family.textures.empty() && family.texcoord != "gl_MultiTexCoord0")
    return "textures of programs with gl_Vertex need vertex.texcoord = \"gl_MultiTexCoord0\"";
  if (family.material.emission.given() && !family.color.empty())
    return "emission_color is for families without vertex.color";
  return "";
}

std::string mistakeInLook(const Family& family) {
  const std::string& colors = family.color.empty() ? family.instanceColor : family.color;
  if (family.fog.given() && (family.eyeFromObject.empty() || !family.viewer.empty()))
    return "fog needs transform.eye_from_object, without transform.viewer";
  if (family.fog.absolute && !family.hasBuiltInVertices())
    return "fog.distance is for programs with gl_Vertex";
  if (family.lights.clamped && (colors.empty() || family.colorIsDiffuseOnly))
    return "lights.clamped needs vertex.color, without color.diffuse_only";
  if (!family.lights.enabled.empty() && colors.empty() && !family.lights.unlitIsMaterial)
    return "lights.enabled needs vertex.color, or lights.unlit_shows = \"ambient_and_diffuse\"";
  if (!family.lights.countInSource.empty() && family.code.empty())
    return "lights.count_in_source needs match.code";
  if (!family.lights.noHighlightInSource.empty() && family.lights.countInSource.empty())
    return "lights.no_highlight_in_source needs lights.count_in_source";
  if (!(family.material.unusedOpacityInSource.empty() && family.pbr.prefilteredMaxLevelInSource.empty()) &&
      family.code.empty())
    return "unused_opacity_in_source and prefiltered_max_level_in_source need match.code";
  if (!family.discardsInvisibleInSource.empty() && (family.code.empty() || family.hasBuiltInVertices()))
    return "discards_invisible_in_source needs match.code, and is not for programs with gl_Vertex";
  if (!family.pbr.normalTexture.empty() && family.tangent.empty())
    return "pbr.normal_texture needs vertex.tangent";
  if (family.pbr.prefiltered.empty() != family.pbr.brdfTable.empty())
    return "pbr.prefiltered and pbr.brdf_table need each other";
  if (!family.backColorIf.empty() && !family.backColor.given())
    return "color.back_faces_if needs color.back_faces";
  if (family.backColor.given() && family.impostors.given()) return "impostors have no color.back_faces";
  if (family.textures.empty() && (family.texturesFirst || !family.texturesIf.empty()))
    return "color.textures_if and color.textures_apply need color.textures";
  if (!family.matcap.empty() && family.matcap.size() != 4) return "color.matcap needs four samplers";
  const bool unlit = family.model == Family::Model::unlit;
  if (!unlit && (!family.matcap.empty() || family.backFactor.given()))
    return "color.matcap and color.back_factor are for the model unlit";
  if (family.unitNormals == scene::FragmentShading::UnitNormals::never && !family.normalColors)
    return "normals.unit = \"never\" is for color.from_normals";
  if (family.lights.highlightIntensity.given() &&
      (family.lights.color.empty() || !family.lights.specularColor.empty()))
    return "lights.highlight_intensity needs lights.color, without lights.specular_color";
  if (!family.lights.positionMatrix.empty() && family.lights.position.empty())
    return "lights.position_matrix needs lights.position";
  const bool separate = family.pbr.masking == scene::PbrSurface::Masking::separate;
  if (separate
          ? !(family.pbr.materialTexture.empty() && family.pbr.emissiveTexture.empty() &&
              family.pbr.normalTexture.empty() && family.pbr.prefiltered.empty() && family.textures.empty())
          : family.pbr.ambient.given())
    return "pbr.masking = \"separate\", and no other, has pbr.ambient, and it has no textures";
  if (family.encoding.given() && family.model != Family::Model::unlit)
    return "color.encoding is for the model unlit";
  if (family.lights.highlightColor != FamilyLights::HighlightColor::material &&
      (colors.empty() || family.model != Family::Model::phong || !family.lights.specularColor.empty()))
    return "lights.highlight_color needs vertex.color and the model phong, without lights.specular_color";
  const bool phong = family.model == Family::Model::phong;
  if (!phong &&
      (family.lights.clamped || family.lights.infiniteViewer || family.lights.viewerAtVertices ||
       family.lights.highlightsNeedShininess || family.darkBackFaces || family.lights.halfVector.given()))
    return "lights.clamped, lights.viewer, lights.half_vector, lights.highlights_need_shininess and "
           "normals.dark_back_faces are for the model phong";
  return "";
}

std::string mistakeInPulling(const Family& family) {
  const FamilyPulling& pull = family.pulling;
  if (!family.decided.empty() && family.code.empty() && family.rasteriseBecause.empty())
    return "match.decided needs match.code";
  if (!pull.given()) return "";
  if (family.code.empty() && family.rasteriseBecause.empty()) return "pulled vertices need match.code";
  if (family.impostors.given() && !scene::isSizedInPixels(family.impostors.shape))
    return "impostors of pulled vertices are beads or tubes";
  if (family.hasBuiltInVertices() || family.geometryShader || !family.tangent.empty() ||
      !family.instanceTransform.empty() || !family.instanceShift.empty() || !family.instanceColor.empty())
    return "pulled vertices have neither gl_Vertex nor geometry shaders, tangents and instances";
  if (pull.cellsIf.empty() != pull.cells.empty()) return "pull.cells and pull.cells_if need each other";
  return "";
}

std::string mistakeInVolume(const Family& family) {
  return family.volume.given() && family.code.empty() ? "volumes need match.code" : "";
}

/// Functions are those of known code; they give the viewer of lights without a position.
std::string mistakeInFunctions(const Family& family) {
  const bool sight = !family.linesOfSight.empty();
  if (sight && (family.code.empty() || family.eyeFromObject.empty() || !family.viewer.empty()))
    return "transform.lines_of_sight needs match.code and transform.eye_from_object, without "
           "transform.viewer";
  if (sight && (!family.lights.position.empty() || family.lights.halfVector.given() || family.fog.given() ||
                family.impostors.given() || family.model == Family::Model::pbr))
    return "transform.lines_of_sight is for surfaces whose lights have directions";
  if (!family.eyeAgain.empty() && family.eyeFromObject.empty())
    return "transform.eye_again needs transform.eye_from_object";
  if (family.derivedNormals && (family.eyeFromObject.empty() || !family.normal.empty()))
    return "normals.by_derivatives needs transform.eye_from_object, without vertex.normal";
  if (family.windowFromPixels.empty() != family.clipWindow.empty())
    return "clip.window and clip.window_from_pixels need each other";
  return "";
}

std::string mistakeInVertexNormals(const Family& family) {
  const bool asked = family.unitNormals != scene::FragmentShading::UnitNormals::pixels ||
                     family.normalColors || family.hasRim() || family.facesViewer;
  const bool others = family.impostors.given() || !family.triangleNormals.empty() ||
                      family.withoutNormals == Family::NoNormals::triangle || family.normal.empty();
  return asked && others ? "normals.unit, normals.face_viewer, color.from_normals and color.rim are for "
                           "vertex normals alone"
                         : "";
}

std::string mistakeInImpostors(const Family& family) {
  const FamilyImpostors& f = family.impostors;
  if (f.given() && !family.clipPlanes.empty() && !family.clipCenters)
    return "impostors need clip.centers = true with clip.planes";
  if (f.given() && !(family.textures.empty() && family.edgeFlags.empty()))
    return "impostors have neither textures nor edges";
  if (scene::isInWindow(f.shape) && (family.depthOffset.given() || family.depthFactor.given()))
    return "beads, tubes and splats have impostors.depth_bias instead of depth";
  const bool trianglesOfDiscs =
      f.shape == scene::Shape::discs && f.billboards == scene::Impostors::Billboards::triangle;
  if (f.gaussian && (f.fades || !(trianglesOfDiscs || f.shape == scene::Shape::splats)))
    return "impostors.gaussian is for splats, and discs on triangles, without impostors.fades";
  const bool splats = f.shape == scene::Shape::splats;
  if (f.antialiased && (!splats || f.fades || f.gaussian))
    return "impostors.antialiased is for splats, without impostors.fades and impostors.gaussian";
  if (f.outline.given() && !f.antialiased) return "impostors.outline is for impostors.antialiased";
  if (f.instances && (!splats || family.geometryShader))
    return "impostors.instances is for splats without a geometry shader";
  if ((f.shape == scene::Shape::splats || f.sent) == f.projection.empty())
    return "splats and sent billboards, and only these, need impostors.projection";
  return mistakeInSentBillboards(family);
}

/// The name of a required key that is missing; empty if none is.
std::string missingKey(const Family& family) {
  const FamilyImpostors& f = family.impostors;
  const bool traced = family.rasteriseBecause.empty();
  const bool placed = !family.clipFromObject.empty() || family.volume.span.given();
  if (traced && (family.position.empty() || !placed))
    return "vertex.position and transform.clip_from_object, or match.rasterise";
  if (f.given() && !scene::isSizedInPixels(f.shape) && !f.radius.given() && !f.radiusInPosition &&
      !f.radiusInCorners)
    return "impostors.radius";
  return f.shape == scene::Shape::cylinders && f.axis.empty() ? "impostors.axis" : "";
}

}  // namespace

std::string mistakeIn(const Family& family) {
  if (const std::string key = missingKey(family); !key.empty()) return " needs " + key;
  for (const auto& look : {mistakeInBuiltIns, mistakeInPulling, mistakeInVolume, mistakeInFunctions,
                           mistakeInVertexNormals, mistakeInLook, mistakeInImpostors, mistakeInLines})
    if (const std::string mistake = look(family); !mistake.empty()) return ": " + mistake;
  return "";
}

}  // namespace gluray::gl
