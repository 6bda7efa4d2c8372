// parallel/arena.h under this room's name.
#pragma once
#include "parallel/arena.h"

namespace gluray::accel {
using gluray::Arena;
}
