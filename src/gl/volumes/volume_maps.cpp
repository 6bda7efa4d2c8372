#include "gl/volumes/volume_maps.h"

#include "gl/program_state/program_state.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace gluray::gl {
namespace {

constexpr int kEntries = 8193;

/// The texture of a sampler2D; null image: it is not traced.
scene::Texture textureOf(ShadowState& shadow, const UniformReader& uniforms, const std::string& sampler) {
  scene::Texture texture;
  const GLint unit = uniforms.unit(sampler);
  if (unit < 0 ||
      shadow.textures.bound(shadow.real, shadow.rare(), unit, GL_SAMPLER_2D, texture) != Reason::traced)
    return {};
  const bool plain = texture.wrapS == scene::Wrap::clampToEdge && texture.wrapT == scene::Wrap::clampToEdge &&
                     texture.magFilter == texture.minFilter && texture.mipFilter == scene::MipFilter::none;
  const bool colored = texture.image && texture.image->baseFormat == scene::BaseFormat::rgba;
  return plain && colored ? texture : scene::Texture{};
}

glm::dvec4 texelOf(const scene::TextureImage& image, const glm::ivec2& at) {
  const glm::ivec2 inside = glm::clamp(at, glm::ivec2(0), glm::ivec2(image.width, image.height) - 1);
  const auto index =
      static_cast<size_t>(inside.y) * static_cast<size_t>(image.width) + static_cast<size_t>(inside.x);
  if (!image.floats.empty()) return glm::dvec4(image.floats[index]);
  const uint32_t texel = image.texels[index];
  return glm::dvec4(texel & 255, texel >> 8 & 255, texel >> 16 & 255, texel >> 24) / 255.0;
}

/// Filtered in eight bits (scene::Texture::byteFilter): weights are multiples of 1/256, and each
/// interpolation rounds to 1/255.
glm::dvec4 sampledInBytes(const scene::TextureImage& image, const glm::dvec2& at) {
  const glm::ivec2 place(glm::round(at * glm::dvec2(image.width, image.height) * 256.0));
  const glm::ivec2 low = (place - 128) >> 8, weight = (place - 128) & 255;
  const auto texel = [&](int x, int y) {
    return glm::ivec4(texelOf(image, low + glm::ivec2(x, y)) * 255.0 + 0.5);
  };
  const auto mixed = [](const glm::ivec4& a, const glm::ivec4& b, int share) {
    return a + (((b - a) * share + 128) >> 8);
  };
  const glm::ivec4 lower = mixed(texel(0, 0), texel(1, 0), weight.x),
                   upper = mixed(texel(0, 1), texel(1, 1), weight.x);
  return glm::dvec4(mixed(lower, upper, weight.y)) / 255.0;
}

glm::dvec4 sampled(const scene::Texture& texture, const glm::dvec2& at) {
  const scene::TextureImage& image = *texture.image;
  const glm::dvec2 place = at * glm::dvec2(image.width, image.height);
  if (texture.magFilter == scene::Filter::nearest) return texelOf(image, glm::ivec2(glm::floor(place)));
  if (texture.byteFilter && image.floats.empty()) return sampledInBytes(image, at);
  const glm::dvec2 low = glm::floor(place - 0.5), share = place - 0.5 - low;
  const glm::ivec2 first(low);
  const auto row = [&](int y) {
    return glm::mix(texelOf(image, first + glm::ivec2(0, y)), texelOf(image, first + glm::ivec2(1, y)),
                    share.x);
  };
  return glm::mix(row(0), row(1), share.y);
}

bool isSame(const scene::Texture& a, const scene::Texture& b) {
  return a.image == b.image && a.magFilter == b.magFilter;
}

}  // namespace

bool VolumeMaps::isCurrent(ShadowState& shadow, const UniformReader& uniforms, const Known& known) {
  return std::ranges::all_of(known.textures, [&](const Sampled& read) {
    return isSame(textureOf(shadow, uniforms, read.sampler), read.texture);
  });
}

bool VolumeMaps::read(ShadowState& shadow, const UniformReader& uniforms, const NamedFunction& function,
                      scene::VolumeTable& table, std::string& why) {
  if (!function.shader) return why = "its map of colours is no function that can be read", false;
  std::erase_if(known_, [](const Known& known) { return known.shader.expired(); });
  const auto is = [&](const Known& known) {
    return known.shader.lock() == function.shader && known.name == function.name;
  };
  const auto found = std::ranges::find_if(known_, is);
  if (found != known_.end() && isCurrent(shadow, uniforms, *found)) return table = found->table, true;
  if (found != known_.end()) known_.erase(found);
  Known made{function.shader, function.name, {}, {}};
  glsl::FunctionInputs inputs;
  inputs.uniform = [](std::string_view) { return std::optional<glsl::FunctionValue>(); };
  inputs.texture = [&](std::string_view sampler, const glm::dvec2& at) -> std::optional<glm::dvec4> {
    auto texture = std::ranges::find(made.textures, sampler, &Sampled::sampler);
    if (texture == made.textures.end()) {
      const std::string name(sampler);
      made.textures.push_back({name, textureOf(shadow, uniforms, name)});
      texture = made.textures.end() - 1;
    }
    return texture->texture.image ? std::optional(sampled(texture->texture, at)) : std::nullopt;
  };
  made.table.channels = 4, made.table.linear = false;
  try {
    for (int i = 0; i < kEntries; ++i) {
      const glm::dvec4 color = function.shader->colorOf(function.name, i / (kEntries - 1.0), inputs);
      for (int c = 0; c < 4; ++c) made.table.values.push_back(static_cast<float>(color[c]));
    }
  } catch (const std::runtime_error&) { return why = "its map of colours is not understood", false; }
  if (!std::ranges::all_of(made.table.values, [](float v) { return std::isfinite(v); }))
    return why = "its map has colours that are no numbers", false;
  table = made.table;
  known_.push_back(std::move(made));
  return true;
}

}  // namespace gluray::gl
