// Sixteen paths of light, one for each lane of a packet, a bounce at a time. Compiled once for each
// instruction set.
#if defined(GLURAY_RENDER_PATHS_PATH_WAVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_PATHS_PATH_WAVE_INL_H_
#undef GLURAY_RENDER_PATHS_PATH_WAVE_INL_H_
#else
#define GLURAY_RENDER_PATHS_PATH_WAVE_INL_H_
#endif

#include "render/paths/clear_shadows.h"
#include "render/paths/path_vertices.inl.h"
#include "render/paths/weighted_choice.h"
#include "render/remote/remote_surfaces.h"
#include "render/sampling/sobol.inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// What the two-dimensional samples of a vertex are for.
enum class PathUse : uint32_t { direction, lobe, light, environment, count };

inline float largestOf(const glm::vec3& v) { return std::max({v.x, v.y, v.z}); }
inline bool isUsable(const glm::vec3& v) { return std::isfinite(v.x + v.y + v.z); }

/// Balance of two ways to draw the same direction, with squared densities (Veach 1997, power heuristic).
inline float powerHeuristic(float pdf, float other) {
  if (pdf > other) return 1 / (1 + (other / pdf) * (other / pdf));
  return other > 0 ? (pdf / other) * (pdf / other) / (1 + (pdf / other) * (pdf / other)) : 0;
}

class Wave {
 public:
  Wave(const Path& path, const ColoredHits& hits, const PixelSeeds& seeds, uint32_t index,
       const PathVertices& camera, const Row (&from)[3], const RayCone (&cones)[kLanes], bool alone)
      : path_(path),
        hits_(hits),
        seeds_(seeds),
        index_(index),
        alone_(alone),
        vertices_(camera),
        alive_(hits.group.lanes) {
    std::fill_n(body_, kLanes, int64_t{-1});
    std::copy_n(cones, kLanes, cone_);
    for (int i = 0; i < kLanes; ++i)
      back_[i] = {from[0][i], from[1][i], from[2][i]}, throughput_[i] = glm::vec3(1);
  }
  const glm::vec3& radiance(int i) const { return radiance_[i]; }

  HWY_ATTR void run() {
    for (depth_ = 0; alive_; ++depth_) {
      // Light that the surface itself emits.
      emit();
      if (depth_ == path_.depth) return;
      alive_ &= ~ending_;
      // Light of the lights, straight from them.
      sampleLights();
      // Light of the environment, straight from it.
      if (path_.environment->isSampled()) sampleEnvironment();
      // The next direction.
      scatter();
      // Paths that bring little end by chance, and those that survive count for more.
      if (depth_ > 1) roulette();
      // The next surface; paths that meet none see the environment.
      extend();
    }
  }

  /// Only what needs no samples: emission, and all lights of the program at the first surfaces.
  HWY_ATTR void lightWithoutNoise() {
    emit();
    if (path_.depth > 0) sampleEachLight();
  }

 private:
  HWY_ATTR void draw(PathUse use, Row& x, Row& y) const {
    drawFrom(static_cast<uint32_t>(Dimensions::path) +
                 static_cast<uint32_t>(depth_) * static_cast<uint32_t>(PathUse::count) +
                 static_cast<uint32_t>(use),
             x, y);
  }
  HWY_ATTR void drawFrom(uint32_t number, Row& x, Row& y) const {
    for (int i = 0; i < kLanes; i += lanesOfVector()) {
      const Sample2 u = sample2(seeds_, i, index_, static_cast<Dimensions>(number));
      store(u.x, x + i), store(u.y, y + i);
    }
  }

  template <class Body>
  void eachLane(const Body& body) const {
    for (uint32_t lanes = alive_; lanes; lanes &= lanes - 1) body(std::countr_zero(lanes));
  }

  /// Whether the path comes to vertex i from within the body of its surface. Paths know which body they are
  /// in, so that triangles may be wound in either order.
  bool isInside(int i) const { return body_[i] == static_cast<int64_t>(vertices_.lane[i].instance); }
  /// The path goes through the surface at vertex i.
  void cross(int i) {
    const PathVertex& v = vertices_.lane[i];
    body_[i] = isInside(i) ? -1 : static_cast<int64_t>(v.instance);
    bodyColor_[i] = v.albedo;
  }

  /// Unit vector to the viewer that highlights are computed for.
  glm::vec3 viewerOf(int i) const {
    const scene::Shading& shading = *path_.frame.surfaces[vertices_.lane[i].instance].lighting->shading;
    const bool atInfinity =
        shading.fragment.model == scene::FragmentShading::Model::off && !shading.localViewer;
    return depth_ == 0 && atInfinity ? glm::vec3(0, 0, 1) : back_[i];
  }

  /// Adds light that arrives at the viewer along a path.
  void add(int i, glm::vec3 light) {
    light *= throughput_[i];
    if (!isUsable(light)) return;
    const float largest = largestOf(light);
    if (depth_ > 0 && path_.mostIndirect > 0 && largest > path_.mostIndirect)
      light *= path_.mostIndirect / largest;
    radiance_[i] += light;
  }

  /// Adds what arrives at the vertices of `lanes`, by the shares that get through.
  void bring(uint32_t lanes, const glm::vec3 (&brought)[kLanes], const float (&through)[kLanes]) {
    for (; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      if (through[i] > 0) add(i, brought[i] * through[i]);
    }
  }
  static constexpr float kBeforeLight = 1 - 1e-5f;  // of the distance to a light

  void emit() {
    eachLane([&](int i) { add(i, vertices_.lane[i].emission); });
  }

  HWY_ATTR void sampleLights();
  HWY_ATTR void sampleEachLight();
  /// Light of the program's light `l` that vertex i reflects if nothing is in its way.
  glm::vec3 reflectedOf(int i, uint32_t l, const ArrivingLight& light, const bsdf::Any& material,
                        const bsdf::LocalFrame& local, const glm::vec3& wo) const;
  /// What the choice among added lights goes by, kept until the path meets the next surface.
  struct LitPoint {
    glm::vec3 point{0}, normal{0, 0, 1};
    bool sided = false;      // no light counts that comes from below
    float factor = 0;        // of all light of added lights
    glm::vec3 reflected{0};  // about the share of irradiance that leaves, times `factor`
    float total = 0;         // of the weights of all lights
  };
  void litBy(int i, const bsdf::Any& material);
  float weightOf(const LitPoint& at, size_t light) const {
    const glm::vec3 e = path_.added[light].estimate(at.point, at.sided ? &at.normal : nullptr) * at.reflected;
    return e.x + e.y + e.z;
  }
  /// What added light `light` brings by a point of it, drawn by u, if nothing is in its way. `chance`: that
  /// this light was chosen.
  glm::vec3 bringAdded(int i, const bsdf::Any& material, size_t light, float chance, const glm::vec2& u,
                       ArrivingLight& out) const;
  /// Light of the added lights that the path of lane i meets between two distances. Returns whether it ends
  /// at one.
  bool meetLights(int i, float from, float to);
  HWY_ATTR void sampleEnvironment();
  HWY_ATTR void scatter();
  HWY_ATTR void roulette();
  HWY_ATTR void extend();
  /// What light keeps on its way through the body that the path of lane i is in (Beer and Lambert).
  glm::vec3 absorbed(int i, float distance) const {
    const float length = body_[i] < 0 ? 0 : path_.materials[static_cast<size_t>(body_[i])].absorption;
    return length > 0 ? glm::pow(bodyColor_[i], glm::vec3(distance / length)) : glm::vec3(1);
  }
  void absorb(uint32_t lanes, const accel::RayPacket& packet) {
    for (; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      throughput_[i] *= absorbed(i, packet.tFar[i] - packet.tNear[i]);
    }
  }

  uint32_t passing(uint32_t lanes, Row& u, accel::RayPacket& packet) const;

  /// The path of lane i meets nothing and sees the environment.
  void escape(int i) {
    float weight = 1;
    if (path_.environment->isSampled() && pdf_[i] > 0)
      weight = powerHeuristic(pdf_[i], path_.environment->pdf(way_[i]));
    add(i, weight * path_.environment->radiance(way_[i]));
  }

  /// World-space origin of rays that leave vertex i along `way`.
  glm::vec3 originOf(int i, const glm::vec3& way) const {
    const PathVertex& v = vertices_.lane[i];
    const bool above = glm::dot(way, v.geometric) >= 0;
    const glm::vec3 eye = v.point + (above ? v.error * v.geometric + v.lift : -v.error * v.geometric);
    return glm::vec3(path_.metric.worldFromEye * glm::vec4(eye, 1));
  }

  template <class Rays>
  void aim(Rays& rays, int i, const glm::vec3& way, float tFar) const {
    const glm::vec3 org = originOf(i, way), dir = glm::mat3(path_.metric.worldFromEye) * way;
    rays.orgX[i] = org.x, rays.orgY[i] = org.y, rays.orgZ[i] = org.z;
    rays.dirX[i] = dir.x, rays.dirY[i] = dir.y, rays.dirZ[i] = dir.z;
    rays.tNear[i] = 0, rays.tFar[i] = tFar;
  }

  /// The share of the lights' light that reaches the vertices of `lanes` along rays aimed there.
  HWY_ATTR void transmitFromLights(uint32_t lanes, accel::OcclusionRays& rays,
                                   float (&through)[kLanes]) const {
    if (alone_ || !path_.hasGlass) return transmit(lanes, rays, through);
    alignas(64) int32_t valid[kLanes];
    for (int i = 0; i < kLanes; ++i) valid[i] = lanes >> i & 1 ? -1 : 0;
    const ClearShadows light(path_.occluders, path_.materials);
    const uint32_t blocked =
        occludedHere(path_.frame, valid, rays, accel::RayKind::shadow, &light, {.grey = light.through});
    for (int i = 0; i < kLanes; ++i) through[i] = blocked >> i & 1 ? 0 : light.through[i];
  }

  /// The share of the environment's light that reaches the vertices of `lanes` along rays aimed there.
  HWY_ATTR void transmit(uint32_t lanes, accel::OcclusionRays& rays, float (&through)[kLanes]) const {
    if (alone_) return void(std::fill_n(through, kLanes, 1.0f));
    alignas(64) int32_t valid[kLanes];
    for (int i = 0; i < kLanes; ++i) valid[i] = lanes >> i & 1 ? -1 : 0;
    const Transmittance light(path_.occluders);
    const uint32_t blocked =
        occludedHere(path_.frame, valid, rays, accel::RayKind::shadow,
                     path_.occluders.areSolid() ? nullptr : &light, {.grey = light.through});
    for (int i = 0; i < kLanes; ++i) through[i] = blocked >> i & 1 ? 0 : light.through[i];
  }

  const Path& path_;
  const ColoredHits& hits_;
  const PixelSeeds& seeds_;
  const uint32_t index_;
  const bool alone_;  // no ray meets anything
  PathVertices vertices_;
  uint32_t alive_;
  int depth_ = 0;
  glm::vec3 back_[kLanes];        // along the path to the viewer, unit length
  glm::vec3 way_[kLanes] = {};    // the next direction, unit length
  glm::vec3 throughput_[kLanes];  // share of light at the vertex that reaches the viewer
  glm::vec3 radiance_[kLanes] = {};
  int64_t body_[kLanes];              // instance whose inside the path is in; -1: none
  glm::vec3 bodyColor_[kLanes] = {};  // of that
  uint32_t ending_ = 0;               // bit i: path i ends at its next surface
  float pdf_[kLanes] = {};            // of way_; 0 where lights and environment are not asked otherwise
  RayCone cone_[kLanes];              // of way_; only if textures are filtered
  LitPoint lit_[kLanes];              // the vertices that way_ leaves; only with added lights
};

HWY_ATTR inline void Wave::scatter() {
  alignas(64) Row u, v, lobe, unused;
  draw(PathUse::direction, u, v);
  draw(PathUse::lobe, lobe, unused);
  eachLane([&](int i) {
    const PathVertex& at = vertices_.lane[i];
    const bsdf::LocalFrame local(at.shading);
    const bsdf::Scattered next =
        bsdf::sample(path_.bsdfOf(at, isInside(i)), local.toLocal(back_[i]), {u[i], v[i]}, lobe[i]);
    throughput_[i] *= next.weight;
    glm::vec3 way = local.fromLocal(next.wi);
    // Reflected light stays above the triangle, where the smooth normal leans it below; and the reverse.
    const float height = glm::dot(way, at.geometric);
    if (next.wi.z * height < 0) way -= 2 * height * at.geometric;
    if (next.wi.z < 0 && path_.materials[at.instance].isBody()) cross(i);
    way_[i] = glm::normalize(way);
    pdf_[i] = next.exact ? 0 : next.pdf;
    if (path_.filters && !next.exact) cone_[i] = scattered(cone_[i], next.pdf, path_.samples);
    if (!path_.bounces && !next.exact) ending_ |= 1u << i;
    if (!(largestOf(throughput_[i]) > 0) || !isUsable(way_[i])) alive_ &= ~(1u << i);
  });
}

HWY_ATTR inline void Wave::roulette() {
  alignas(64) Row unused, u;
  draw(PathUse::lobe, unused, u);
  eachLane([&](int i) {
    const float survive = std::min(largestOf(throughput_[i]), 0.95f);
    if (u[i] < survive)
      throughput_[i] /= survive;
    else
      alive_ &= ~(1u << i);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
