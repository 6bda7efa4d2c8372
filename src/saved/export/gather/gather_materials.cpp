#include "saved/export/gather/gather_materials.h"

#include "saved/export/gather/shown_textures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace gluray::saved {
namespace {

using Alpha = ExportedMaterial::Alpha;
using scene::AlphaTest;
using scene::Shading;

class Gatherer {
 public:
  Gatherer(const render::Surface& surface, const Shading& given, const scene::Snapshot& snapshot,
           const CornersPtr& corners, const Abilities& abilities, SceneParts& parts, Notes& notes)
      : surface_(surface),
        given_(given),
        snapshot_(snapshot),
        corners_(corners),
        abilities_(abilities),
        parts_(parts),
        notes_(notes) {}

  ShownSurface all() {
    gatherColors();
    gatherLook();
    gatherAlpha();
    gatherOddities();
    return std::move(out_);
  }

 private:
  const scene::Instance& instance() const { return *surface_.instance; }

  /// A texture of the surface; `map`: the program's colour map.
  struct Given {
    scene::Texture texture;
    bool map;
    size_t texels() const {
      return texture.image ? size_t(texture.image->width) * size_t(texture.image->height) : 0;
    }
  };

  std::vector<Given> givenTextures() const {
    const Shading& honest = *surface_.lighting->shading;
    const scene::FragmentShading& f = honest.fragment;
    std::vector<Given> all;
    if (scene::isProgram(honest) && f.color == scene::FragmentShading::Color::map && !f.map.empty() &&
        !f.normalColors)
      all.push_back({asMap(f.map.front()), true});
    for (const scene::Texture& texture : honest.textures) all.push_back({texture, false});
    return all;
  }

  void bake(const Given& given, ShownColors& colors) {
    colors = texturedColors(surface_, snapshot_.camera, {given.texture}, given.map, colors, corners_);
  }

  /// Colours, and the textures that they are multiplied by.
  void gatherColors() {
    ShownColors colors = shownColors(surface_, corners_, parts_, notes_);
    const std::vector<Given> textures = givenTextures();
    if (surface_.mesh->shape != scene::Shape::triangles) {
      if (!textures.empty()) notes_.insert("textures on spheres, tubes, points and lines were left out");
    } else if (!textures.empty() && !keepTexture(textures, colors)) {
      bakeAll(textures, colors);
      notes_.insert(abilities_.textures ? "textures that the format lacks were written as colours of vertices"
                                        : "textures were written as colours of vertices");
    }
    out_.material.color = colors.factor, out_.colors = std::move(colors.colors);
  }

  /// In the order of the units, whose environments may use each other's textures.
  void bakeAll(const std::vector<Given>& textures, ShownColors& colors) {
    std::vector<scene::Texture> units;
    for (const Given& given : textures)
      if (!given.map) units.push_back(given.texture);
    if (textures.front().map) bake(textures.front(), colors);
    if (!units.empty()) colors = texturedColors(surface_, snapshot_.camera, units, false, colors, corners_);
  }

  /// Makes the only texture that of the material or, if all are factors, the largest one; then the others
  /// become colours of vertices. False if that is not possible.
  bool keepTexture(const std::vector<Given>& textures, ShownColors& colors) {
    const Shading& honest = *surface_.lighting->shading;
    if (!abilities_.textures || (textures.front().map && honest.fragment.colorExponent != 1)) return false;
    if (textures.size() == 1) return addTexture(textures.front().texture, textures.front().map, colors);
    for (const Given& given : textures) {
      const auto effect = given.map ? TextureEffect() : effectOf(honest, given.texture, false);
      if (!given.texels() || !effect || !effect->keepsColor || !effect->keepsAlpha) return false;
    }
    const auto largest =
        std::max_element(textures.begin(), textures.end(),
                         [](const Given& a, const Given& b) { return a.texels() < b.texels(); });
    ShownColors others = colors;
    for (auto given = textures.begin(); given != textures.end(); ++given)
      if (given != largest) bake(*given, others);
    if (!addTexture(largest->texture, largest->map, others)) return false;
    colors = others;
    notes_.insert(
        "of several textures of a surface the largest was kept; the others were written as colours of "
        "vertices");
    return true;
  }

  /// Makes the texture the material's; false if it cannot be.
  bool addTexture(const scene::Texture& texture, bool map, ShownColors& colors) {
    if (!texture.image) return false;
    const bool opaque =
        !colors.colors ? colors.factor.a == 1 : colors.factor.a == 1 && surface_.mesh->opaqueColors;
    const std::optional<TextureEffect> effect =
        map ? TextureEffect() : effectOf(*surface_.lighting->shading, texture, opaque);
    if (!effect || (effect->keepsColor != effect->keepsAlpha && !opaque)) return false;
    Notes notes;
    std::optional<ExportedTexture> image = exportedTexture(texture, notes);
    if (!image) return false;
    const std::optional<int> coordinates = addCoordinates(texture);
    if (!coordinates) return false;
    notes_.merge(notes);
    image->texels = effect->texels;
    out_.material.base = {parts_.texture(*image), *coordinates};
    if (!effect->keepsColor) colors = {glm::vec4(1), nullptr};
    return true;
  }

  /// The index of the texture's coordinates; none if there can be none.
  std::optional<int> addCoordinates(const scene::Texture& texture) {
    std::optional<SourcePtr> source = exportedCoordinates(surface_, texture, corners_);
    if (!source) return {};
    const scene::Attribute* given = surface_.mesh->texcoordsOf(texture.unit);
    const bool plain = given && !texture.texGen.on() && texture.textureMatrix == glm::mat4(1);
    if (plain)
      source = parts_.source({given->data, corners_.get(), given->stride, (*source)->count(), kCoordinates},
                             [&] { return *source; });
    for (int k = 0; k < 2; ++k) {
      SourcePtr& slot = out_.texcoords[static_cast<size_t>(k)];
      if (!slot) slot = *source;
      if (slot == *source) return k;
    }
    return {};
  }

  void gatherLook() {
    ExportedMaterial& m = out_.material;
    m.unlit = !scene::isLit(given_);
    if (m.unlit) return;
    if (abilities_.materials == Abilities::Materials::none)
      return void(notes_.insert("materials were left out beside their colours"));
    if (given_.fragment.model == scene::FragmentShading::Model::pbr) return gatherPbr();
    const scene::Material& material = instance().materials.front().front;
    m.specular = glm::clamp(glm::vec3(material.specular), 0.0f, 1.0f), m.shininess = material.shininess;
    if (!scene::isProgram(given_)) m.emission = glm::clamp(glm::vec3(material.emission), 0.0f, 1.0f);
    // Roughness of the microfacets whose highlight is as wide (Walter et al., "Microfacet Models for
    // Refraction", 2007): alpha^2 = 2 / (shininess + 2), and glTF's roughness is the root of alpha.
    if (m.specular != glm::vec3(0)) m.roughness = std::pow(2 / (std::max(m.shininess, 0.0f) + 2), 0.25f);
    notes_.insert(
        "classic materials were approximated: highlights and ambient light differ in other programs");
  }

  void gatherPbr() {
    const scene::PbrSurface& pbr = given_.fragment.pbr;
    ExportedMaterial& m = out_.material;
    m.metallic = std::clamp(pbr.metallic, 0.0f, 1.0f), m.roughness = std::clamp(pbr.roughness, 0.0f, 1.0f);
    m.emission = glm::clamp(pbr.emissive, 0.0f, 1.0f);
    m.normalScale = pbr.normalScale, m.occlusionStrength = std::clamp(pbr.occlusionStrength, 0.0f, 1.0f);
    if (!abilities_.textures || surface_.mesh->shape != scene::Shape::triangles) return;
    m.metallicRoughness = m.occlusion = pbrTexture(pbr.material);
    m.emissionMap = pbrTexture(pbr.emission);
    m.normal = pbrTexture(pbr.normal);
    const scene::Attribute* tangents = surface_.mesh->texcoordsOf(scene::PbrSurface::kTangentUnit);
    if (!m.normal || !tangents || tangents->format == scene::Format::float1 ||
        tangents->format == scene::Format::float2)
      return;
    struct MakeTangent {
      void operator()(const glm::vec4* in, glm::vec4* out) const {
        const float length = glm::length(glm::vec3(*in));
        *out = length > 0 && std::isfinite(length) ? glm::vec4(glm::vec3(*in) / length, 1)
                                                   : glm::vec4(1, 0, 0, 1);
      }
    };
    out_.tangents = changedArray<glm::vec4, glm::vec4>(
        attributeArray(instance().mesh, *tangents, Element::float4, corners_), Element::float4,
        MakeTangent());
  }

  TextureUse pbrTexture(int index) {
    if (index < 0) return {};
    const scene::Texture& texture = given_.fragment.pbr.textures[static_cast<size_t>(index)];
    const std::optional<ExportedTexture> image = exportedTexture(texture, notes_);
    const std::optional<int> coordinates = image ? addCoordinates(texture) : std::nullopt;
    if (coordinates) return {parts_.texture(*image), *coordinates};
    notes_.insert("textures of materials that the format lacks were left out");
    return {};
  }

  void gatherAlpha() {
    ExportedMaterial& m = out_.material;
    m.doubleSided = instance().cull == scene::CullFace::none;
    const AlphaTest& test = given_.alphaTest;
    if (test.function == AlphaTest::greater || test.function == AlphaTest::greaterOrEqual) {
      m.alpha = Alpha::mask, m.cutoff = test.reference;
    } else if (test.function != AlphaTest::always) {
      notes_.insert("alpha tests that the format lacks were left out");
    }
    if (snapshot_.layers) m.alpha = Alpha::blend;
    if (snapshot_.layers && snapshot_.layers->of == scene::Layers::Of::drawn &&
        snapshot_.layers->blending.rgb.destination != scene::BlendFactor::oneMinusSourceAlpha)
      notes_.insert("unusual blending was written as that of surfaces in front of each other");
  }

  /// Notes what no format has.
  void gatherOddities() {
    const scene::FragmentShading& f = given_.fragment;
    const scene::MaterialPair& pair = instance().materials.front();
    const bool backs = scene::isProgram(given_)
                           ? f.paintsBack || f.backMaterial || f.backFactor != 1
                           : given_.lighting && given_.twoSided && pair.front.diffuse != pair.back.diffuse;
    if (backs) notes_.insert("back faces have the colours of front faces");
    if (given_.fog.mode != scene::Fog::off) notes_.insert("fog was left out");
    if (f.rim.on) notes_.insert("changes of colour towards silhouettes were left out");
    if (!f.matcap.empty()) notes_.insert("light from images of spheres was left out");
  }

  const render::Surface& surface_;
  const Shading& given_;
  const scene::Snapshot& snapshot_;
  const CornersPtr& corners_;
  const Abilities& abilities_;
  SceneParts& parts_;
  Notes& notes_;
  ShownSurface out_;
};

}  // namespace

bool ShownSurfaces::isAlike(const Shading& shading, const scene::Instance& a, const scene::Instance& b) {
  const auto generated = [](const scene::Texture& t) { return t.texGen.on(); };
  const bool byPlace = shading.fragment.normalColors ||
                       std::any_of(shading.textures.begin(), shading.textures.end(), generated);
  if (byPlace && (a.eyeFromObject != b.eyeFromObject || a.normalMatrix != b.normalMatrix)) return false;
  return a.color == b.color && a.normal == b.normal && a.materials == b.materials &&
         a.texcoord == b.texcoord && a.texcoordsAbove == b.texcoordsAbove &&
         a.triangleColors == b.triangleColors && a.triangleOffset == b.triangleOffset && a.cull == b.cull;
}

const ShownSurface& ShownSurfaces::of(const render::Surface& honest, const Shading& given,
                                      const scene::Snapshot& snapshot, const CornersPtr& corners) {
  auto& known = known_[{honest.mesh, &given}];
  constexpr size_t kLatest = 16;  // more are not compared
  for (size_t i = known.size(); i-- > 0 && known.size() - i <= kLatest;)
    if (isAlike(given, *known[i].first, *honest.instance)) return known[i].second;
  Gatherer gatherer(honest, given, snapshot, corners, abilities_, parts_, notes_);
  return known.emplace_back(honest.instance, gatherer.all()).second;
}

}  // namespace gluray::saved
