// Window depth and facing of hits. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_DEPTH_INL_H_
#undef GLURAY_RENDER_DEPTH_INL_H_
#else
#define GLURAY_RENDER_DEPTH_INL_H_
#endif

#include "render/camera/rays.inl.h"
#include "render/frame_data/frame_data.h"
#include "render/local/attributes.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

struct DoublePlane {
  Double n[3], w;
};

/// Triangles: their first corner, and the edges from there to the other two.
struct DoubleTriangle {
  Double corner[3], edge[2][3];
};

HWY_INLINE DoubleTriangle cornersOf(const Group& group, int i) {
  DoubleTriangle t;
  for (int c = 0; c < 3; ++c) {
    t.corner[c] = loadDouble(group.position[0][c] + i);
    for (int k = 0; k < 2; ++k) t.edge[k][c] = hn::Sub(loadDouble(group.position[k + 1][c] + i), t.corner[c]);
  }
  return t;
}

HWY_INLINE DoublePlane planeOf(const DoubleTriangle& t) {
  DoublePlane plane;
  for (int c = 0; c < 3; ++c) {
    const int y = (c + 1) % 3, z = (c + 2) % 3;
    plane.n[c] = hn::MulSub(t.edge[0][y], t.edge[1][z], hn::Mul(t.edge[0][z], t.edge[1][y]));
  }
  plane.w = hn::Neg(hn::MulAdd(plane.n[0], t.corner[0],
                               hn::MulAdd(plane.n[1], t.corner[1], hn::Mul(plane.n[2], t.corner[2]))));
  return plane;
}

HWY_INLINE Double dot(const DoublePlane& plane, const glm::dvec4& v) {
  return hn::MulAdd(plane.w, hn::Set(DoubleTag(), v.w), dot3(plane.n, v));
}

struct DepthAndFacing {
  alignas(64) float depth[kLanes];  // window, [0, 1]
  uint32_t ccw = 0;                 // bit i: lane i's triangle is counterclockwise in the window
  alignas(64) Row u, v;             // of triangles: the plane's point at the window position, as in Group
};

/// Polygon offset, for a float depth buffer, of the triangles of the lanes from `first` on.
HWY_ATTR inline Double floatOffsets(const Surface& surface, const DepthMap& map, const Group& group,
                                    int first) {
  const DoubleTag d;
  alignas(64) double offsets[8] = {};
  for (int k = 0; k < static_cast<int>(hn::Lanes(d)); ++k) {
    if (!(group.lanes >> (first + k) & 1)) continue;
    const glm::dvec2 depths = surface.ndcDepths(group.primitive[first + k]);
    offsets[k] = map.constantOf(depths.x, depths.y) - map.constant;
  }
  return hn::Load(d, offsets);
}

/// Depth of a point of a triangle that is seen edge-on.
HWY_INLINE float depthFromCorners(const Surface& surface, const DepthMap& map, uint32_t primitive, float u,
                                  float v) {
  // The ground reaches beyond the near and the far plane. There its depth is next to theirs, so that the
  // ground is still before what was cleared.
  const double most = surface.instance->ground ? 1 - 0x1p-22 : 1.0;
  const double ndc = std::clamp(surface.ndcDepth(primitive, u, v), -most, most);
  const glm::dvec2 depths = surface.ndcDepths(primitive);
  const double offset = map.offset + map.constantOf(depths.x, depths.y);
  return static_cast<float>(std::clamp(ndc * map.scale + offset, 0.0, 1.0));
}

/// The depth planes of a group's triangles over the window, for depths elsewhere in the pixel.
struct PlaneRows {
  alignas(64) double ndc[kLanes], slopeX[kLanes], slopeY[kLanes];  // NDC depth, and its change per pixel
  alignas(64) double offset[kLanes];                               // window depth: the polygon offset
};

/// Lines of sight through window positions, in object space: each is the intersection of the plane of equal
/// window x and the plane of equal window y.
class Sights {
 public:
  Sights(const Surface& s, const glm::ivec4& viewport)
      : window_(viewport), rows_(glm::transpose(s.clipFromObject)) {}

  /// Intersects each triangle's plane with the line of sight at window positions x, y; returns weights u, v
  /// of the second and third corner. Perspective weights are edge functions, up to a factor (Olano and Greer,
  /// 1997). Lanes without an intersection keep their weights.
  HWY_INLINE void weights(const DoubleTriangle& t, Double x, Double y, float* u, float* v) const {
    const DoubleTag d;
    const Double ndcX = hn::MulAdd(x, hn::Set(d, window_.ndcScale.x), hn::Set(d, window_.ndcOffset.x));
    const Double ndcY = hn::MulAdd(y, hn::Set(d, window_.ndcScale.y), hn::Set(d, window_.ndcOffset.y));
    const DoublePlane a = planeAt(0, ndcX), b = planeAt(1, ndcY);
    const Double a0 = hn::Add(along(a, t.corner), a.w), b0 = hn::Add(along(b, t.corner), b.w);
    const Double a1 = along(a, t.edge[0]), b1 = along(b, t.edge[0]);
    const Double a2 = along(a, t.edge[1]), b2 = along(b, t.edge[1]);
    const Double inverse = hn::Div(hn::Set(d, 1.0), hn::MulSub(a1, b2, hn::Mul(a2, b1)));
    const Double second = hn::Mul(hn::MulSub(a2, b0, hn::Mul(a0, b2)), inverse);
    const Double third = hn::Mul(hn::MulSub(a0, b1, hn::Mul(a1, b0)), inverse);
    const Double most = hn::Set(d, 1e6);  // comparisons fail for NaN
    const auto seen = hn::And(hn::Lt(hn::Abs(second), most), hn::Lt(hn::Abs(third), most));
    storeFloat(hn::IfThenElse(seen, second, loadDouble(u)), u);
    storeFloat(hn::IfThenElse(seen, third, loadDouble(v)), v);
  }

 private:
  /// The plane of all points with this NDC x or y.
  HWY_INLINE DoublePlane planeAt(int axis, Double ndc) const {
    const DoubleTag d;
    DoublePlane plane;
    for (int c = 0; c < 3; ++c)
      plane.n[c] = hn::NegMulAdd(ndc, hn::Set(d, rows_[3][c]), hn::Set(d, rows_[axis][c]));
    plane.w = hn::NegMulAdd(ndc, hn::Set(d, rows_[3].w), hn::Set(d, rows_[axis].w));
    return plane;
  }
  HWY_INLINE static Double along(const DoublePlane& plane, const Double (&v)[3]) {
    return hn::MulAdd(plane.n[0], v[0], hn::MulAdd(plane.n[1], v[1], hn::Mul(plane.n[2], v[2])));
  }
  WindowMap window_;
  glm::dmat4 rows_;
};

/// Window depth of the group's triangles at window positions x, y, exactly as OpenGL interpolates it, with
/// glDepthRange and glPolygonOffset (GL 2.1, 3.5.5); and the points there. Lanes outside the group are
/// undefined.
HWY_ATTR inline void computeDepth(const FrameData& frame, const Surface& surface, const Group& group,
                                  const float* x, const float* y, DepthAndFacing& out,
                                  PlaneRows* planes = nullptr) {
  const DepthMap& map = frame.depth;
  const Sights sights(surface, frame.snapshot->camera.viewport);
  const DoubleTag d;
  const Double one = hn::Set(d, 1.0), minusOne = hn::Set(d, -1.0);
  const bool hasOffset = map.slopeFactor != 0 || map.constant != 0 || map.floatUnits != 0;
  uint32_t doubtful = 0;  // lanes whose triangle is seen edge-on
  out.ccw = 0;
  std::copy_n(group.u, kLanes, out.u), std::copy_n(group.v, kLanes, out.v);
  for (int i = 0; i < kLanes; i += static_cast<int>(hn::Lanes(d))) {
    const DoubleTriangle triangle = cornersOf(group, i);
    const DoublePlane plane = planeOf(triangle);
    const Double windowX = loadDouble(x + i), windowY = loadDouble(y + i);
    const Double b = dot(plane, surface.depth.b);
    const Double inverse = hn::Div(minusOne, b);
    const Double slopeX = hn::Mul(dot(plane, surface.depth.aX), inverse);
    const Double slopeY = hn::Mul(dot(plane, surface.depth.aY), inverse);
    const Double atOrigin = hn::Mul(dot(plane, surface.depth.a), inverse);
    const Double ndc = hn::MulAdd(windowX, slopeX, hn::MulAdd(windowY, slopeY, atOrigin));
    Double depth = hn::MulAdd(ndc, hn::Set(d, map.scale), hn::Set(d, map.offset));
    Double offset = hn::Zero(d);
    if (hasOffset) {
      const Double slope = map.euclidean ? hn::Sqrt(hn::MulAdd(slopeX, slopeX, hn::Mul(slopeY, slopeY)))
                                         : hn::Max(hn::Abs(slopeX), hn::Abs(slopeY));
      const Double steepest = hn::Mul(slope, hn::Set(d, std::abs(map.scale)));
      offset = hn::MulAdd(steepest, hn::Set(d, map.slopeFactor), hn::Set(d, map.constant));
      if (map.floatUnits != 0) offset = hn::Add(offset, floatOffsets(surface, map, group, i));
      depth = hn::Add(depth, offset);
    }
    if (planes) {
      hn::Store(ndc, d, planes->ndc + i), hn::Store(offset, d, planes->offset + i);
      hn::Store(slopeX, d, planes->slopeX + i), hn::Store(slopeY, d, planes->slopeY + i);
    }
    storeFloat(hn::Min(hn::Max(depth, hn::Zero(d)), one), out.depth + i);
    sights.weights(triangle, windowX, windowY, out.u + i, out.v + i);

    uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Gt(hn::Mul(b, hn::Set(d, surface.depth.areaSign)), hn::Zero(d)), bits);
    out.ccw |= static_cast<uint32_t>(bits[0]) << i;
    hn::StoreMaskBits(d, hn::Not(hn::Le(hn::Abs(ndc), hn::Set(d, 1.0 + 1e-6))), bits);
    doubtful |= static_cast<uint32_t>(bits[0]) << i;
  }
  for (doubtful &= group.lanes; doubtful; doubtful &= doubtful - 1) {
    const int i = std::countr_zero(doubtful);
    out.depth[i] = depthFromCorners(surface, map, group.primitive[i], group.u[i], group.v[i]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
