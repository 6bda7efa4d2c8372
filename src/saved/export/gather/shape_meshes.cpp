#include "saved/export/gather/shape_meshes.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace gluray::saved {
namespace {

/// Shapes that become nodes of one mesh; more are merged into one.
constexpr size_t kMostNodes = 4096, kMostColors = 256;

/// Edges of a quarter of a circle.
int resolutionFor(size_t shapes) {
  constexpr size_t kMany = 20'000, kVeryMany = 200'000;
  return shapes <= kMostNodes ? 16 : shapes <= kMany ? 8 : shapes <= kVeryMany ? 4 : 2;
}

/// Whether each is a node of its own with a material of its own.
bool areFewAndPlain(const std::vector<RoundShape>& shapes) {
  if (shapes.size() > kMostNodes) return false;
  std::set<std::array<float, 4>> colors;
  for (const RoundShape& shape : shapes) {
    const glm::vec4& c = shape.color[0];
    colors.insert({c.x, c.y, c.z, c.w});
    if (!shape.isPlain() || colors.size() > kMostColors) return false;
  }
  return true;
}

bool hasTwoSides(RoundForm form) { return form == RoundForm::disc || form == RoundForm::openTube; }

}  // namespace

std::vector<PlacedMesh> ShapeMeshes::of(std::vector<RoundShape> shapes, const ExportedMaterial& material,
                                        const glm::dmat4& placed, bool mayShare) {
  if (!mayShare || !areFewAndPlain(shapes) || !isDecomposable(placed))
    return mergedMeshes(std::move(shapes), material, placed);
  std::vector<PlacedMesh> out;
  for (const RoundShape& shape : shapes) {
    ExportedMaterial own = material;
    own.color = shape.color[0], own.doubleSided = hasTwoSides(shape.form);
    ExportedMesh mesh = unitMesh(shape.form);
    mesh.material = parts_.material(own);
    out.push_back({std::move(mesh), placed * shape.placed()});
  }
  return out;
}

const ExportedMesh& ShapeMeshes::unitMesh(RoundForm form) {
  ExportedMesh& kept = units_[static_cast<size_t>(form)];
  if (!kept.positions) {
    UnitShape unit = unitShape(form, resolutionFor(0));
    kept.positions = ownArray(Element::float3, std::move(unit.positions));
    kept.normals = ownArray(Element::float3, std::move(unit.normals));
    kept.indices = ownArray(Element::uint32, std::move(unit.indices));
  }
  return kept;
}

std::vector<PlacedMesh> ShapeMeshes::mergedMeshes(std::vector<RoundShape> shapes, ExportedMaterial material,
                                                  const glm::dmat4& placed) {
  const int quarter = resolutionFor(shapes.size());
  std::array<std::vector<RoundShape>, kRoundForms> byForm;
  for (const RoundShape& shape : shapes) byForm[static_cast<size_t>(shape.form)].push_back(shape);
  std::vector<PlacedMesh> out;
  material.color = glm::vec4(1);
  for (std::vector<RoundShape>& some : byForm) {
    if (some.empty()) continue;
    material.doubleSided = hasTwoSides(some.front().form);
    MergedShapes arrays = merged(std::move(some), quarter);
    if (!arrays.positions)
      throw std::runtime_error("there are too many spheres or tubes for one mesh: show less");
    ExportedMesh mesh;
    mesh.positions = std::move(arrays.positions), mesh.normals = std::move(arrays.normals);
    mesh.indices = std::move(arrays.indices), mesh.colors = std::move(arrays.colors);
    mesh.material = parts_.material(material);
    out.push_back({std::move(mesh), placed});
  }
  return out;
}

}  // namespace gluray::saved
