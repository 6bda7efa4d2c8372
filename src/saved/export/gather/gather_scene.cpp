#include "saved/export/gather/gather_scene.h"

#include "accel/rays/ray_kind.h"
#include "render/bsdf/object_rules.h"
#include "render/local/honest_look.h"
#include "render/local/lighting_space.h"
#include "saved/export/gather/clipped_mesh.h"
#include "saved/export/gather/edge_lines.h"
#include "saved/export/gather/gather_materials.h"
#include "saved/export/gather/gather_view.h"
#include "saved/export/gather/scene_parts.h"
#include "saved/export/gather/scene_views.h"
#include "saved/export/gather/shape_meshes.h"
#include "saved/export/gather/shown_impostors.h"
#include "scene/failure.h"
#include "scene/secondary_scene.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <set>
#include <utility>

namespace gluray::saved {
namespace {

using scene::Instance;
using scene::Shape;
using scene::Snapshot;

class ViewGatherer {
 public:
  ViewGatherer(ExportedScene& scene, SceneParts& parts, const Abilities& abilities)
      : scene_(scene),
        parts_(parts),
        abilities_(abilities),
        surfaces_(abilities, parts, scene.notes),
        shapes_(parts) {}

  void add(const ViewBatches& batches) {
    scene_.views.emplace_back();
    placed_.clear();
    const Snapshot& first = *batches.front().snapshot;
    const glm::dmat4 eyeFromWorld = eyeFromWorldOf(first), worldFromEye = glm::inverse(eyeFromWorld);
    for (const ViewBatch& batch : batches) addBatch(*batch.snapshot, worldFromEye * batch.viewFromEye);
    if (!abilities_.camera) return;
    gatherCamera(first.camera, eyeFromWorld, scene_.views.back(), scene_.notes);
    gatherLights(batches, worldFromEye, scene_.views.back(), scene_.notes);
  }

 private:
  void addBatch(const Snapshot& s, const glm::dmat4& worldFromEye) {
    if (!s.volumes.empty()) scene_.note("volumes were left out");
    if (s.ground == scene::GroundUse::drawn) scene_.note("the ground of the settings was left out");
    if (s.backdrop) scene_.note("the background of the settings was left out");
    if (s.catches || (s.secondaryScene && !s.secondaryScene->captures.empty()))
      scene_.note("surfaces that the real OpenGL drew were left out");
    const scene::ColorWrites& writes = s.colorWrites;
    if (s.catches || !(writes.red || writes.green || writes.blue)) return;
    render::HonestLook honest(s);
    std::vector<render::Lighting> lightings;
    for (const scene::Shading& shading : honest.shadings()) lightings.emplace_back(shading);
    const render::View view(s.camera);
    const render::ObjectRules rules(s.settings);
    for (size_t i = 0; i < s.instances.size(); ++i) {
      const Instance& instance = s.instances[i];
      const bool hidden = rules.hiddenFrom(instance).value_or(0) & accel::bitOf(accel::RayKind::camera);
      const bool never = s.shadings[instance.shading].alphaTest.function == scene::AlphaTest::never;
      if (hidden || never || instance.ground || instance.cull == scene::CullFace::both ||
          instance.mesh->triangleCount == 0)
        continue;
      try {
        render::Surface surface = render::makeSurface(view, instance, lightings[instance.shading], true);
        honest.apply(i, surface);
        addInstance(s, surface, s.shadings[instance.shading], worldFromEye);
      } catch (const scene::Untraceable&) {
        scene_.note("surfaces without a place, whose matrix has no inverse, were left out");
      }
    }
  }

  void addInstance(const Snapshot& s, const render::Surface& surface, const scene::Shading& given,
                   const glm::dmat4& worldFromEye) {
    const Instance& instance = *surface.instance;
    if (instance.mesh->residence)
      return scene_.note("surfaces larger than this machine's memory were left out");
    glm::dmat4 world = worldFromEye * instance.eyeFromObject;
    // Products with an inverse are the identity only up to rounding.
    if (worldFromEye == glm::inverse(instance.eyeFromObject)) world = glm::dmat4(1);
    switch (instance.mesh->shape) {
      case Shape::triangles: return addMesh(s, surface, given, world, MeshMode::triangles);
      case Shape::tubes: return addMesh(s, surface, given, world, MeshMode::lines);
      case Shape::beads:
      case Shape::splats: return addMesh(s, surface, given, world, MeshMode::points);
      default: return addShapes(s, surface, given, world);
    }
  }

  CornersPtr cornersFor(const render::Surface& surface, const SourcePtr& positions) {
    const scene::MeshPtr& mesh = surface.instance->mesh;
    const bool finite = parts_.extent(positions).finite;
    if (finite && !changeByTriangle(surface)) return nullptr;
    auto corners = std::make_shared<Corners>();
    corners->mesh = mesh, corners->each = cornersOf(mesh->shape);
    if (!finite) {
      scene_.note("triangles, lines and points with places that are no numbers were left out");
      corners->primitives = finitePrimitives(*mesh), corners->all = false;
    }
    return parts_.corners(mesh, corners);
  }

  void addMesh(const Snapshot& s, const render::Surface& surface, const scene::Shading& given,
               const glm::dmat4& world, MeshMode mode) {
    if (mode == MeshMode::lines && !abilities_.lines) return scene_.note("lines were left out");
    const scene::MeshPtr& mesh = surface.instance->mesh;
    ExportedMesh out;
    out.mode = mode;
    out.positions = sourceOf(mesh, mesh->positions, nullptr, kPositions);
    const CornersPtr corners = cornersFor(surface, out.positions);
    if (corners) out.positions = sourceOf(mesh, mesh->positions, corners, kPositions);
    if (out.positions->count() == 0) return;
    out.indices = indicesOf(mesh, corners);
    if (out.indices && out.indices->count() == 0) return;
    ShownSurface shown = surfaces_.of(surface, given, s, corners);
    if (mode == MeshMode::triangles) {
      addNormals(surface, given, corners, out);
      out.tangents = shown.tangents;
      if (isReversed(surface, world)) out.indices = reversedOnce(out);
    } else {
      scene_.note("points and lines have no widths in files");
      shown.material.unlit = true;
    }
    out.colors = shown.colors, out.texcoords = shown.texcoords;
    const scene::FragmentShading& f = given.fragment;
    if (f.edges && mode == MeshMode::triangles)
      addEdges(*surface.instance, f, shown.material, corners, out, world);
    if (f.edges && f.edgesAlone) return;
    out.material = parts_.material(shown.material);
    place(std::move(out), world, *surface.instance);
  }

  /// Painted edges of `surface`, which is not placed yet.
  void addEdges(const Instance& instance, const scene::FragmentShading& f, ExportedMaterial material,
                const CornersPtr& corners, const ExportedMesh& surface, const glm::dmat4& world) {
    ExportedMesh lines;
    lines.mode = MeshMode::lines;
    lines.positions = sourceOf(instance.mesh, instance.mesh->positions, nullptr, kPositions);
    if (!abilities_.lines || !parts_.extent(lines.positions).finite)
      return scene_.note("painted edges of triangles were left out");
    lines.indices = edgeIndices(instance);
    if (!lines.indices) return;
    scene_.note("painted edges of triangles were written as lines, which have no width in files");
    material = {f.edgesAlone ? material.color : glm::vec4(f.edgeColor, f.edgeOpacity)};
    material.unlit = true;
    if (material.color.a < 1) material.alpha = ExportedMaterial::Alpha::blend;
    if (f.edgesAlone && !corners) lines.colors = surface.colors;
    lines.material = parts_.material(material);
    place(std::move(lines), world, instance);
  }

  SourcePtr sourceOf(const scene::MeshPtr& mesh, const scene::Attribute& a, const CornersPtr& corners,
                     SourceUse use) {
    return parts_.source(
        {a.data, corners.get(), a.stride, corners ? corners->count() : mesh->vertexCount, use}, [&] {
          SourcePtr all = attributeArray(mesh, a, Element::float3, corners);
          return use == kNormals ? unitArray(std::move(all)) : all;
        });
  }

  SourcePtr indicesOf(const scene::MeshPtr& mesh, const CornersPtr& corners) {
    const size_t count = static_cast<size_t>(mesh->triangleCount) * cornersOf(mesh->shape);
    return parts_.source({mesh->indices.data, corners.get(), 0, count, kIndices},
                         [&] { return indexArray(mesh, corners); });
  }

  SourcePtr reversedOnce(const ExportedMesh& mesh) {
    const size_t count = mesh.elementCount();
    return parts_.source({mesh.indices.get(), nullptr, 0, count, kReversed},
                         [&] { return reversedIndices(mesh.indices, count); });
  }

  void addNormals(const render::Surface& surface, const scene::Shading& given, const CornersPtr& corners,
                  ExportedMesh& out) {
    const scene::MeshPtr& mesh = surface.instance->mesh;
    const bool flat = scene::isProgram(given)
                          ? given.fragment.normals != scene::FragmentShading::Normals::vertices
                          : !given.smooth;
    if (flat || !mesh->normals) return;
    out.normals = sourceOf(mesh, mesh->normals, corners, kNormals);
    if (surface.eyeFromVertexNormal == surface.eyeFromObjectNormal) return;
    // The program turns normals by a matrix of its own: those that nodes turn to the same directions.
    struct Turn {
      glm::mat3 m;
      void operator()(const glm::vec3* in, glm::vec3* out) const {
        const glm::vec3 v = m * *in;
        const float length = glm::length(v);
        *out = length > 0 ? v / length : *in;
      }
    };
    const glm::mat3 objectFromEye = glm::transpose(glm::mat3(surface.eyeFromObject));
    out.normals = changedArray<glm::vec3, glm::vec3>(out.normals, Element::float3,
                                                     Turn{objectFromEye * surface.eyeFromVertexNormal});
  }

  /// Whether triangles must turn so that their fronts are what the program shows or, where it shows both
  /// sides, what their normals say.
  static bool isReversed(const render::Surface& surface, const glm::dmat4& world) {
    const Instance& instance = *surface.instance;
    if (instance.cull == scene::CullFace::none) return isInsideOut(*instance.mesh);
    const bool ccwIsShown = (instance.cull == scene::CullFace::back) == instance.frontFaceCcw;
    return ccwIsShown == (glm::determinant(world) < 0);
  }

  /// Adds a node, unless the view has an equal one: programs draw surfaces again for a part of their look.
  void place(ExportedMesh mesh, const glm::dmat4& world, const Instance& instance,
             const glm::dmat4& objectFromMesh = glm::dmat4(1)) {
    if (!instance.clipPlanes.empty()) {
      const glm::dmat4 rows = glm::transpose(instance.eyeFromObject * objectFromMesh);
      std::vector<glm::dvec4> planes;
      for (const glm::dvec4& plane : instance.clipPlanes) planes.push_back(rows * plane);
      std::optional<ExportedMesh> rest = clipped(mesh, planes);
      if (!rest) return;
      mesh = std::move(*rest);
    }
    const bool plain = isDecomposable(world);
    if (!plain) mesh = moved(mesh, world);
    if (!parts_.extent(mesh.positions).finite)
      return scene_.note("surfaces that reach beyond the range of numbers were left out");
    const ExportedNode node{parts_.mesh(std::move(mesh)), plain ? world : glm::dmat4(1),
                            instance.object.value};
    std::pair<size_t, std::array<double, 16>> key{node.mesh, {}};
    std::memcpy(key.second.data(), &node.worldFromMesh, sizeof node.worldFromMesh);
    if (placed_.insert(key).second) scene_.views.back().nodes.push_back(node);
  }

  void addShapes(const Snapshot& s, const render::Surface& surface, const scene::Shading& given,
                 const glm::dmat4& world) {
    const Instance& instance = *surface.instance;
    const ShownSurface& shown = surfaces_.of(surface, given, s, nullptr);
    const ShownColors colors{shown.material.color, shown.colors};
    const bool flat = !scene::isProgram(given) && !given.smooth;
    std::vector<RoundShape> shapes = shapesOf(instance, s.camera, colors, flat, scene_.notes);
    const glm::dmat4 objectFromShapes = glm::inverse(glm::dmat4(instance.lightingFromObject));
    const bool mayShare = abilities_.instances && instance.clipPlanes.empty();
    for (PlacedMesh& placed :
         shapes_.of(std::move(shapes), shown.material, world * objectFromShapes, mayShare))
      place(std::move(placed.mesh), placed.worldFromMesh, instance, objectFromShapes);
  }

  ExportedScene& scene_;
  SceneParts& parts_;
  const Abilities& abilities_;
  ShownSurfaces surfaces_;
  ShapeMeshes shapes_;
  std::set<std::pair<size_t, std::array<double, 16>>> placed_;  // of the view
};

}  // namespace

ExportedScene gatherScene(const std::vector<scene::SnapshotPtr>& batches, const Abilities& abilities) {
  ExportedScene scene;
  std::vector<ViewBatches> views = sceneViewsOf(batches);
  if (views.size() > 1 && !abilities.otherViews) {
    scene.note("of several views, the largest was written");
    views.resize(1);
  } else if (views.size() > 1) {
    scene.note("several views were written as scenes of their own: many programs show the first");
  }
  SceneParts parts(scene);
  ViewGatherer gatherer(scene, parts, abilities);
  for (const ViewBatches& view : views) gatherer.add(view);
  dropUnused(scene);
  return scene;
}

}  // namespace gluray::saved
