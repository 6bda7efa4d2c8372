// Includes Embree 3 or 4, whichever CMake found; no other file includes it. Private to accel/, any thread.
#pragma once
#include "accel/rays/ray_packet.h"

#if GLURAY_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <glm/glm.hpp>

namespace gluray::accel {

#if GLURAY_EMBREE_MAJOR >= 4
using RtcQueryContext = RTCRayQueryContext;
constexpr RTCSceneFlags kFilterInQuery = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;
#else
using RtcQueryContext = RTCIntersectContext;
constexpr RTCSceneFlags kFilterInQuery = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;
#endif

/// Query context passed to the filter callback. Embree's context comes first, so pointers to the two convert
/// by cast.
struct QueryContext {
  RtcQueryContext rtc;
  const void* user = nullptr;
#if GLURAY_EMBREE_MAJOR >= 4
  // Of the query, for queries within it.
  RTCFilterFunctionN filter = nullptr;
  RTCRayQueryFlags flags = RTC_RAY_QUERY_FLAG_NONE;
#endif
};

/// Origin and direction of one ray of a packet, in the space that the callback is called in.
inline glm::vec3 originOf(RTCRayN* ray, unsigned count, unsigned i) {
  return {RTCRayN_org_x(ray, count, i), RTCRayN_org_y(ray, count, i), RTCRayN_org_z(ray, count, i)};
}
inline glm::vec3 directionOf(RTCRayN* ray, unsigned count, unsigned i) {
  return {RTCRayN_dir_x(ray, count, i), RTCRayN_dir_y(ray, count, i), RTCRayN_dir_z(ray, count, i)};
}

/// One query of a packet of N rays. `filter` may be null.
class PacketQuery {
 public:
  explicit PacketQuery(Coherence coherence, RTCFilterFunctionN filter = nullptr, const void* user = nullptr) {
    const bool coherent = coherence == Coherence::coherent;
#if GLURAY_EMBREE_MAJOR >= 4
    rtcInitRayQueryContext(&context_.rtc);
    rtcInitIntersectArguments(&arguments_);
    rtcInitOccludedArguments(&occludedArguments_);
    int flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    if (filter) flags |= RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    arguments_.context = occludedArguments_.context = &context_.rtc;
    arguments_.filter = occludedArguments_.filter = filter;
    arguments_.flags = occludedArguments_.flags = context_.flags = static_cast<RTCRayQueryFlags>(flags);
    context_.filter = filter;
#else
    rtcInitIntersectContext(&context_.rtc);
    context_.rtc.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    context_.rtc.filter = filter;
#endif
    context_.user = user;
  }
  PacketQuery(const PacketQuery&) = delete;
  PacketQuery& operator=(const PacketQuery&) = delete;

  // Lanes with valid[i] = -1 are traced. Hits are written into the packet; of occluded rays tfar becomes
  // minus infinity.
#if GLURAY_EMBREE_MAJOR >= 4
  void intersect(const int* valid, RTCScene s, RTCRayHit16& p) { rtcIntersect16(valid, s, &p, &arguments_); }
  void intersect(const int* valid, RTCScene s, RTCRayHit8& p) { rtcIntersect8(valid, s, &p, &arguments_); }
  void intersect(const int* valid, RTCScene s, RTCRayHit4& p) { rtcIntersect4(valid, s, &p, &arguments_); }
  void occluded(const int* valid, RTCScene s, RTCRay16& p) {
    rtcOccluded16(valid, s, &p, &occludedArguments_);
  }
  void occluded(const int* valid, RTCScene s, RTCRay8& p) { rtcOccluded8(valid, s, &p, &occludedArguments_); }
  void occluded(const int* valid, RTCScene s, RTCRay4& p) { rtcOccluded4(valid, s, &p, &occludedArguments_); }
#else
  void intersect(const int* valid, RTCScene s, RTCRayHit16& p) {
    rtcIntersect16(valid, s, &context_.rtc, &p);
  }
  void intersect(const int* valid, RTCScene s, RTCRayHit8& p) { rtcIntersect8(valid, s, &context_.rtc, &p); }
  void intersect(const int* valid, RTCScene s, RTCRayHit4& p) { rtcIntersect4(valid, s, &context_.rtc, &p); }
  void occluded(const int* valid, RTCScene s, RTCRay16& p) { rtcOccluded16(valid, s, &context_.rtc, &p); }
  void occluded(const int* valid, RTCScene s, RTCRay8& p) { rtcOccluded8(valid, s, &context_.rtc, &p); }
  void occluded(const int* valid, RTCScene s, RTCRay4& p) { rtcOccluded4(valid, s, &context_.rtc, &p); }
#endif

 private:
  QueryContext context_;
#if GLURAY_EMBREE_MAJOR >= 4
  RTCIntersectArguments arguments_;
  RTCOccludedArguments occludedArguments_;
#endif
};

// Nested queries, for callbacks that forward rays to another scene. Context, lanes and layout are those of
// the callback. `valid` is aligned to 64 bytes.
#if GLURAY_EMBREE_MAJOR >= 4
inline void intersectWithin(RtcQueryContext* context, RTCScene scene, unsigned count, const int* valid,
                            RTCRayHitN* rays) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  const auto& query = *reinterpret_cast<const QueryContext*>(context);
  arguments.context = context, arguments.filter = query.filter, arguments.flags = query.flags;
  switch (count) {
    case 16: return rtcIntersect16(valid, scene, reinterpret_cast<RTCRayHit16*>(rays), &arguments);
    case 8: return rtcIntersect8(valid, scene, reinterpret_cast<RTCRayHit8*>(rays), &arguments);
    case 4: return rtcIntersect4(valid, scene, reinterpret_cast<RTCRayHit4*>(rays), &arguments);
    default: return rtcIntersect1(scene, reinterpret_cast<RTCRayHit*>(rays), &arguments);
  }
}
inline void occludeWithin(RtcQueryContext* context, RTCScene scene, unsigned count, const int* valid,
                          RTCRayN* rays) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  const auto& query = *reinterpret_cast<const QueryContext*>(context);
  arguments.context = context, arguments.filter = query.filter, arguments.flags = query.flags;
  switch (count) {
    case 16: return rtcOccluded16(valid, scene, reinterpret_cast<RTCRay16*>(rays), &arguments);
    case 8: return rtcOccluded8(valid, scene, reinterpret_cast<RTCRay8*>(rays), &arguments);
    case 4: return rtcOccluded4(valid, scene, reinterpret_cast<RTCRay4*>(rays), &arguments);
    default: return rtcOccluded1(scene, reinterpret_cast<RTCRay*>(rays), &arguments);
  }
}
#else
inline void intersectWithin(RtcQueryContext* context, RTCScene scene, unsigned count, const int* valid,
                            RTCRayHitN* rays) {
  switch (count) {
    case 16: return rtcIntersect16(valid, scene, context, reinterpret_cast<RTCRayHit16*>(rays));
    case 8: return rtcIntersect8(valid, scene, context, reinterpret_cast<RTCRayHit8*>(rays));
    case 4: return rtcIntersect4(valid, scene, context, reinterpret_cast<RTCRayHit4*>(rays));
    default: return rtcIntersect1(scene, context, reinterpret_cast<RTCRayHit*>(rays));
  }
}
inline void occludeWithin(RtcQueryContext* context, RTCScene scene, unsigned count, const int* valid,
                          RTCRayN* rays) {
  switch (count) {
    case 16: return rtcOccluded16(valid, scene, context, reinterpret_cast<RTCRay16*>(rays));
    case 8: return rtcOccluded8(valid, scene, context, reinterpret_cast<RTCRay8*>(rays));
    case 4: return rtcOccluded4(valid, scene, context, reinterpret_cast<RTCRay4*>(rays));
    default: return rtcOccluded1(scene, context, reinterpret_cast<RTCRay*>(rays));
  }
}
#endif

}  // namespace gluray::accel
