// Embree's callback for figures. Private to accel/; called on tracing threads.
#pragma once

struct RTCIntersectFunctionNArguments;

namespace gluray::accel {

void intersectFigures(const RTCIntersectFunctionNArguments*);

}  // namespace gluray::accel
