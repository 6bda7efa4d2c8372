#include "gl/textures/voxel_texture.h"

#include "gl/textures/pixel_guard.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace gluray::gl {
namespace {

using scene::VoxelGrid;

GLint ask(const RealGl& real, GLenum target, GLenum name) {
  GLint value = 0;
  real.GetTexLevelParameteriv(target, 0, name, &value);
  return value;
}

struct Form {
  VoxelGrid::Type type = VoxelGrid::Type::single;
  GLenum read = GL_FLOAT;
};

/// How a channel of `bits` is stored.
std::optional<Form> formOf(GLint componentType, GLint bits) {
  using Type = VoxelGrid::Type;
  switch (componentType) {
    case GL_UNSIGNED_NORMALIZED:
      if (bits <= 8) return Form{Type::byte, GL_UNSIGNED_BYTE};
      return bits <= 16 ? std::optional(Form{Type::word, GL_UNSIGNED_SHORT}) : std::nullopt;
    case GL_SIGNED_NORMALIZED:
      if (bits <= 8) return Form{Type::signedByte, GL_BYTE};
      return bits <= 16 ? std::optional(Form{Type::signedWord, GL_SHORT}) : std::nullopt;
    case GL_FLOAT: return Form{};
    default: return std::nullopt;
  }
}

/// Values whose channels stand side by side, channel by channel in `to`.
std::unique_ptr<std::byte[]> separated(const VoxelGrid& grid, std::unique_ptr<std::byte[]> to) {
  const size_t size = sizeOf(grid.type), channels = static_cast<size_t>(grid.channels),
               voxels = grid.voxels();
  const auto copy = [&]<class Stored>(Stored) {
    const auto* from = reinterpret_cast<const Stored*>(grid.values.get());
    auto* out = reinterpret_cast<Stored*>(to.get());
    for (size_t c = 0; c < channels; ++c)
      for (size_t i = 0; i < voxels; ++i) out[c * voxels + i] = from[i * channels + c];
  };
  size == 1 ? copy(uint8_t{}) : size == 2 ? copy(uint16_t{}) : copy(uint32_t{});
  return to;
}

}  // namespace

std::shared_ptr<const VoxelGrid> readVoxels(const RealGl& real, const RareState& has, std::string& why) {
  const auto level = [&](GLenum name) { return ask(real, GL_TEXTURE_3D, name); };
  GLenum sizes[] = {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE};
  const bool grey = has.fixedFunction && level(GL_TEXTURE_LUMINANCE_SIZE) > 0;
  if (grey) sizes[0] = GL_TEXTURE_LUMINANCE_SIZE;
  int channels = 0;
  while (channels < 4 && level(sizes[channels]) > 0) ++channels;
  why = "the format of its texture is not traced";
  const bool more = channels < 4 && level(GL_TEXTURE_ALPHA_SIZE) > 0;
  if (channels == 0 || more || !has.textureTypes || level(GL_TEXTURE_COMPRESSED)) return nullptr;
  const auto form = formOf(level(grey ? GL_TEXTURE_LUMINANCE_TYPE : GL_TEXTURE_RED_TYPE), level(sizes[0]));
  for (int c = 1; c < channels; ++c)
    if (level(sizes[c]) != level(sizes[0])) return nullptr;
  if (!form) return nullptr;
  auto grid = std::make_shared<VoxelGrid>();
  grid->type = form->type;
  grid->channels = channels, grid->grey = grey;
  grid->size = {level(GL_TEXTURE_WIDTH), level(GL_TEXTURE_HEIGHT), level(GL_TEXTURE_DEPTH)};
  if (grid->voxels() == 0) return nullptr;
  const auto memory = [&] {
    auto bytes = std::make_unique_for_overwrite<std::byte[]>(grid->bytes() + VoxelGrid::kPadding);
    std::fill_n(bytes.get() + grid->bytes(), VoxelGrid::kPadding, std::byte{0});
    return bytes;
  };
  grid->values = memory();
  const PixelGuard guard(real, has.fixedFunction);
  real.PixelStorei(GL_PACK_ALIGNMENT, 1);
  constexpr GLenum kFormats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  real.GetTexImage(GL_TEXTURE_3D, 0, kFormats[channels - 1], form->read, grid->values.get());
  if (channels > 1) grid->values = separated(*grid, memory());
  why.clear();
  return grid;
}

namespace {

/// Where a filter reads along one axis: two texels, and the share of the second one.
struct Place {
  size_t first = 0, second = 0;
  float share = 0;
};
Place placeOf(float coordinate, int size, bool linear) {
  const auto inside = [&](float texel) {
    return static_cast<size_t>(std::clamp(texel, 0.0f, static_cast<float>(size - 1)));
  };
  const float at = coordinate * static_cast<float>(size);
  if (!linear) return {inside(std::floor(at)), inside(std::floor(at)), 0};
  constexpr float kSteps = 256;  // positions between two texels: rounding must not mix them at their centres
  const float from = std::round((at - 0.5f) * kSteps) / kSteps, first = std::floor(from);
  return {inside(first), inside(first + 1), from - first};
}

}  // namespace

std::vector<float> DepthTexture::inRegion(const scene::Region& region, glm::vec2 origin,
                                          glm::vec2 texel) const {
  std::vector<Place> columns;
  for (int x = 0; x < region.width; ++x)
    columns.push_back(
        placeOf((static_cast<float>(region.x + x) + 0.5f - origin.x) * texel.x, size.x, linear));
  std::vector<float> depths;
  depths.reserve(columns.size() * static_cast<size_t>(region.height));
  for (int y = 0; y < region.height; ++y) {
    const Place row = placeOf((static_cast<float>(region.y + y) + 0.5f - origin.y) * texel.y, size.y, linear);
    const float* const lower = &values[row.first * static_cast<size_t>(size.x)];
    const float* const upper = &values[row.second * static_cast<size_t>(size.x)];
    for (const Place& c : columns)
      depths.push_back(glm::mix(glm::mix(lower[c.first], lower[c.second], c.share),
                                glm::mix(upper[c.first], upper[c.second], c.share), row.share));
  }
  return depths;
}

bool readDepthTexture(const RealGl& real, const RareState& has, DepthTexture& out) {
  const auto level = [&](GLenum name) { return ask(real, GL_TEXTURE_2D, name); };
  const auto parameter = [&](GLenum name) {
    GLint value = 0;
    real.GetTexParameteriv(GL_TEXTURE_2D, name, &value);
    return value;
  };
  if (level(GL_TEXTURE_DEPTH_SIZE) == 0 || parameter(GL_TEXTURE_COMPARE_MODE) != GL_NONE) return false;
  const GLint filter = parameter(GL_TEXTURE_MAG_FILTER);
  if (filter != parameter(GL_TEXTURE_MIN_FILTER) || (filter != GL_NEAREST && filter != GL_LINEAR))
    return false;
  out.linear = filter == GL_LINEAR;
  out.size = {level(GL_TEXTURE_WIDTH), level(GL_TEXTURE_HEIGHT)};
  out.values.resize(static_cast<size_t>(out.size.x) * static_cast<size_t>(out.size.y));
  const PixelGuard guard(real, has.fixedFunction);
  real.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, out.values.data());
  return true;
}

}  // namespace gluray::gl
