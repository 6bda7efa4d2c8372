#include "gl/textures/texture_cache.h"

#include "gl/arrays/arrays.h"
#include "gl/real/state_queries.h"
#include "gl/sharing/share_group.h"
#include "gl/textures/active_unit.h"
#include "gl/textures/drawn_textures.h"
#include "gl/textures/texture_env.h"
#include "gl/textures/texture_sampling.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

/// Texture targets, the highest-ranking first (GL 2.1, 3.8.15).
struct Target {
  GLenum name, binding;
  scene::TextureTarget kind;
};
constexpr Target kTargets[] = {
    {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP, scene::TextureTarget::cubeMap},
    {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D, scene::TextureTarget::texture3D},
    {GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE, scene::TextureTarget::rectangle},
    {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, scene::TextureTarget::texture2D},
    {GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D, scene::TextureTarget::texture1D},
};

/// The enabled targets of the active unit.
struct EnabledTargets {
  const Target* highest = nullptr;
  bool more = false;
  EnabledTargets(const RealGl& real, const RareState& has) {
    for (const Target& target : kTargets) {
      if (target.kind == scene::TextureTarget::rectangle && !has.rectangles) continue;
      if (!real.IsEnabled(target.name)) continue;
      if (highest) more = true;
      if (!highest) highest = &target;
    }
  }
};

/// Whether combiners read only units that have a texture; the result of reading others is undefined.
bool readOnlyEnabledUnits(const std::vector<scene::Texture>& textures) {
  uint32_t enabled = 0, read = 0;
  for (const scene::Texture& t : textures) enabled |= 1u << t.unit, read |= otherUnits(t);
  return (read & ~enabled) == 0;
}

}  // namespace

void TextureCache::tellOthers() {
  // The new count must not hide earlier changes by other contexts.
  const uint64_t before = group_.textureChanges.fetch_add(1);
  if (before == changesKnown_) ++changesKnown_;
}

void TextureCache::allImagesChanged() {
  images_.clear(), voxels_.clear();
  tellOthers();
}

void TextureCache::attached(GLuint name) noexcept {
  try {
    if (name != 0) attached_.insert(name);
  } catch (...) { attachedIncomplete_ = true; }  // no memory
  forgetAttached();
}

void TextureCache::forgetAttached() {
  drawnToKnown_ = false;
  if (attachedIncomplete_) return allImagesChanged();
  if (attached_.empty()) return;
  std::erase_if(images_, [&](const auto& known) { return attached_.contains(known.first.name); });
  std::erase_if(voxels_, [&](const auto& known) { return attached_.contains(known.first); });
  tellOthers();
}

void TextureCache::framebufferBound(const RealGl& real) {
  const bool cached = std::any_of(images_.begin(), images_.end(),
                                  [&](const auto& known) { return attached_.contains(known.first.name); });
  if (!cached || !drawnToKnown_ || attachedIncomplete_ ||
      !isPresent(real.GetFramebufferAttachmentParameteriv))
    return forgetAttached();
  std::vector<GLuint> now = texturesDrawnTo(real);
  const auto isIn = [](const std::vector<GLuint>& names, GLuint name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::erase_if(images_, [&](const auto& known) {
    return isIn(now, known.first.name) || isIn(drawnTo_, known.first.name);
  });
  std::erase_if(voxels_, [&](const auto& known) { return attached_.contains(known.first); });
  drawnTo_ = std::move(now);
  tellOthers();
}

void TextureCache::finished() {
  if (attachedIncomplete_ || !attached_.empty()) tellOthers();
}

void TextureCache::imageChanged(const RealGl& real, GLenum target) {
  tellOthers();
  if (target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z)
    target = GL_TEXTURE_CUBE_MAP;
  for (const Target& t : kTargets) {
    if (t.name != target) continue;  // also proxies, and targets that fixed function lacks
    const auto name = static_cast<GLuint>(integer(real, t.binding));
    if (target == GL_TEXTURE_3D) voxels_.erase(name);
    std::erase_if(
        images_, [&](const auto& known) { return known.first.target == target && known.first.name == name; });
  }
}

void TextureCache::deleted(GLuint name) {
  tellOthers();
  attached_.erase(name);
  voxels_.erase(name);
  std::erase_if(images_, [&](const auto& known) { return known.first.name == name; });
}

std::shared_ptr<const scene::TextureImage> TextureCache::image(const RealGl& real, const RareState& has,
                                                               GLenum target, const ImageRange& range,
                                                               Reason& reason) {
  const auto* known = std::find_if(std::begin(kTargets), std::end(kTargets),
                                   [&](const Target& t) { return t.name == target; });
  const Key key{target, static_cast<GLuint>(integer(real, known->binding)), range};
  if (const auto found = images_.find(key); found != images_.end()) return found->second;
  auto image = readImage(real, has, target, range, reason);
  if (!image) return image;
  if (attached_.contains(key.name) && !drawnToKnown_ && isPresent(real.GetFramebufferAttachmentParameteriv))
    drawnTo_ = texturesDrawnTo(real), drawnToKnown_ = true;
  images_[key] = image;
  return image;
}

Reason TextureCache::readUnit(const RealGl& real, const RareState& has, GLint unit,
                              std::vector<scene::Texture>& textures) {
  const EnabledTargets enabled(real, has);
  if (!enabled.highest) return Reason::traced;
  const GLenum target = enabled.highest->name;
  scene::Texture texture;
  texture.unit = static_cast<uint8_t>(unit);
  texture.target = enabled.highest->kind;
  const Reason sampling = readSampling(real, has, target, texture);
  const ImageRange range = rangeOf(real, has, target, texture.mipFilter != scene::MipFilter::none);
  // An incomplete texture disables texturing (GL 2.1, 3.8.10), but some implementations use the next target.
  if (range.levels == 0) return enabled.more ? Reason::textureIncomplete : Reason::traced;
  if (unit >= scene::kTextureUnits) return Reason::textureUnits;
  if (sampling != Reason::traced) return sampling;
  if (!readTexGen(real, texture.texGen)) return Reason::texGen;
  if (!readEnvironment(real, texture)) return Reason::textureEnv;
  real.GetFloatv(GL_TEXTURE_MATRIX, glm::value_ptr(texture.textureMatrix));
  Reason reason = Reason::traced;
  texture.image = image(real, has, target, range, reason);
  if (texture.image) textures.push_back(std::move(texture));
  return reason;
}

namespace {

/// The target that a sampler reads; null for samplers that are not traced.
const Target* targetOfSampler(GLenum sampler) {
  const auto target = [&] {
    switch (sampler) {
      case GL_SAMPLER_1D: return scene::TextureTarget::texture1D;
      case GL_SAMPLER_3D: return scene::TextureTarget::texture3D;
      case GL_SAMPLER_CUBE: return scene::TextureTarget::cubeMap;
      case GL_SAMPLER_2D_RECT: return scene::TextureTarget::rectangle;
      default: return scene::TextureTarget::texture2D;
    }
  }();
  const bool known = sampler == GL_SAMPLER_1D || sampler == GL_SAMPLER_2D || sampler == GL_SAMPLER_3D ||
                     sampler == GL_SAMPLER_CUBE || sampler == GL_SAMPLER_2D_RECT;
  const auto* found = std::find_if(std::begin(kTargets), std::end(kTargets),
                                   [&](const Target& t) { return t.kind == target; });
  return known ? found : nullptr;
}

}  // namespace

Reason TextureCache::bound(const RealGl& real, const RareState& has, GLint unit, GLenum sampler,
                           scene::Texture& texture) {
  const Target* target = targetOfSampler(sampler);
  if (!target) return Reason::textureFormat;
  forgetChanged();
  ActiveUnit active(real);
  active.select(static_cast<GLenum>(GL_TEXTURE0 + unit));
  texture.target = target->kind;
  if (const Reason sampling = readSampling(real, has, target->name, texture); sampling != Reason::traced)
    return sampling;
  const ImageRange range = rangeOf(real, has, target->name, texture.mipFilter != scene::MipFilter::none);
  if (range.levels == 0) return Reason::textureIncomplete;
  Reason reason = Reason::traced;
  texture.image = image(real, has, target->name, range, reason);
  // Luminance, alpha and intensity formats have the same meaning in programs and fixed function. Two-channel
  // formats do not.
  return reason;
}

Reason TextureCache::buffer(const RealGl& real, ShareGroup& group, GLint unit, BufferTexture& texture) {
  texture = {};
  if (!isPresent(real.TexBuffer)) return Reason::textureFormat;
  ActiveUnit active(real);
  active.select(static_cast<GLenum>(GL_TEXTURE0 + unit));
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    real.GetTexLevelParameteriv(GL_TEXTURE_BUFFER, 0, name, &value);
    return value;
  };
  texture.format = static_cast<GLenum>(ask(GL_TEXTURE_INTERNAL_FORMAT));
  texture.buffer = bufferNamed(group, static_cast<GLuint>(ask(GL_TEXTURE_BUFFER_DATA_STORE_BINDING)));
  if (!texture.buffer) return Reason::textureFormat;
  if (texture.buffer->foreign) return Reason::foreignBuffer;
  texture.size = texture.buffer->size();
  if (versionOf(real) < 43) return Reason::traced;
  texture.offset = static_cast<size_t>(ask(GL_TEXTURE_BUFFER_OFFSET));
  const GLint part = ask(GL_TEXTURE_BUFFER_SIZE);
  if (texture.offset > texture.size) return Reason::textureFormat;
  texture.size = std::min(texture.size - texture.offset, part > 0 ? static_cast<size_t>(part) : texture.size);
  return Reason::traced;
}

Reason TextureCache::buffer(const RealGl& real, ShareGroup& group, GLint unit, scene::Attribute& elements,
                            uint32_t& count) {
  elements = {};
  BufferTexture texture;
  if (const Reason reason = buffer(real, group, unit, texture); reason != Reason::traced) return reason;
  uint32_t stride = 0;
  scene::Format format = scene::Format::none;
  switch (texture.format) {
    case GL_RGBA8UI:
    case GL_RGBA8: format = scene::Format::unorm8x4, stride = 4; break;
    case GL_R8UI:
    case GL_R8: format = scene::Format::bits8, stride = 1; break;
    case GL_R32F: format = scene::Format::float1, stride = 4; break;
    case GL_RG32F: format = scene::Format::float2, stride = 8; break;
    case GL_RGB32F: format = scene::Format::float3, stride = 12; break;
    case GL_RGBA32F: format = scene::Format::float4, stride = 16; break;
    default: return Reason::textureFormat;
  }
  const auto storage = texture.buffer->read(real);
  if (!storage) return Reason::textureFormat;
  elements = {storage, storage->data + texture.offset, stride, format};
  count = static_cast<uint32_t>(texture.size / stride);
  return Reason::traced;
}

bool TextureCache::isOpaque(const scene::Attribute& elements, uint32_t count) {
  if (elements.format != scene::Format::float4 && elements.format != scene::Format::unorm8x4) return true;
  if (checked_ == elements && checkedCount_ == count) return checkedOpaque_;
  checkedOpaque_ = true;
  for (uint32_t i = 0; i < count && checkedOpaque_; ++i) checkedOpaque_ = scene::fetch(elements, i).a >= 1.0f;
  checked_ = elements, checkedCount_ = count;
  return checkedOpaque_;
}

void TextureCache::forgetChanged() {
  const uint64_t changes = group_.textureChanges;
  if (std::exchange(changesKnown_, changes) != changes) images_.clear(), voxels_.clear();
}

Reason TextureCache::read(const RealGl& real, const RareState& has, std::vector<scene::Texture>& textures) {
  forgetChanged();
  textures.clear();
  Reason reason = Reason::traced;
  ActiveUnit active(real);
  const GLint units = isPresent(real.ActiveTexture) ? integer(real, GL_MAX_TEXTURE_UNITS) : 1;
  for (GLint i = 0; i < units && reason == Reason::traced; ++i) {
    active.select(static_cast<GLenum>(GL_TEXTURE0 + i));
    reason = readUnit(real, has, i, textures);
  }
  if (reason == Reason::traced && !readOnlyEnabledUnits(textures)) return Reason::textureEnv;
  return reason;
}

}  // namespace gluray::gl
