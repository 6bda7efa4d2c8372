// A photographer's studio as an environment: soft boxes before grey walls. Any thread.
#pragma once
#include "render/lights/sky_image.h"

namespace gluray::render {

/// y is up; the viewer is at +z. A large soft box stands above, one on each side in front, and a narrow one
/// on each side behind. The walls between them fade from light grey above to dark grey below, so that rounded
/// metal has bright and dark bands. Scaled so that the mean over all directions is 1: as much light as from
/// `constant`.
SkyPixels studio();

}  // namespace gluray::render
