#include "gl/volumes/volume_reader.h"

#include "gl/basics/affine.h"
#include "gl/real/clip_depths.h"
#include "gl/textures/voxel_texture.h"
#include "gl/volumes/volume_look_reader.h"

#include <cmath>
#include <utility>

namespace gluray::gl {

VolumeReader::VolumeReader(ShadowState& shadow, VolumeMaps& maps)
    : shadow_(shadow),
      program_(shadow.program()),
      family_(program_.known->family->volume),
      uniforms_(program_.known->program, *program_.uniforms, program_.known->placeholders),
      maps_(maps) {}

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

bool VolumeReader::readClipPlanes(scene::VolumeView& view) {
  if (!uniforms_.has(family_.clipPlanes)) return true;
  const auto dataFromWorld = uniforms_.product(family_.dataFromWorld);
  const bool crop =
      valueOfWord(program_.known->words, family_.clipSlot, kVolumeClipSpaces, family_.clipsCropSpace);
  const auto texture = uniforms_.product(crop ? family_.textureFromCrop : family_.textureFromData);
  if (!dataFromWorld || !texture) return refuse("a matrix is not active");
  const glm::dmat4 worldFromData = glm::inverse(*dataFromWorld);
  scene::VolumeClipping& clipping = view.clipping.emplace();
  clipping.spaceFromTexture = worldFromData * glm::inverse(*texture);
  clipping.spaceFromData = glm::dmat3(worldFromData);
  const auto number = [&](int i) { return double{uniforms_.number(family_.clipPlanes, i)}; };
  constexpr int kNumbers = 6, kMostPlanes = 100;
  const int numbers = static_cast<int>(number(0));
  if (numbers < 0 || numbers > kMostPlanes * kNumbers) return refuse("it has too many clip planes");
  for (int i = 1; i <= numbers; i += kNumbers) {
    const glm::dvec3 point(number(i), number(i + 1), number(i + 2)),
        normal(number(i + 3), number(i + 4), number(i + 5));
    if (!(glm::length(normal) > 0)) return refuse("a clip plane has no normal");
    const glm::dvec3 direction = glm::normalize(normal);
    clipping.planes.emplace_back(direction, -glm::dot(direction, point));
  }
  return true;
}

bool VolumeReader::readSlice(scene::VolumeView& view) {
  if (!uniforms_.has(family_.slicePoint)) return true;
  const auto dataFromWorld = uniforms_.product(family_.dataFromWorld),
             texture = uniforms_.product(family_.textureFromCrop);
  if (!dataFromWorld || !texture) return refuse("a matrix is not active");
  const auto vector = [&](const std::string& name, double w) {
    return glm::dvec3(*dataFromWorld * glm::dvec4(glm::dvec3(uniforms_.vector(name)), w));
  };
  const glm::dvec3 point = vector(family_.slicePoint, 1), normal = vector(family_.sliceNormal, 0);
  view.slice = scene::VolumeSlice{glm::dvec4(normal, -glm::dot(normal, point)), *texture};
  return true;
}

bool VolumeReader::readJitter(scene::VolumeView& view) {
  if (!uniforms_.has(family_.jitter)) return true;
  scene::Texture texture;
  const Reason read = shadow_.textures.bound(shadow_.real, shadow_.rare(), uniforms_.unit(family_.jitter),
                                             GL_SAMPLER_2D, texture);
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
  const auto clip = uniforms_.product(program_.known->family->clipFromObject);
  auto texture = uniforms_.product(family_.textureFromData);
  // Programs with one sample on a plane take no steps.
  const bool sliced = uniforms_.has(family_.slicePoint);
  if (sliced && !texture) texture = uniforms_.product(family_.textureFromCrop);
  if (!clip || !texture) return refuse("a matrix is not active");
  clipFromData_ = hasDepthsFromZero(shadow_.real, shadow_.rare()) ? toUsualDepths(*clip) : *clip;
  view.textureFromData = *texture;
  if (!isInvertible(clipFromData_) || !isInvertible(view.textureFromData))
    return refuse("a matrix has no inverse");
  const auto texture3 = glm::transpose(view.textureFromData);
  if (texture3[3] != glm::dvec4(0, 0, 0, 1))
    return refuse("the matrix to texture coordinates is a projection");
  if (!readViewer(view)) return false;
  view.step = value(family_.step, glm::vec4(sliced ? 1.0f : 0.0f)).x;
  view.lower = value(family_.lower, glm::vec4(0)), view.upper = value(family_.upper, glm::vec4(1));
  if (!(view.step > 0) || !std::isfinite(view.step)) return refuse("its step is not above 0");
  return true;
}

bool VolumeReader::read(scene::VolumeCast& cast) {
  for (const auto& [name, neutral] : program_.known->family->neutral)
    if (const std::string value = uniforms_.unlike(name, neutral); !value.empty())
      return refuse("uniform \"" + name + "\" is " + value);
  const glm::vec3 spacing = value(family_.cellSpacing, glm::vec4(1));
  if (!glm::all(glm::greaterThan(spacing, glm::vec3(0))))
    return refuse("the spacing of its voxels is not above 0");
  cast.threads = shadow_.settings.threads;
  if (family_.span.given()) return readSpanned(cast);
  if (!readView(cast.view) || !readClipPlanes(cast.view) || !readSlice(cast.view) || !readJitter(cast.view))
    return false;
  // A ray that begins right at the box's face is discarded or not as the real OpenGL rounds.
  if (cast.view.clipping && !cast.view.jitter.empty())
    return refuse("rounding decides which of its jittered rays are clipped");
  return VolumeLookReader(shadow_, uniforms_, why_).read(cast.volume);
}

bool VolumeReader::readDepths(scene::VolumeView& view) {
  view.depth.clear();
  if (family_.depth.empty()) return true;
  const GLint unit = uniforms_.unit(family_.depth);
  if (unit < 0) return true;
  const glm::vec2 texel = value(family_.depthTexel, glm::vec4(0)),
                  origin = value(family_.depthOrigin, glm::vec4(0));
  DepthTexture depths;
  if (!shadow_.textures.depths(shadow_.real, shadow_.rare(), unit, depths))
    return refuse("its depths are no depth texture that can be read");
  view.depth = depths.inRegion(view.region, origin, texel);
  return true;
}

}  // namespace gluray::gl
