#include "render/paths/added_lights.h"

#include "render/lights/relit.h"

namespace gluray::render {

AddedLights::AddedLights(const FrameData& frame, bool glass) : glass_(glass) {
  if (!frame.relit) return;
  const float size = frame.snapshot->settings.shadows.size;
  for (const scene::LightSource& light : frame.relit->sources)
    if (light.strength > 0 && light.color != glm::vec3(0)) shapes_.emplace_back(light, size);
}

}  // namespace gluray::render
