#include "gl/views/secondary_scene_builder.h"

#include "scene/world_space.h"

#include <algorithm>

namespace gluray::gl {
namespace {

/// The surface as it would be drawn by a camera from whose eye space `eyeFromPart` leads, after what is seen
/// has moved.
scene::Instance seenFrom(scene::Instance instance, const glm::dmat4& eyeFromPart, const glm::dmat4& moved) {
  const glm::dmat4 before = instance.eyeFromObject;
  if (moved != glm::dmat4(1)) {
    const glm::dmat4 lighting(instance.lightingFromObject), back = glm::inverse(before);
    const glm::dmat4 lit = lighting * back * moved * before;
    instance.normalMatrix = glm::mat3(glm::dmat3(lit * glm::inverse(lighting))) * instance.normalMatrix;
    instance.lightingFromObject = glm::mat4(lit);
  }
  const glm::dmat4 eye = eyeFromPart * moved;
  instance.eyeFromObject = eye * before;
  const glm::dmat4 planes = glm::inverse(eye);
  for (glm::dvec4& plane : instance.clipPlanes) plane = plane * planes;
  return instance;
}

}  // namespace

SecondarySceneBuilder::SecondarySceneBuilder(const scene::Snapshot& of)
    : of_(of),
      worldFromEye_(glm::inverse(of.eyeFromWorld)),
      made_(std::make_shared<scene::SecondaryScene>()) {
  skip(of);
}

bool SecondarySceneBuilder::isNew(const scene::Instance& instance) {
  const glm::dmat4 matrix = instance.eyeFromObject + 0.0;  // -0 is 0
  const Hash128 place = hashBytes(&matrix, sizeof matrix, instance.mesh->geometryId);
  const auto [first, last] = seen_.equal_range(place);
  for (auto it = first; it != last; ++it)
    if (it->second->clipPlanes == instance.clipPlanes) return false;
  seen_.emplace(place, &instance);
  return true;
}

bool SecondarySceneBuilder::isNew(const scene::PlacedVolume& volume) {
  const bool seen = std::any_of(volumes_.begin(), volumes_.end(), [&](const scene::PlacedVolume* other) {
    return other->eyeFromData == volume.eyeFromData && scene::blockAlike(*other->medium, *volume.medium);
  });
  if (!seen) volumes_.push_back(&volume);
  return !seen;
}

void SecondarySceneBuilder::skip(const scene::Snapshot& part) {
  for (const scene::Instance& instance : part.instances) isNew(instance);
  for (const scene::PlacedVolume& volume : part.volumes) isNew(volume);
}

void SecondarySceneBuilder::add(const scene::Snapshot& part, const glm::dmat4& eyeFromPart,
                                const std::shared_ptr<const scene::FramebufferCapture>& capture,
                                const std::vector<uint8_t>& erased, const glm::dmat4& moved) {
  for (const scene::PlacedVolume& volume : part.volumes)
    if (isNew(volume)) made_->volumes.push_back({volume.medium, eyeFromPart * moved * volume.eyeFromData});
  const auto shadings = static_cast<uint32_t>(made_->shadings.size());
  const bool inPlace = eyeFromPart == glm::dmat4(1) && moved == glm::dmat4(1);
  const size_t before = made_->instances.size();
  for (size_t i = 0; i < part.instances.size(); ++i) {
    const scene::Instance& instance = part.instances[i];
    if ((!erased.empty() && erased[i]) || !isNew(instance)) continue;
    scene::Instance& added =
        made_->instances.emplace_back(inPlace ? instance : seenFrom(instance, eyeFromPart, moved));
    added.shading += shadings;
    added.worldFromObject = scene::worldFromObject(added, of_.eyeFromWorld, worldFromEye_);
    made_->blended.push_back(part.layers != nullptr);
    if (!capture) continue;
    made_->captured.resize(made_->instances.size());
    made_->captured.back() = {static_cast<uint32_t>(made_->captures.size()),
                              part.camera.clipFromEye * instance.eyeFromObject};
  }
  if (made_->instances.size() == before) return;
  if (capture) made_->captures.push_back(capture);
  made_->shadings.insert(made_->shadings.end(), part.shadings.begin(), part.shadings.end());
}

std::shared_ptr<const scene::SecondaryScene> SecondarySceneBuilder::takeSecondaryScene(
    const glm::dmat4& viewFromWorld) {
  if (made_->instances.empty() && made_->volumes.empty()) return nullptr;
  made_->viewFromWorld = viewFromWorld;
  return std::move(made_);
}

}  // namespace gluray::gl
