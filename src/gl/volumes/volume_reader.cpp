#include "gl/volumes/volume_reader.h"

#include "gl/basics/affine.h"
#include "gl/real/clip_depths.h"

#include <cmath>
#include <utility>

namespace gluray::gl {

VolumeReader::VolumeReader(ShadowState& shadow)
    : shadow_(shadow),
      program_(shadow.program()),
      family_(program_.known->family->volume),
      uniforms_(program_.known->program, *program_.uniforms, program_.known->placeholders) {}

GLint VolumeReader::unitOf(const std::string& sampler) const {
  return uniforms_.has(sampler) ? uniforms_.integer(sampler) : -1;
}

bool VolumeReader::readGrid(scene::Volume& volume) {
  const GLint unit = unitOf(family_.grid);
  if (unit < 0) return refuse("sampler \"" + family_.grid + "\" is not active");
  scene::Texture sampling;
  volume.grid = shadow_.textures.voxels(shadow_.real, shadow_.rare(), unit, sampling, why_);
  if (!volume.grid) return false;
  using scene::Wrap;
  for (const Wrap wrap : {sampling.wrapS, sampling.wrapT, sampling.wrapR})
    if (wrap != Wrap::clampToEdge) return refuse("the texture of its voxels is not clamped to its edge");
  volume.linear = sampling.magFilter == scene::Filter::linear;
  volume.byteFilter = sampling.byteFilter && volume.grid->type == scene::VoxelGrid::Type::byte;
  volume.scale = value(family_.scale, glm::vec4(1)).x, volume.bias = value(family_.bias, glm::vec4(0)).x;
  return true;
}

bool VolumeReader::readTable(const std::string& sampler, int channels, scene::VolumeTable& table) {
  const GLint unit = unitOf(sampler);
  if (unit < 0) return refuse("sampler \"" + sampler + "\" is not active");
  scene::Texture texture;
  if (shadow_.textures.bound(shadow_.real, shadow_.rare(), unit, GL_SAMPLER_2D, texture) != Reason::traced ||
      !texture.image)
    return refuse("the texture of \"" + sampler + "\" is not traced");
  const scene::TextureImage& image = *texture.image;
  const bool plain = image.height == 1 && texture.wrapS == scene::Wrap::clampToEdge &&
                     texture.magFilter == texture.minFilter && texture.mipFilter == scene::MipFilter::none;
  if (!plain || image.floats.empty())
    return refuse("the table of \"" + sampler + "\" is no row of floats, clamped to its edge");
  table.channels = channels, table.linear = texture.magFilter == scene::Filter::linear;
  table.values.clear();
  for (const glm::vec4& texel : image.floats)
    for (int c = 0; c < channels; ++c) table.values.push_back(texel[c]);
  return true;
}

bool VolumeReader::readTables(scene::Volume& volume) {
  if (!readTable(family_.opacity, 1, volume.opacity)) return false;
  if (uniforms_.has(family_.color) && !readTable(family_.color, 3, volume.color)) return false;
  if (!uniforms_.has(family_.gradientOpacity)) return true;
  auto table = std::make_shared<scene::VolumeTable>();
  if (!readTable(family_.gradientOpacity, 1, *table)) return false;
  volume.gradientOpacity = std::move(table);
  return true;
}

void VolumeReader::readLook(scene::Volume& volume) {
  volume.blend = valueOfWord(program_.known->words, family_.blendSlot, kVolumeBlends, family_.blend);
  volume.cellStep = value(family_.cellStep, glm::vec4(0)),
  volume.cellSpacing = value(family_.cellSpacing, glm::vec4(1));
  volume.range = value(family_.range, {0, 1, 0, 0}), volume.averaged = value(family_.averaged, {0, 1, 0, 0});
  volume.colorScale = value(family_.colorScale, glm::vec4(1)).x,
  volume.colorBias = value(family_.colorBias, glm::vec4(0)).x;
  volume.light.enabled = uniforms_.has(family_.lightDiffuse.uniform);
  if (!volume.light.enabled) return;
  volume.light.twoSided = !family_.twoSided.empty() && uniforms_.integer(family_.twoSided) != 0;
  volume.light.ambient = value(family_.ambient, glm::vec4(0));
  volume.light.diffuse = value(family_.diffuse, glm::vec4(1)) * value(family_.lightDiffuse, glm::vec4(1));
  volume.light.specular = value(family_.specular, glm::vec4(0)) * value(family_.lightSpecular, glm::vec4(1));
  volume.light.shininess = value(family_.shininess, glm::vec4(1)).x;
}

bool VolumeReader::readViewer(scene::VolumeView& view) {
  const auto point = [&](const std::string& name) { return glm::dvec3(uniforms_.vector(name)); };
  view.direction = glm::dvec3(0);
  if (uniforms_.has(family_.viewer)) view.viewer = point(family_.viewer);
  const bool viewer = uniforms_.has(family_.viewerInWorld),
             direction = uniforms_.has(family_.directionInWorld);
  if (!viewer && !direction) return uniforms_.has(family_.viewer) || refuse("its viewer is not active");
  const auto dataFromWorld = uniforms_.product(family_.dataFromWorld);
  if (!dataFromWorld) return refuse("a matrix is not active");
  if (viewer) view.viewer = glm::dvec3(*dataFromWorld * glm::dvec4(point(family_.viewerInWorld), 1));
  if (direction) view.direction = glm::dvec3(*dataFromWorld * glm::dvec4(point(family_.directionInWorld), 0));
  return true;
}

bool VolumeReader::readJitter(scene::VolumeView& view) {
  if (!uniforms_.has(family_.jitter)) return true;
  scene::Texture texture;
  const Reason read =
      shadow_.textures.bound(shadow_.real, shadow_.rare(), unitOf(family_.jitter), GL_SAMPLER_2D, texture);
  if (read != Reason::traced || !texture.image || texture.mipFilter != scene::MipFilter::none ||
      texture.wrapS != scene::Wrap::repeat || texture.wrapT != scene::Wrap::repeat)
    return refuse("the texture of \"" + family_.jitter + "\" is not traced");
  const scene::TextureImage& image = *texture.image;
  view.jitterSize = {image.width, image.height};
  view.jitter.clear();
  for (const glm::vec4& texel : image.floats) view.jitter.push_back(texel.r);
  for (const uint32_t texel : image.texels) view.jitter.push_back(static_cast<float>(texel & 255) / 255);
  return true;
}

bool VolumeReader::readView(scene::VolumeView& view) {
  const auto clip = uniforms_.product(program_.known->family->clipFromObject),
             texture = uniforms_.product(family_.textureFromData);
  if (!clip || !texture) return refuse("a matrix is not active");
  clipFromData_ = hasDepthsFromZero(shadow_.real, shadow_.rare()) ? toUsualDepths(*clip) : *clip;
  view.textureFromData = *texture;
  if (!isInvertible(clipFromData_) || !isInvertible(view.textureFromData))
    return refuse("a matrix has no inverse");
  const auto texture3 = glm::transpose(view.textureFromData);
  if (texture3[3] != glm::dvec4(0, 0, 0, 1))
    return refuse("the matrix to texture coordinates is a projection");
  if (!readViewer(view)) return false;
  view.step = value(family_.step, glm::vec4(0)).x;
  view.lower = value(family_.lower, glm::vec4(0)), view.upper = value(family_.upper, glm::vec4(1));
  if (!(view.step > 0) || !std::isfinite(view.step)) return refuse("its step is not above 0");
  return true;
}

bool VolumeReader::read(scene::VolumeCast& cast) {
  const glm::vec3 spacing = value(family_.cellSpacing, glm::vec4(1));
  if (!glm::all(glm::greaterThan(spacing, glm::vec3(0))))
    return refuse("the spacing of its voxels is not above 0");
  cast.threads = shadow_.settings.threads;
  readLook(cast.volume);
  return readView(cast.view) && readJitter(cast.view) && readGrid(cast.volume) && readTables(cast.volume);
}

bool VolumeReader::readDepths(scene::VolumeView& view) {
  view.depth.clear();
  if (family_.depth.empty()) return true;
  const GLint unit = unitOf(family_.depth);
  if (unit < 0) return true;
  const glm::vec2 texel = value(family_.depthTexel, glm::vec4(0)),
                  origin = value(family_.depthOrigin, glm::vec4(0));
  const glm::vec2 size = 1.0f / texel;
  const glm::ivec2 pixels(glm::round(size)), first(glm::round(origin));
  constexpr float kRounding = 1e-3f;  // pixels
  if (glm::any(glm::greaterThan(glm::abs(size - glm::vec2(pixels)), glm::vec2(kRounding * 16))) ||
      glm::any(glm::greaterThan(glm::abs(origin - glm::vec2(first)), glm::vec2(kRounding))))
    return refuse("its depths are not those of pixels");
  std::vector<float> depths;
  if (!shadow_.textures.depths(shadow_.real, shadow_.rare(), unit, pixels, depths))
    return refuse("its depths are no depth texture of the window's size");
  const scene::Region& r = view.region;
  view.depth.reserve(static_cast<size_t>(r.width) * static_cast<size_t>(r.height));
  for (int y = 0; y < r.height; ++y)
    for (int x = 0; x < r.width; ++x) {
      const glm::ivec2 at = glm::clamp(glm::ivec2(r.x + x, r.y + y) - first, glm::ivec2(0), pixels - 1);
      view.depth.push_back(
          depths[static_cast<size_t>(at.y) * static_cast<size_t>(pixels.x) + static_cast<size_t>(at.x)]);
    }
  return true;
}

}  // namespace gluray::gl
