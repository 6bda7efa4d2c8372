// Includes Embree 3 or 4, whichever CMake found; no other file includes it. Private to accel/, any thread.
#pragma once
#if GLURAY_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

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
};

/// One coherent query of a packet of N rays. `filter` may be null.
class CoherentQuery {
 public:
  explicit CoherentQuery(RTCFilterFunctionN filter = nullptr, const void* user = nullptr) {
#if GLURAY_EMBREE_MAJOR >= 4
    rtcInitRayQueryContext(&context_.rtc);
    rtcInitIntersectArguments(&arguments_);
    arguments_.context = &context_.rtc;
    arguments_.filter = filter;
    arguments_.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    if (filter) {
      arguments_.flags =
          static_cast<RTCRayQueryFlags>(arguments_.flags | RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER);
    }
#else
    rtcInitIntersectContext(&context_.rtc);
    context_.rtc.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    context_.rtc.filter = filter;
#endif
    context_.user = user;
  }
  CoherentQuery(const CoherentQuery&) = delete;
  CoherentQuery& operator=(const CoherentQuery&) = delete;

  // Lanes with valid[i] = -1 are traced; hits are written into the packet.
#if GLURAY_EMBREE_MAJOR >= 4
  void intersect(const int* valid, RTCScene s, RTCRayHit16& p) { rtcIntersect16(valid, s, &p, &arguments_); }
  void intersect(const int* valid, RTCScene s, RTCRayHit8& p) { rtcIntersect8(valid, s, &p, &arguments_); }
  void intersect(const int* valid, RTCScene s, RTCRayHit4& p) { rtcIntersect4(valid, s, &p, &arguments_); }
#else
  void intersect(const int* valid, RTCScene s, RTCRayHit16& p) {
    rtcIntersect16(valid, s, &context_.rtc, &p);
  }
  void intersect(const int* valid, RTCScene s, RTCRayHit8& p) { rtcIntersect8(valid, s, &context_.rtc, &p); }
  void intersect(const int* valid, RTCScene s, RTCRayHit4& p) { rtcIntersect4(valid, s, &context_.rtc, &p); }
#endif

 private:
  QueryContext context_;
#if GLURAY_EMBREE_MAJOR >= 4
  RTCIntersectArguments arguments_;
#endif
};

}  // namespace gluray::accel
