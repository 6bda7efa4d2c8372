// Embree's callbacks for pages, which stand in their structures as one box each. Called on tracing and
// building threads.
#pragma once

struct RTCBoundsFunctionArguments;
struct RTCIntersectFunctionNArguments;
struct RTCOccludedFunctionNArguments;

namespace gluray::accel {

void pageBounds(const RTCBoundsFunctionArguments*);
void intersectPage(const RTCIntersectFunctionNArguments*);
void occludePage(const RTCOccludedFunctionNArguments*);

}  // namespace gluray::accel
