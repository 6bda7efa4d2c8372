// The shadow state's material after calls whose effect on it is known: draws need not read it back.
#include "gl/capture/captured_vertices.h"
#include "gl/shadow/shadow_state.h"

#include <glm/gtc/type_ptr.hpp>

namespace gluray::gl {

// The real OpenGL changes the material when it stores a colour that differs from the stored one. If the
// material has the stored colour, it thus always has the newest one, unless held-back materials come after
// it.
void ShadowState::followColor() {
  if (isDirty(kLighting | kMaterial) || !follows_ || latch.waits() || current.holdsMaterials())
    return touch(kMaterial);
  material_ = materialOfColor(material_, shading_.colorMaterial, current[kColor]);
}

glm::vec4 ShadowState::colorOfMaterial() {
  const glm::vec4 color = glm::make_vec4(current[kColor]);
  if (!latch.isOn()) return color;
  using Mode = scene::ColorMaterial;
  const Mode::Mode mode = shading().colorMaterial.front;
  if (!shading_.lighting || mode == Mode::off) return color;
  const scene::Material& front = material().front;
  switch (mode) {
    case Mode::emission: return front.emission;
    case Mode::ambient: return front.ambient;
    case Mode::specular: return front.specular;
    default: return front.diffuse;
  }
}

void ShadowState::materialSet(const MaterialChange& change) {
  // Without lighting it is unknown whether the material follows the colour.
  if (isDirty(kLighting | kMaterial) || !shading_.lighting ||
      shading_.colorMaterial != scene::ColorMaterial{})
    return touch(kMaterial);
  material_ = change.appliedTo(material_);
}

}  // namespace gluray::gl
