// ProgramReader: physically based materials, their textures and their environment.
#include "gl/program_state/program_reader.h"

#include <algorithm>
#include <utility>

namespace gluray::gl {
Reason ProgramReader::readPbr() {
  const FamilyPbr& names = family_.pbr;
  scene::PbrSurface& pbr = out_.shading.fragment.pbr;
  pbr = {};
  out_.tangent = glm::vec3(0);
  if (!names.given()) return Reason::traced;
  pbr.masking = names.masking;
  pbr.ambient = glm::vec3(uniforms_.value(names.ambient, glm::vec4(0)));
  pbr.metallic = uniforms_.number(names.metallic, 0);
  pbr.roughness = uniforms_.number(names.roughness, 0.5f);
  pbr.baseF0 = uniforms_.number(names.baseF0, 0.04f);
  pbr.edgeTint = glm::vec3(uniforms_.value(names.edgeTint, glm::vec4(1)));
  pbr.emissive = glm::vec3(uniforms_.value(names.emissive, glm::vec4(0)));
  pbr.occlusionStrength = uniforms_.number(names.occlusionStrength, 1);
  pbr.normalScale = uniforms_.number(names.normalScale, 1);
  pbr.distributionFloor = uniforms_.number(names.distributionFloor, 0);
  const std::vector<scene::Texture>& colors = out_.shading.textures;
  if (!std::all_of(colors.begin(), colors.end(), [](const auto& t) { return t.image->normalised; }))
    return refuse("a texture has values outside 0 to 1");
  for (const auto& [name, index] :
       {std::pair{&names.materialTexture, &pbr.material}, std::pair{&names.emissiveTexture, &pbr.emission},
        std::pair{&names.normalTexture, &pbr.normal}})
    if (const Reason reason = readPbrTexture(*name, *index); reason != Reason::traced) return reason;
  if (pbr.normal >= 0 && !(program_.attribute(family_.tangent) && program_.attribute(family_.normal)))
    return refuse("it has a normal map, but lacks normals or tangents of vertices");
  if (pbr.normal >= 0) out_.tangent = glm::vec3(current(family_.tangent));
  return readEnvironment();
}

Reason ProgramReader::readPbrTexture(const std::string& name, int& index) {
  const ProgramUniform* sampler = samplerNamed(name);
  if (!sampler) return Reason::traced;
  scene::Texture texture;
  if (const Reason reason = readTexture(*sampler, texture); reason != Reason::traced) return reason;
  if (!texture.image->normalised) return refuse("a texture has values outside 0 to 1");
  std::vector<scene::Texture>& textures = out_.shading.fragment.pbr.textures;
  index = static_cast<int>(textures.size());
  textures.push_back(std::move(texture));
  return Reason::traced;
}

Reason ProgramReader::readEnvironment() {
  const FamilyPbr& names = family_.pbr;
  const ProgramUniform *prefiltered = samplerNamed(names.prefiltered), *brdf = samplerNamed(names.brdfTable);
  const ProgramUniform* irradiance = samplerNamed(names.irradiance);
  if (!prefiltered && !brdf && !irradiance) return Reason::traced;
  if (!prefiltered || !brdf) return refuse("it has only a part of its environment's images");
  scene::PbrEnvironment& environment = out_.shading.fragment.pbr.environment;
  const auto read = [&](const ProgramUniform& sampler, std::vector<scene::Texture>& out) {
    const Reason reason = textures_.bound(real_, has_, unitOf(sampler), sampler.type, out.emplace_back());
    if (reason == Reason::traced && out.back().magFilter != out.back().minFilter)
      return refuse("an image of the environment is magnified in another way than reduced");
    if (reason == Reason::traced && out.back().maxAnisotropy > 1) return Reason::textureAnisotropy;
    return reason;
  };
  environment.worldFromEye = uniforms_.matrix3(names.environmentMatrix);
  environment.maxLevel = out_.known->prefilteredMaxLevel;
  environment.intensity = uniforms_.number(names.environmentIntensity, 1);
  environment.diffuseF0 = uniforms_.number(names.multipleScattering, -1);
  if (const Reason reason = read(*brdf, environment.brdf); reason != Reason::traced) return reason;
  if (environment.brdf.front().mipFilter != scene::MipFilter::none)
    return refuse("the environment's table has several levels");
  if (irradiance) {
    if (const Reason reason = read(*irradiance, environment.irradiance); reason != Reason::traced)
      return reason;
    if (environment.irradiance.front().mipFilter != scene::MipFilter::none)
      return refuse("the irradiance of the environment has several levels");
  }
  environment.byHarmonics = !irradiance;
  for (size_t c = 0; c < names.harmonics.size() && c < 3 && !irradiance; ++c)
    for (int i = 0; i < 9; ++i) environment.harmonics[c][i] = uniforms_.number(names.harmonics[c], i);
  return read(*prefiltered, environment.prefiltered);
}

}  // namespace gluray::gl
