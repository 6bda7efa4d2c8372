// Window depth and facing of hits. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_DEPTH_INL_H_
#undef GLURAY_RENDER_DEPTH_INL_H_
#else
#define GLURAY_RENDER_DEPTH_INL_H_
#endif

#include "render/attributes.inl.h"
#include "render/frame_data.h"
#include "render/rays.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

struct DoublePlane {
  Double n[3], w;
};

HWY_INLINE DoublePlane planeOfCorners(const Group& group, int i) {
  const DoubleTag d;
  Double p[3][3];
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 3; ++c) p[k][c] = loadDouble(group.position[k][c] + i);
  }
  Double a[3], b[3];
  for (int c = 0; c < 3; ++c) a[c] = hn::Sub(p[1][c], p[0][c]), b[c] = hn::Sub(p[2][c], p[0][c]);
  DoublePlane plane;
  for (int c = 0; c < 3; ++c) {
    const int y = (c + 1) % 3, z = (c + 2) % 3;
    plane.n[c] = hn::MulSub(a[y], b[z], hn::Mul(a[z], b[y]));
  }
  plane.w =
      hn::Neg(hn::MulAdd(plane.n[0], p[0][0], hn::MulAdd(plane.n[1], p[0][1], hn::Mul(plane.n[2], p[0][2]))));
  (void)d;
  return plane;
}

HWY_INLINE Double dot(const DoublePlane& plane, const glm::dvec4& v) {
  return hn::MulAdd(plane.w, hn::Set(DoubleTag(), v.w), dot3(plane.n, v));
}

struct DepthAndFacing {
  alignas(64) float depth[kLanes];  // window, [0, 1]
  uint32_t ccw = 0;                 // bit i: lane i's triangle is counterclockwise in the window
};

/// What polygon offset adds in a depth buffer of floats to the triangles of the lanes from `first` on.
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
  const double ndc = std::clamp(surface.ndcDepth(primitive, u, v), -1.0, 1.0);
  const glm::dvec2 depths = surface.ndcDepths(primitive);
  const double offset = map.offset + map.constantOf(depths.x, depths.y);
  return static_cast<float>(std::clamp(ndc * map.scale + offset, 0.0, 1.0));
}

/// The planes of a group's triangles over the window, for depths elsewhere in the pixel.
struct PlaneRows {
  alignas(64) double ndc[kLanes], slopeX[kLanes], slopeY[kLanes];  // NDC depth, and a pixel further
  alignas(64) double offset[kLanes];                               // window depth: the polygon offset
};

/// Depth at window positions x, y of the planes of the group's triangles, exactly as OpenGL interpolates it,
/// through glDepthRange and glPolygonOffset (GL 2.1, 3.5.5). Lanes outside the group hold no meaning.
HWY_ATTR inline void computeDepth(const Surface& surface, const DepthMap& map, const Group& group,
                                  const float* x, const float* y, DepthAndFacing& out,
                                  PlaneRows* planes = nullptr) {
  const DoubleTag d;
  const Double one = hn::Set(d, 1.0), minusOne = hn::Set(d, -1.0);
  const bool hasOffset = map.slopeFactor != 0 || map.constant != 0 || map.floatUnits != 0;
  uint32_t doubtful = 0;  // lanes whose triangle is seen edge-on
  out.ccw = 0;
  for (int i = 0; i < kLanes; i += static_cast<int>(hn::Lanes(d))) {
    const DoublePlane plane = planeOfCorners(group, i);
    const Double b = dot(plane, surface.depth.b);
    const Double inverse = hn::Div(minusOne, b);
    const Double slopeX = hn::Mul(dot(plane, surface.depth.aX), inverse);
    const Double slopeY = hn::Mul(dot(plane, surface.depth.aY), inverse);
    const Double atOrigin = hn::Mul(dot(plane, surface.depth.a), inverse);
    const Double ndc = hn::MulAdd(loadDouble(x + i), slopeX, hn::MulAdd(loadDouble(y + i), slopeY, atOrigin));
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

/// Moves the group's points to where the planes of its triangles are seen at window positions x, y: weights
/// of the corners in perspective are, up to a factor, the edge functions there (Olano and Greer, 1997).
HWY_ATTR inline void moveInPlanes(const Surface& s, const WindowMap& map, const float* x, const float* y,
                                  Group& group) {
  const DoubleTag d;
  const glm::dmat4 m = glm::transpose(s.clipFromObject);
  const glm::dvec4 rows[3] = {m[0], m[1], m[3]};  // x, y, w
  for (int i = 0; i < kLanes; i += static_cast<int>(hn::Lanes(d))) {
    Double clip[3][3];
    for (int k = 0; k < 3; ++k) {
      Double p[3];
      for (int c = 0; c < 3; ++c) p[c] = loadDouble(group.position[k][c] + i);
      for (int c = 0; c < 3; ++c) clip[k][c] = hn::Add(dot3(p, rows[c]), hn::Set(d, rows[c].w));
    }
    const Double windowX =
        hn::MulAdd(loadDouble(x + i), hn::Set(d, map.ndcScale.x), hn::Set(d, map.ndcOffset.x));
    const Double windowY =
        hn::MulAdd(loadDouble(y + i), hn::Set(d, map.ndcScale.y), hn::Set(d, map.ndcOffset.y));
    Double edge[3];
    for (int k = 0; k < 3; ++k) {
      const Double(&a)[3] = clip[(k + 1) % 3], (&b)[3] = clip[(k + 2) % 3];
      edge[k] = hn::MulAdd(windowX, hn::MulSub(a[1], b[2], hn::Mul(a[2], b[1])),
                           hn::MulAdd(windowY, hn::MulSub(a[2], b[0], hn::Mul(a[0], b[2])),
                                      hn::MulSub(a[0], b[1], hn::Mul(a[1], b[0]))));
    }
    const Double sum = hn::Add(hn::Add(edge[0], edge[1]), edge[2]);
    // Where the plane is not seen there, comparisons fail and the points stay where they are.
    const Double u = hn::Div(edge[1], sum), v = hn::Div(edge[2], sum), most = hn::Set(d, 1e6);
    const auto usable = hn::And(hn::Lt(hn::Abs(u), most), hn::Lt(hn::Abs(v), most));
    storeFloat(hn::IfThenElse(usable, u, loadDouble(group.u + i)), group.u + i);
    storeFloat(hn::IfThenElse(usable, v, loadDouble(group.v + i)), group.v + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
