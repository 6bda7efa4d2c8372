// Embree's callback for impostors. Private to accel/; called on tracing threads.
#pragma once

struct RTCIntersectFunctionNArguments;

namespace gluray::accel {

void intersectImpostors(const RTCIntersectFunctionNArguments*);

}  // namespace gluray::accel
