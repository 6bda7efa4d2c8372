// FamilyReader: which programs, their vertices and colours.
#include "gl/families/files/family_reader.h"

#include "gl/families/files/family_mistakes.h"

#include <algorithm>

namespace gluray::gl {

void FamilyReader::read(const std::vector<std::shared_ptr<const Family>>& known) {
  inherit(known);
  family_.name.clear();
  text("name", family_.name);
  if (family_.name.empty()) fail(here(), "a family needs a name");
  section("match", [&] { readMatch(); });
  if (family_.active.empty() && family_.any.empty())
    fail(here(), "family \"" + family_.name + "\" needs match.active or match.any");
  section("vertex", [&] { readVertex(); });
  section("pull", [&] { readPulling(); });
  section("instance", [&] { readInstance(); });
  section("transform", [&] { readTransform(); });
  section("normals", [&] { readNormals(); });
  section("color", [&] { readColor(); });
  section("material", [&] { readMaterial(family_.material); });
  section("back_material", [&] {
    readMaterial(family_.backMaterial);
    text("discards_invisible_in_source", family_.discardsInvisibleInSource);
  });
  section("lights", [&] { readLights(); });
  section("pbr", [&] { readPbr(); });
  section("fog", [&] { readFog(); });
  section(has("figures") ? "figures" : "impostors", [&] { readImpostors(); });  // figures: the older word
  section("clip", [&] {
    name("planes", family_.clipPlanes), name("count", family_.clipPlaneCount);
    flag("centers", family_.clipCenters);
    name("window", family_.clipWindow), name("window_from_pixels", family_.windowFromPixels);
  });
  section("depth", [&] { value("offset", family_.depthOffset), value("factor", family_.depthFactor); });
  section("edges", [&] { readEdges(); });
  section("lines", [&] { value("size", family_.lineSize); });
  section("pass", [&] { readPass(); });
  section("volume", [&] { readVolume(); });
  allKnown();
  if (const std::string mistake = mistakeIn(family_); !mistake.empty())
    fail(here(), "family \"" + family_.name + "\"" + mistake);
}

void FamilyReader::inherit(const std::vector<std::shared_ptr<const Family>>& known) {
  std::string from;
  text("inherits", from);
  if (from.empty()) return;
  const auto it = std::find_if(known.begin(), known.end(), [&](const auto& f) { return f->name == from; });
  if (it == known.end()) fail(at("inherits"), "there is no family \"" + from + "\" before this one");
  family_ = **it;
}

void FamilyReader::readMatch() {
  names("active", family_.active);
  names("any", family_.any);
  texts("source_has", family_.sourceHas);
  texts("source_lacks", family_.sourceLacks);
  readCode();
  texts("absent", family_.absent);
  texts("absent_outputs", family_.absentOutputs);
  names("ignored", family_.ignored);
  neutralValues("neutral", family_.neutral);
  decidedValues("decided", family_.decided);
  flag("strict", family_.strict);
  flag("only_lines_and_points", family_.onlySolids);
  flag("geometry_shader", family_.geometryShader);
  text("rasterise", family_.rasteriseBecause);
}

void FamilyReader::readCode() {
  texts("code", family_.code);
  if (has("code")) family_.codeAt = placeOf(at("code"));
  flag("resolve_conditions", family_.resolvesConditions);
  flag("whole_main", family_.wholeMain);
  if (family_.code == std::vector<std::string>{"any"}) family_.code.clear();
}

void FamilyReader::readVertex() {
  name("position", family_.position);
  name("normal", family_.normal);
  name("color", family_.color);
  name("texcoord", family_.texcoord);
  name("tangent", family_.tangent);
}

void FamilyReader::readPulling() {
  FamilyPulling& pull = family_.pulling;
  name("point_ids", pull.pointIds);
  name("point_offset", pull.pointOffset);
  name("first_vertex", pull.firstVertex);
  name("indexed_if", pull.indexedIf);
  name("cells", pull.cells);
  name("cells_if", pull.cellsIf);
  name("cells_offset", pull.cellsOffset);
  if (FamilyValue each; value("vertices_per_cell", each), each.given()) {
    if (each.constant.size() != 1 || each.constant[0] < 1)
      fail(at("vertices_per_cell"), "vertices_per_cell must be a number from 1 on");
    pull.verticesPerCell = static_cast<int>(each.constant[0]);
  }
  flag("lines", pull.lines);
  name("size", pull.size);
  if (!pull.given()) fail(here(), "pull needs point_ids");
}

void FamilyReader::readInstance() {
  name("transform", family_.instanceTransform);
  name("normal_matrix", family_.instanceNormal);
  name("color", family_.instanceColor);
  name("shift_and_scale", family_.instanceShift);
  flag("turns_normals", family_.instanceTurnsNormals);
  if (family_.instanceTurnsNormals && (family_.instanceTransform.empty() || !family_.instanceNormal.empty()))
    fail(here(), "turns_normals needs transform, without normal_matrix");
  if (!family_.instanceShift.empty() && !family_.instanceTransform.empty())
    fail(here(), "instances have transform or shift_and_scale, not both");
}

void FamilyReader::readTransform() {
  names("clip_from_object", family_.clipFromObject);
  names("eye_from_object", family_.eyeFromObject);
  name("viewer", family_.viewer);
  name("lines_of_sight", family_.linesOfSight);
  names("eye_again", family_.eyeAgain);
  name("normal_matrix", family_.normalMatrix);
}

void FamilyReader::readNormals() {
  choice("without", {{"refuse", Family::NoNormals::refuse}, {"triangle", Family::NoNormals::triangle}},
         family_.withoutNormals);
  flagOrName("flip_back_faces", family_.flipBackFaces, family_.flipsBackFaces);
  flag("dark_back_faces", family_.darkBackFaces);
  flag("flip_triangles", family_.flipsTriangles);
  flag("face_viewer", family_.facesViewer);
  flag("by_derivatives", family_.derivedNormals);
  using Unit = scene::FragmentShading::UnitNormals;
  choice(
      "unit",
      {{"pixels", Unit::pixels}, {"vertices", Unit::vertices}, {"both", Unit::both}, {"never", Unit::never}},
      family_.unitNormals);
  name("parallel_view", family_.parallelView);
  name("per_triangle", family_.triangleNormals);
}

void FamilyReader::readColor() {
  name("map", family_.colorMap);
  name("map_texcoord", family_.mapTexcoord);
  value("map_low", family_.mapLow), value("map_high", family_.mapHigh);
  name("per_triangle", family_.triangleColors);
  name("triangle_offset", family_.triangleOffset);
  name("uniform_instead", family_.uniformColors);
  flag("diffuse_only", family_.colorIsDiffuseOnly);
  value("exponent", family_.colorExponent), value("encoding", family_.encoding);
  flag("from_normals", family_.normalColors);
  names("matcap", family_.matcap);
  value("back_factor", family_.backFactor);
  section("rim", [&] {
    value("color", family_.rimColor), value("exponent", family_.rimExponent);
    value("opacity", family_.rimOpacity);
  });
  section("height", [&] { readHeight(); });
  value("back_faces", family_.backColor);
  name("back_faces_if", family_.backColorIf);
  flag("clamped", family_.clampedColors);
  flag("alpha", family_.colorAlpha);
  flag("opaque_only", family_.opaqueColors);
  flag("not_negative", family_.colorsFromZero);
  readTextures();
}

void FamilyReader::readHeight() {
  choice("axis", {{"x", 0}, {"y", 1}, {"z", 2}}, family_.height.axis);
  values("scale", family_.height.scale);
  values("offset", family_.height.offset);
  values("exponent", family_.height.exponent);
  if (!family_.height.given()) fail(here(), "colours by height need a scale");
}

void FamilyReader::readTextures() {
  name("texcoord_matrix", family_.texcoordMatrix);
  names("textures", family_.textures);
  name("any_texture", family_.anyTexture);
  if (!family_.anyTexture.empty() && std::ranges::count(family_.textures, family_.anyTexture) == 0)
    fail(at("any_texture"), "any_texture is none of the textures");
  name("textures_if", family_.texturesIf);
  readTextureUse();
  flag("textures_replace_alpha", family_.texturesReplaceAlpha);
  name("textures_on_back_faces", family_.texturesOnBack);
}

void FamilyReader::readTextureUse() {
  enum class Use { afterLight, beforeLight, diffuse };
  Use use = family_.texturesDiffuseOnly ? Use::diffuse
            : family_.texturesFirst     ? Use::beforeLight
                                        : Use::afterLight;
  choice("textures_apply",
         {{"after_light", Use::afterLight}, {"before_light", Use::beforeLight}, {"diffuse", Use::diffuse}},
         use);
  family_.texturesFirst = use != Use::afterLight;
  family_.texturesDiffuseOnly = use == Use::diffuse;
}

void FamilyReader::readEdges() {
  name("if", family_.edgesIf);
  name("unless", family_.edgesUnless);
  name("flags", family_.edgeFlags);
  name("flags_if", family_.edgeFlagsIf);
  name("flags_offset", family_.edgeFlagsOffset);
  value("width", family_.edgeWidth);
  value("color", family_.edgeColor);
  value("opacity", family_.edgeOpacity);
  flag("alone", family_.edgesAlone);
  choice("corners", {{"move", true}, {"stay", false}}, family_.edgesGrow);
  name("viewport", family_.edgeViewport);
}

}  // namespace gluray::gl
