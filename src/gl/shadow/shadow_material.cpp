// The shadow state's material after calls whose effect on it is known: draws need not read it back.
#include "gl/capture/captured_vertices.h"
#include "gl/shadow/shadow_state.h"

namespace gluray::gl {

// The real OpenGL changes the material when it stores a colour that differs from the stored one. If the
// material has the stored colour, it thus always has the newest one, unless held-back materials come after
// it.
void ShadowState::followColor() {
  if (isDirty(kLighting | kMaterial) || !follows_ || latch.waits() || current.holdsMaterials())
    return touch(kMaterial);
  material_ = materialOfColor(material_, shading_.colorMaterial, current[kColor]);
}

void ShadowState::materialSet(const MaterialChange& change) {
  // Without lighting it is unknown whether the material follows the colour.
  if (isDirty(kLighting | kMaterial) || !shading_.lighting ||
      shading_.colorMaterial != scene::ColorMaterial{})
    return touch(kMaterial);
  material_ = change.appliedTo(material_);
}

}  // namespace gluray::gl
