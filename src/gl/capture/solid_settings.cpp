#include "gl/capture/solid_settings.h"

namespace gluray::gl {

bool drawsSolids(const Settings& settings, PrimitiveClass kind) {
  return (kind == PrimitiveClass::lines && settings.lines.look == LineLook::tubes) ||
         (kind == PrimitiveClass::points && settings.points.look == PointLook::spheres);
}

bool drawsAnySolids(const Settings& settings) {
  return drawsSolids(settings, PrimitiveClass::lines) || drawsSolids(settings, PrimitiveClass::points);
}

}  // namespace gluray::gl
