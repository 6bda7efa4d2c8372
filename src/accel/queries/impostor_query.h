// Embree's callbacks for impostors. Private to accel/; called on tracing threads.
#pragma once

struct RTCIntersectFunctionNArguments;
struct RTCOccludedFunctionNArguments;

namespace gluray::accel {

void intersectImpostors(const RTCIntersectFunctionNArguments*);
void occludeImpostors(const RTCOccludedFunctionNArguments*);

}  // namespace gluray::accel
