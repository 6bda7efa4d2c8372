#include "gl/batch/address_space_gate.h"

#include "base/address_space.h"

namespace gluray::gl {

bool addressSpaceIsShort() noexcept { return glurayAddressSpaceLeft() < glurayFrameReserve; }

}  // namespace gluray::gl
