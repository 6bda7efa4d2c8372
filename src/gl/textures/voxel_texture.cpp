#include "gl/textures/voxel_texture.h"

#include "gl/textures/pixel_guard.h"

#include <algorithm>
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

}  // namespace

std::shared_ptr<const VoxelGrid> readVoxels(const RealGl& real, const RareState& has, std::string& why) {
  const auto level = [&](GLenum name) { return ask(real, GL_TEXTURE_3D, name); };
  constexpr GLenum kSizes[] = {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                               GL_TEXTURE_ALPHA_SIZE};
  int channels = 0;
  while (channels < 4 && level(kSizes[channels]) > 0) ++channels;
  why = "the format of its texture is not traced";
  const bool more = channels < 4 && level(GL_TEXTURE_ALPHA_SIZE) > 0;
  if (channels == 0 || more || !has.textureTypes || level(GL_TEXTURE_COMPRESSED)) return nullptr;
  if (channels > 1) return why = "its voxels have several components", nullptr;
  const auto form = formOf(level(GL_TEXTURE_RED_TYPE), level(GL_TEXTURE_RED_SIZE));
  if (!form) return nullptr;
  auto grid = std::make_shared<VoxelGrid>();
  grid->type = form->type;
  grid->size = {level(GL_TEXTURE_WIDTH), level(GL_TEXTURE_HEIGHT), level(GL_TEXTURE_DEPTH)};
  if (grid->voxels() == 0) return nullptr;
  grid->values = std::make_unique_for_overwrite<std::byte[]>(grid->bytes() + VoxelGrid::kPadding);
  std::fill_n(grid->values.get() + grid->bytes(), VoxelGrid::kPadding, std::byte{0});
  const PixelGuard guard(real, has.fixedFunction);
  real.PixelStorei(GL_PACK_ALIGNMENT, 1);
  real.GetTexImage(GL_TEXTURE_3D, 0, GL_RED, form->read, grid->values.get());
  why.clear();
  return grid;
}

bool readDepthTexture(const RealGl& real, const RareState& has, glm::ivec2 size, std::vector<float>& out) {
  const auto level = [&](GLenum name) { return ask(real, GL_TEXTURE_2D, name); };
  if (level(GL_TEXTURE_DEPTH_SIZE) == 0 || level(GL_TEXTURE_WIDTH) != size.x ||
      level(GL_TEXTURE_HEIGHT) != size.y)
    return false;
  GLint compare = GL_NONE;
  real.GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, &compare);
  if (compare != GL_NONE) return false;
  out.resize(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  const PixelGuard guard(real, has.fixedFunction);
  real.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, out.data());
  return true;
}

}  // namespace gluray::gl
