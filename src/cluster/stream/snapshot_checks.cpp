#include "cluster/stream/snapshot_checks.h"

#include "cluster/stream/byte_stream.h"
#include "scene/backdrop.h"
#include "scene/secondary_scene.h"

#include <algorithm>

namespace gluray::cluster {
namespace {

constexpr int kMaxPixels = 1 << 15;  // wide and high
constexpr int kMaxSamples = 64;

void require(bool holds, const char* what) {
  if (!holds) throw Malformed(what);
}

bool isOfRegion(size_t count, const scene::Region& region) {
  return count == static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
}

void checkPixels(const scene::Snapshot& s) {
  const scene::Region& r = s.region;
  require(r.width > 0 && r.height > 0 && r.width <= kMaxPixels && r.height <= kMaxPixels &&
              std::abs(r.x) <= kMaxPixels && std::abs(r.y) <= kMaxPixels,
          "the region has no such size");
  const glm::ivec4& v = s.camera.viewport;
  require(v.z > 0 && v.w > 0 && v.z <= 2 * kMaxPixels && v.w <= 2 * kMaxPixels,
          "the viewport has no such size");
  require(s.samples >= 1 && s.samples <= kMaxSamples, "there are too many samples");
  require(s.samplePositions.size() <= static_cast<size_t>(kMaxSamples), "there are too many samples");
  require(s.samples == 1 || s.samplePositions.size() == static_cast<size_t>(s.samples),
          "samples have no positions");
  if (s.layers) {
    require(isOfRegion(s.layers->opaqueDepth.size(), r), "depths do not fit the region");
    const size_t colors = s.wideColors ? s.layers->floatColors.size() : s.layers->colors.size();
    require(s.layers->of != scene::Layers::Of::drawn || isOfRegion(colors, r),
            "colours do not fit the region");
  }
  if (s.backdrop)
    require(s.backdrop->isClear.empty() || isOfRegion(s.backdrop->isClear.size(), r),
            "the backdrop does not fit the region");
  if (s.lightSampling.tiles) {
    constexpr int kTile = scene::LightSampling::kTile;
    const auto across = static_cast<size_t>((r.width + kTile - 1) / kTile),
               up = static_cast<size_t>((r.height + kTile - 1) / kTile);
    require(s.lightSampling.tiles->size() == across * up, "tiles do not fit the region");
  }
}

void checkTexture(const scene::Texture& texture) {
  require(texture.image != nullptr, "a texture has no image");
  require(texture.unit < scene::kTextureUnits, "there is no such texture unit");
  require(texture.image->width > 0 && texture.image->height > 0 && texture.image->depth > 0,
          "an image is empty");
  for (const scene::TexelGrid& level : texture.image->mipmaps)
    require(level.width > 0 && level.height > 0 && level.depth > 0, "an image is empty");
  if (texture.target == scene::TextureTarget::cubeMap)
    require(texture.image->depth == 6, "a cube map does not have six faces");
  for (const scene::Combine::Part* part : {&texture.combine.rgb, &texture.combine.alphaPart})
    for (const scene::Combine::Argument& argument : part->arguments)
      require(argument.source < scene::Combine::textureUnit + scene::kTextureUnits,
              "there is no such texture unit");
}

void checkSingle(const std::vector<scene::Texture>& textures, scene::TextureTarget target) {
  require(textures.size() == 1 && textures.front().target == target, "an environment lacks an image");
  checkTexture(textures.front());
}

void checkPbr(const scene::PbrSurface& pbr) {
  require(pbr.textures.size() <= scene::kTextureUnits, "there are too many textures");
  for (const scene::Texture& texture : pbr.textures) checkTexture(texture);
  for (const int index : {pbr.material, pbr.emission, pbr.normal})
    require(index >= -1 && index < static_cast<int>(pbr.textures.size()), "a material lacks a texture");
  const scene::PbrEnvironment& environment = pbr.environment;
  if (!environment.on()) return;
  checkSingle(environment.prefiltered, scene::TextureTarget::cubeMap);
  checkSingle(environment.brdf, scene::TextureTarget::texture2D);
  if (!environment.byHarmonics) checkSingle(environment.irradiance, scene::TextureTarget::cubeMap);
}

void checkShadings(const std::vector<scene::Shading>& shadings) {
  for (const scene::Shading& shading : shadings) {
    require(shading.textures.size() <= scene::kTextureUnits, "there are too many textures");
    for (const scene::Texture& texture : shading.textures) checkTexture(texture);
    for (const scene::Texture& texture : shading.fragment.map) checkTexture(texture);
    const std::vector<scene::Texture>& matcap = shading.fragment.matcap;
    for (const scene::Texture& texture : matcap) checkTexture(texture);
    require(matcap.empty() || matcap.size() == 4, "an image by normals is missing");
    checkPbr(shading.fragment.pbr);
    require(shading.fragment.height.axis >= 0 && shading.fragment.height.axis <= 2, "colours by no axis");
    require(shading.fragment.color != scene::FragmentShading::Color::map || !shading.fragment.map.empty(),
            "a map is missing");
  }
}

void checkInstances(const std::vector<scene::Instance>& instances,
                    const std::vector<scene::Shading>& shadings) {
  for (const scene::Instance& instance : instances) {
    require(instance.shading < shadings.size(), "a shading does not exist");
    require(!instance.materials.empty(), "an instance has no material");
    const scene::FragmentShading& fragment = shadings[instance.shading].fragment;
    require(fragment.color != scene::FragmentShading::Color::perTriangle || instance.triangleColors,
            "triangles have no colours");
    require(fragment.normals != scene::FragmentShading::Normals::perTriangle || instance.triangleNormals,
            "triangles have no normals");
  }
}

void checkCapture(const scene::FramebufferCapture* capture, bool colors) {
  require(capture, "an image is missing");
  const scene::Region& region = capture->region;
  require(region.width >= 0 && region.height >= 0, "an image has no shape");
  const auto pixels = static_cast<uint64_t>(region.width) * static_cast<uint64_t>(region.height);
  require(capture->colors.size() == (colors ? pixels : 0) && capture->depths.size() == pixels,
          "an image has other pixels than its shape says");
}

}  // namespace

void check(const scene::Snapshot& snapshot) {
  checkPixels(snapshot);
  checkShadings(snapshot.shadings);
  checkInstances(snapshot.instances, snapshot.shadings);
  if (!snapshot.secondaryScene) return;
  const scene::SecondaryScene& around = *snapshot.secondaryScene;
  require(around.blended.size() == around.instances.size(),
          "parts of the secondary scene do not fit each other");
  require(around.captured.size() <= around.instances.size(), "more surfaces are captured than there are");
  for (const scene::CapturedSurface& one : around.captured)
    require(one.capture == scene::CapturedSurface::kNone || one.capture < around.captures.size(),
            "a surface has no image");
  for (const auto& capture : around.captures) checkCapture(capture.get(), true);
  if (around.framebuffer) checkCapture(around.framebuffer.get(), false);
  checkShadings(around.shadings);
  checkInstances(around.instances, around.shadings);
}

}  // namespace gluray::cluster
