// Embree's callbacks for impostors. Private to accel/; called on tracing threads.
#pragma once

struct RTCBoundsFunctionArguments;
struct RTCIntersectFunctionNArguments;
struct RTCOccludedFunctionNArguments;

namespace gluray::accel {

void intersectImpostors(const RTCIntersectFunctionNArguments*);
void occludeImpostors(const RTCOccludedFunctionNArguments*);

/// Of geometries whose user data is CapsuleBundles; hits are those of the single capsules.
void capsuleBundleBounds(const RTCBoundsFunctionArguments*);
void intersectCapsuleBundles(const RTCIntersectFunctionNArguments*);
void occludeCapsuleBundles(const RTCOccludedFunctionNArguments*);

}  // namespace gluray::accel
