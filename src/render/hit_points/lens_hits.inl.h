// Where hits of rays through a lens lie: depths, facing, and the window positions at which the viewpoint sees
// them. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_LENS_HITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_LENS_HITS_INL_H_
#undef GLURAY_RENDER_LENS_HITS_INL_H_
#else
#define GLURAY_RENDER_LENS_HITS_INL_H_
#endif

#include "render/hit_points/impostor.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Clip coordinate `row` of a point.
HWY_INLINE Double clipOf(const glm::dmat4& clipFromPoint, int row, const Double (&p)[3]) {
  const glm::dvec4 m(clipFromPoint[0][row], clipFromPoint[1][row], clipFromPoint[2][row],
                     clipFromPoint[3][row]);
  return hn::Add(dot3(p, m), splatDouble(m.w));
}

/// Puts the window positions of points into x and y, and returns their NDC depths.
HWY_INLINE Double toWindow(const glm::dmat4& clipFromPoint, const WindowMap& window, const Double (&p)[3],
                           float* x, float* y) {
  const Double inverse = hn::Div(splatDouble(1), clipOf(clipFromPoint, 3, p));
  const auto put = [&](int axis, float* to) HWY_ATTR {
    const Double ndc = hn::Mul(clipOf(clipFromPoint, axis, p), inverse);
    storeFloat(hn::Div(hn::Sub(ndc, splatDouble(window.ndcOffset[axis])), splatDouble(window.ndcScale[axis])),
               to);
  };
  put(0, x), put(1, y);
  return hn::Mul(clipOf(clipFromPoint, 2, p), inverse);
}

/// dot(plane, the point of the lens that lane i's ray leaves), up to a positive factor.
HWY_INLINE Double facingOf(const Surface& s, const OpenLens& lens, const DoublePlane& plane, int i) {
  const LensShear& shear = lens.shear;
  const Double aside =
      hn::MulAdd(loadDouble(lens.points.x + i), dot3(plane.n, glm::dvec4(shear.right, 0)),
                 hn::Mul(loadDouble(lens.points.y + i), dot3(plane.n, glm::dvec4(shear.up, 0))));
  return hn::MulAdd(aside, splatDouble(glm::dot(shear.along, s.depth.b)), dot(plane, s.depth.b));
}

/// Depths and facing of a group of triangles, whose u and v stay, and where the viewpoint sees them. `lens`:
/// in object space.
HWY_ATTR inline void seeTriangles(const FrameData& frame, const Surface& s, const OpenLens& lens,
                                  const Group& group, DepthAndFacing& out, float* x, float* y) {
  const DoubleTag d;
  const DepthMap& map = frame.depth;
  const WindowMap window(frame.snapshot->camera.viewport);
  alignas(64) double ndc[kLanes];
  uint32_t ccw = 0;
  for (int i = 0; i < kLanes; i += static_cast<int>(hn::Lanes(d))) {
    const DoubleTriangle t = cornersOf(group, i);
    const Double u = loadDouble(group.u + i), v = loadDouble(group.v + i);
    Double point[3];
    for (int c = 0; c < 3; ++c)
      point[c] = hn::MulAdd(v, t.edge[1][c], hn::MulAdd(u, t.edge[0][c], t.corner[c]));
    hn::Store(toWindow(s.clipFromObject, window, point, x + i, y + i), d, ndc + i);
    const Double facing = hn::Mul(facingOf(s, lens, planeOf(t), i), splatDouble(s.depth.areaSign));
    uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Gt(facing, hn::Zero(d)), bits);
    ccw |= static_cast<uint32_t>(bits[0]) << i;
  }
  PlaneRows planes;
  const bool offset = map.slopeFactor != 0 || map.constant != 0 || map.floatUnits != 0;
  if (offset) computeDepth(frame, s, group, x, y, out, &planes);
  for (int i = 0; i < kLanes; ++i) {
    const double depth = ndc[i] * map.scale + map.offset + (offset ? planes.offset[i] : 0);
    out.depth[i] = static_cast<float>(std::clamp(depth, 0.0, 1.0));
  }
  out.ccw = ccw;
  std::copy_n(group.u, kLanes, out.u), std::copy_n(group.v, kLanes, out.v);
}

/// Where the viewpoint sees the hits of `lanes`; others keep their positions.
HWY_ATTR inline void seePoints(const FrameData& frame, const accel::RayPacket& hit, uint32_t lanes, float* x,
                               float* y) {
  const scene::Snapshot& s = *frame.snapshot;
  const WindowMap window(s.camera.viewport);
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const double t = hit.tFar[i];
    const glm::dvec4 world(hit.orgX[i] + t * hit.dirX[i], hit.orgY[i] + t * hit.dirY[i],
                           hit.orgZ[i] + t * hit.dirZ[i], 1);
    const glm::dvec4 clip = s.camera.clipFromEye * (s.eyeFromWorld * world);
    const glm::dvec2 at = (glm::dvec2(clip) / clip.w - window.ndcOffset) / window.ndcScale;
    x[i] = static_cast<float>(at.x), y[i] = static_cast<float>(at.y);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
