// Parses family files: TOML to Family.
#include "base/toml_text.h"
#include "gl/families/code_sections.h"
#include "gl/families/family.h"
#include "gl/families/family_mistakes.h"
#include "gl/families/family_table.h"

#include <algorithm>

namespace gluray::gl {
namespace {

/// Reads one [[family]] table. Keys that it does not read are mistakes.
class FamilyReader : FamilyTable {
 public:
  FamilyReader(const toml::table& table, const std::string& file, Family& family)
      : FamilyTable(table, file, family.mentioned, family.alternatives), family_(family) {}

  /// `known`: the families that it may inherit from.
  void read(const std::vector<std::shared_ptr<const Family>>& known) {
    inherit(known);
    family_.name.clear();
    text("name", family_.name);
    if (family_.name.empty()) fail(here(), "a family needs a name");
    section("match", [&] { readMatch(); });
    if (family_.active.empty() && family_.any.empty())
      fail(here(), "family \"" + family_.name + "\" needs match.active or match.any");
    section("vertex", [&] { readVertex(); });
    section("instance", [&] {
      name("transform", family_.instanceTransform);
      name("normal_matrix", family_.instanceNormal);
      name("color", family_.instanceColor);
      name("shift_and_scale", family_.instanceShift);
      if (!family_.instanceShift.empty() && !family_.instanceTransform.empty())
        fail(here(), "instances have transform or shift_and_scale, not both");
    });
    section("transform", [&] { readTransform(); });
    section("normals", [&] { readNormals(); });
    section("color", [&] { readColor(); });
    section("material", [&] { readMaterial(family_.material); });
    section("back_material", [&] { readMaterial(family_.backMaterial); });
    section("lights", [&] { readLights(); });
    section("pbr", [&] { readPbr(); });
    section("fog", [&] { readFog(); });
    section(has("figures") ? "figures" : "impostors", [&] { readImpostors(); });  // figures: the older word
    section("clip", [&] {
      name("planes", family_.clipPlanes), name("count", family_.clipPlaneCount);
      flag("centers", family_.clipCenters);
    });
    section("depth", [&] { value("offset", family_.depthOffset), value("factor", family_.depthFactor); });
    section("edges", [&] {
      name("flags", family_.edgeFlags);
      value("width", family_.edgeWidth);
      value("color", family_.edgeColor);
      value("opacity", family_.edgeOpacity);
      choice("corners", {{"move", true}, {"stay", false}}, family_.edgesGrow);
      name("viewport", family_.edgeViewport);
    });
    section("pass", [&] { readPass(); });
    allKnown();
    if (const std::string mistake = mistakeIn(family_); !mistake.empty())
      fail(here(), "family \"" + family_.name + "\"" + mistake);
  }

 private:
  /// Starts with a copy of the inherited family, if any.
  void inherit(const std::vector<std::shared_ptr<const Family>>& known) {
    std::string from;
    text("inherits", from);
    if (from.empty()) return;
    const auto it = std::find_if(known.begin(), known.end(), [&](const auto& f) { return f->name == from; });
    if (it == known.end()) fail(at("inherits"), "there is no family \"" + from + "\" before this one");
    family_ = **it;
  }
  void readMatch() {
    names("active", family_.active);
    names("any", family_.any);
    texts("source_has", family_.sourceHas);
    texts("source_lacks", family_.sourceLacks);
    readCode();
    texts("absent", family_.absent);
    texts("absent_outputs", family_.absentOutputs);
    names("ignored", family_.ignored);
    neutralValues("neutral", family_.neutral);
    flag("strict", family_.strict);
    flag("only_lines_and_points", family_.onlySolids);
    flag("geometry_shader", family_.geometryShader);
    text("rasterise", family_.rasteriseBecause);
  }
  /// code = "any": programs of the family may have any statements.
  void readCode() {
    texts("code", family_.code);
    if (has("code")) family_.codeAt = placeOf(at("code"));
    flag("resolve_conditions", family_.resolvesConditions);
    if (family_.code == std::vector<std::string>{"any"}) family_.code.clear();
  }
  void readVertex() {
    name("position", family_.position);
    name("normal", family_.normal);
    name("color", family_.color);
    name("texcoord", family_.texcoord);
  }
  void readTransform() {
    names("clip_from_object", family_.clipFromObject);
    names("eye_from_object", family_.eyeFromObject);
    name("viewer", family_.viewer);
    name("normal_matrix", family_.normalMatrix);
  }
  void readNormals() {
    choice("without", {{"refuse", Family::NoNormals::refuse}, {"triangle", Family::NoNormals::triangle}},
           family_.withoutNormals);
    flagOrName("flip_back_faces", family_.flipBackFaces, family_.flipsBackFaces);
    flag("dark_back_faces", family_.darkBackFaces);
    using Unit = scene::FragmentShading::UnitNormals;
    choice("unit", {{"pixels", Unit::pixels}, {"vertices", Unit::vertices}, {"both", Unit::both}},
           family_.unitNormals);
    name("parallel_view", family_.parallelView);
    name("per_triangle", family_.triangleNormals);
  }
  void readColor() {
    name("map", family_.colorMap);
    name("map_texcoord", family_.mapTexcoord);
    name("texcoord_matrix", family_.texcoordMatrix);
    name("per_triangle", family_.triangleColors);
    name("triangle_offset", family_.triangleOffset);
    name("uniform_instead", family_.uniformColors);
    flag("diffuse_only", family_.colorIsDiffuseOnly);
    flag("from_normals", family_.normalColors);
    section("rim", [&] { value("color", family_.rimColor), value("exponent", family_.rimExponent); });
    section("height", [&] {
      choice("axis", {{"x", 0}, {"y", 1}, {"z", 2}}, family_.height.axis);
      values("scale", family_.height.scale);
      values("offset", family_.height.offset);
      values("exponent", family_.height.exponent);
      if (!family_.height.given()) fail(here(), "colours by height need a scale");
    });
    flag("clamped", family_.clampedColors);
    flag("opaque_only", family_.opaqueColors);
    names("textures", family_.textures);
    name("any_texture", family_.anyTexture);
    if (!family_.anyTexture.empty() && std::ranges::count(family_.textures, family_.anyTexture) == 0)
      fail(at("any_texture"), "any_texture is none of the textures");
    name("textures_on_back_faces", family_.texturesOnBack);
  }
  void readMaterial(FamilyMaterial& m) {
    value("ambient_intensity", m.ambientIntensity);
    value("ambient_color", m.ambientColor);
    value("diffuse_intensity", m.diffuseIntensity);
    value("diffuse_color", m.diffuseColor);
    value("specular_intensity", m.specularIntensity);
    value("specular_color", m.specularColor);
    value("emission_color", m.emission);
    value("shininess", m.shininess);
    value("opacity", m.opacity);
  }
  void readLights() {
    choice("model",
           {{"unlit", Family::Model::unlit}, {"phong", Family::Model::phong}, {"pbr", Family::Model::pbr}},
           family_.model);
    choice("specular", {{"reflect", Family::Specular::reflect}, {"half", Family::Specular::half}},
           family_.specular);
    FamilyLights& l = family_.lights;
    texts("names", l.names);
    name("count", l.count);
    text("count_in_source", l.countInSource);
    name("enabled", l.enabled);
    name("color", l.color);
    value("direction", l.direction);
    flag("direction_towards_light", l.towardsLight);
    choice("headlight",
           {{"infinite", FamilyLights::Headlight::infinite}, {"viewer", FamilyLights::Headlight::viewer}},
           l.headlight);
    flag("two_sided", l.twoSided);
    choice("highlights", {{"lit", false}, {"everywhere", true}}, l.highlightsInDark);
    lightValues("specular_color", l.specularColor);
    lightValues("shininess", l.shininess);
    choice("viewer", {{"here", false}, {"infinite", true}}, l.infiniteViewer);
    flag("clamped", l.clamped);
    name("position", l.position);
    name("positional", l.positional);
    name("attenuation", l.attenuation);
    name("cone_angle", l.coneAngle);
    name("exponent", l.exponent);
    mentionNamedLights();
  }
  void readImpostors() {
    using scene::Shape;
    using Billboards = scene::Impostors::Billboards;
    FamilyImpostors& f = family_.impostors;
    choice("shape",
           {{"spheres", Shape::spheres},
            {"discs", Shape::discs},
            {"cylinders", Shape::cylinders},
            {"beads", Shape::beads},
            {"tubes", Shape::tubes},
            {"splats", Shape::splats},
            {"sticks", Shape::sticks}},
           f.shape);
    if (!f.given()) fail(here(), "impostors need a shape");
    const char* const billboards = has("cards") ? "cards" : "billboards";  // cards: the older word
    choice(billboards,
           {{"silhouette", Billboards::silhouette},
            {"triangle", Billboards::triangle},
            {"faces", Billboards::faces},
            {"sent", Billboards::square}},
           f.billboards);
    f.sent = f.billboards == Billboards::square;
    if ((f.billboards == Billboards::faces) && f.shape != Shape::cylinders)
      fail(at(billboards), "billboards = \"faces\" is for cylinders only");
    if (f.billboards == Billboards::triangle && f.shape == Shape::cylinders)
      fail(at(billboards), "billboards = \"triangle\" is not for cylinders");
    value("radius", f.radius);
    name("axis", f.axis);
    value("inside", f.inside);
    value("radius_divisor", f.radiusDivisor);
    flag("fades", f.fades);
    flag("grows", f.grows);
    value("size", f.size);
    value("bulge", f.bulge);
    value("bulge_depth", f.bulgeDepth);
    value("depth_bias", f.depthBias);
    value("scale", f.scale);
    value(has("card_scale") ? "card_scale" : "billboard_scale", f.billboardScale);
    name("projection", f.projection);
    readSentBillboards(f);
    const bool pixels = scene::isSizedInPixels(f.shape);
    if (pixels && !(f.bulge.given() && f.bulgeDepth.given()))
      fail(here(), "beads and tubes need bulge and bulge_depth");
    if (f.size.given() != (f.shape == Shape::tubes)) fail(here(), "tubes, and only tubes, need size");
  }
  void readSentBillboards(FamilyImpostors& f) {
    name("corners", f.corners);
    choice("viewer", {{"origin", false}, {"infinite", true}}, f.parallelView);
    flag("radius_in_position", f.radiusInPosition);
    flag("radius_in_object_space", f.radiusInObject);
    flag("zero_scale_is_one", f.zeroScaleIsOne);
    name("end", f.end);
    name("end_color", f.endColor);
    name("caps", f.caps);
    name("round_caps", f.roundCaps);
    eachValue("halves_blend", f.halvesBlend);
  }
  void readPass() {
    choice("does",
           {{"fxaa", Family::Pass::fxaa},
            {"peel_depths", Family::Pass::peelDepths},
            {"peel", Family::Pass::peel},
            {"peel_rest", Family::Pass::peelRest},
            {"sum", Family::Pass::sum},
            {"resolve", Family::Pass::resolve}},
           family_.pass);
    name("input", family_.passInput);
    text("output", family_.passOutput);
    value("samples", family_.passSamples);
    value("gamma", family_.passGamma);
    value("relative_contrast", family_.relativeContrast);
    value("hard_contrast", family_.hardContrast);
    value("subpixel_blend_limit", family_.subpixelBlendLimit);
    value("subpixel_contrast", family_.subpixelContrast);
    value("endpoint_search_iterations", family_.endpointSearchIterations);
  }
  void readPbr() {
    FamilyPbr& p = family_.pbr;
    value("metallic", p.metallic);
    value("roughness", p.roughness);
    value("base_f0", p.baseF0);
    value("edge_tint", p.edgeTint);
    value("emissive", p.emissive);
  }

  /// Mentions the variables of lights with names.
  void mentionNamedLights() {
    const FamilyLights& l = family_.lights;
    std::vector<std::string> patterns = {l.color,       l.direction.uniform, l.position, l.positional,
                                         l.attenuation, l.coneAngle,         l.exponent};
    for (const auto* values : {&l.specularColor, &l.shininess})
      for (const FamilyValue& value : *values) patterns.push_back(value.uniform);
    for (const std::string& pattern : patterns)
      for (size_t i = 0; i < l.names.size(); ++i) mention(ofLight(pattern, l, static_cast<int>(i)));
  }
  void readFog() {
    using Fog = scene::Fog;
    FamilyFog& f = family_.fog;
    choice("mode", {{"linear", Fog::linear}, {"exp", Fog::exp}, {"exp2", Fog::exp2}}, f.mode);
    value("color", f.color), value("start", f.start), value("end", f.end), value("scale", f.scale);
    value("density", f.density);
    flag("extrapolated", f.extrapolated);
    if (!f.given()) fail(here(), "fog needs a color");
    const bool linear = f.mode == Fog::linear;
    if (linear && !(f.end.given() && f.start.given() != f.scale.given()))
      fail(here(), "linear fog needs end, and start or scale");
    if (linear == f.density.given()) fail(here(), "exponential fog, and no other, needs density");
    if (!linear && (f.start.given() || f.end.given() || f.scale.given() || f.extrapolated))
      fail(here(), "start, end, scale and extrapolated are for linear fog");
  }

  Family& family_;
};

}  // namespace

std::string ofLight(const std::string& pattern, const FamilyLights& lights, int number) {
  const size_t at = pattern.find("{}");
  if (at == std::string::npos) return pattern;
  const auto i = static_cast<size_t>(number);
  const std::string name = lights.names.empty()      ? std::to_string(number)
                           : i < lights.names.size() ? lights.names[i]
                                                     : "";
  return pattern.substr(0, at) + name + pattern.substr(at + 2);
}

bool Family::hasBuiltInVertices() const { return position == "gl_Vertex"; }

bool Family::mentions(std::string_view name) const {
  if (mentioned.contains(name)) return true;
  // "lightColor12" is mentioned as "lightColor{}".
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  for (size_t digit = 0, end = 0; digit < name.size(); digit = end + 1) {
    digit = std::min(name.find_first_of("0123456789", digit), name.size());
    for (end = digit; end < name.size() && isDigit(name[end]);) ++end;
    std::string pattern(name.substr(0, digit));
    pattern += "{}";
    pattern += name.substr(end);
    if (end > digit && mentioned.contains(pattern)) return true;
  }
  return false;
}

namespace {

[[noreturn]] void fail(const toml::node& at, const std::string& file, const std::string& what) {
  throw FamilyError(file + ":" + std::to_string(at.source().begin.line) + ": " + what);
}

/// Reads one [[family]] or [[code]] section into `list`.
void readSection(std::string_view key, const toml::table& table, const std::string& file, FamilyList& list) {
  if (key == "code") return readCode(table, file, list.code);
  auto family = std::make_shared<Family>();
  FamilyReader(table, file, *family).read(list.families);
  list.families.push_back(std::move(family));
}

}  // namespace

FamilyList parseFamilies(std::string_view text, const std::string& file) {
  FamilyList list;
  toml::table root;
  try {
    root = parseToml(text, file);
  } catch (const toml::parse_error& e) {
    throw FamilyError(file + ":" + std::to_string(e.source().begin.line) + ": " +
                      std::string(e.description()));
  }
  for (const auto& [key, node] : root) {
    const toml::array* sections = node.as_array();
    if (!sections || (key != "family" && key != "code"))
      fail(node, file, "only [[family]] and [[code]] sections are expected here");
    for (const toml::node& section : *sections) {
      if (!section.is_table()) fail(section, file, std::string(key) + " must be a section");
      readSection(key, *section.as_table(), file, list);
    }
  }
  return list;
}

}  // namespace gluray::gl
