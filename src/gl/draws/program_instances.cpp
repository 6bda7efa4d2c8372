// ProgramDraws: instanced draws, whose matrices, normals and colours come from arrays with a divisor.
#include "gl/basics/affine.h"
#include "gl/draws/program_draws.h"
#include "gl/layers/layer_draws.h"
#include "scene/world_space.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace gluray::gl {
namespace {

/// Reads the array element of instance i. Returns false beyond the array's end.
bool readOfInstance(const ArrayReader& array, const Elements& elements, uint32_t i, float out[4]) {
  const uint32_t at = elements.baseInstance + i / std::max(array.divisor(), 1u);
  if (at >= array.available()) return false;
  array.read(at, out);
  return true;
}

/// The arrays with the instances' matrices, normals and colours.
struct InstanceReaders {
  InstanceReaders(const RealGl& real, const ArrayState& arrays) : color(real, arrays.instanceColor) {
    for (const ArraySource& source : arrays.instanceTransform) transform.emplace_back(real, source);
    for (const ArraySource& source : arrays.instanceNormal) normal.emplace_back(real, source);
  }
  std::vector<ArrayReader> transform, normal;
  ArrayReader color;

  /// The matrix of instance i; nullopt beyond the end of an array.
  std::optional<glm::mat4> matrix(const Elements& elements, uint32_t i) const {
    glm::mat4 m(1);
    if (transform.size() == 1) {
      glm::vec4 place(0, 0, 0, 1);
      if (!readOfInstance(transform[0], elements, i, &place[0])) return std::nullopt;
      m = glm::mat4(glm::mat3(place.w));
      m[3] = {glm::vec3(place), 1};
      return m;
    }
    for (size_t c = 0; c < transform.size(); ++c)
      if (!readOfInstance(transform[c], elements, i, &m[static_cast<int>(c)][0])) return std::nullopt;
    return m;
  }
};

}  // namespace

Reason ProgramDraws::classifyInstances(const scene::Mesh& mesh, const Elements& elements) const {
  const InstanceReaders readers(p_.shadow.real, p_.shadow.attributes());
  const bool mayBeTranslucent = layersOf(p_.shadow.program()) == BatchKey::Layers::none &&
                                readers.color.enabled() && p_.shadow.attributes().instanceColor.size == 4 &&
                                unlessOpaque() != Reason::traced;
  if (const RasterState& raster = p_.shadow.raster(); elements.repeats() != 1 && isBlended(mesh))
    return raster.reason != Reason::traced ? raster.reason : raster.unlessOpaque;
  const glm::dmat4& clipFromObject = p_.shadow.program().clipFromObject;
  const glm::ivec4& viewport = p_.shadow.viewport().box;
  for (uint32_t i = 0; i < elements.repeats(); ++i) {
    float color[4] = {0, 0, 0, 1};
    if (mayBeTranslucent && readOfInstance(readers.color, elements, i, color) && color[3] < 1)
      return unlessOpaque();
    const auto m = readers.matrix(elements, i);
    if (!m) return Reason::arrayState;
    if (!isAffine(glm::dmat4(*m), glm::dvec3(1))) return Reason::homogeneous;
    if (RayPrecision::isFarFromOrigin(mesh, clipFromObject, {viewport.z, viewport.w}, glm::dmat4(*m)))
      return Reason::farFromOrigin;
    if (p_.classifier.isThin(mesh, clipFromObject * glm::dmat4(*m))) return Reason::flat;
    if (glm::mat3(*m) != glm::mat3(0) && !scene::isPlaceable(*m)) return Reason::singularMatrix;
  }
  return Reason::traced;
}

glm::dvec3 ProgramDraws::reachOfInstances(const scene::Mesh& mesh, const Elements& elements) const {
  const InstanceReaders readers(p_.shadow.real, p_.shadow.attributes());
  const glm::dvec3 own = reachOf(mesh);
  glm::dvec3 reach(0);
  for (uint32_t i = 0; i < elements.repeats(); ++i) {
    const glm::dmat4 m(readers.matrix(elements, i).value_or(glm::mat4(1)));
    glm::dvec3 here = glm::abs(glm::dvec3(m[3]));
    for (int c = 0; c < 3; ++c) here += glm::abs(glm::dvec3(m[c])) * own[c];
    reach = glm::max(reach, here);
  }
  return reach;
}

void ProgramDraws::addInstancesOf(const scene::Instance& one, const scene::Shading& shading,
                                  const Elements& elements) {
  const InstanceReaders readers(p_.shadow.real, p_.shadow.attributes());
  const bool turns = p_.shadow.program().known->family->instanceTurnsNormals;
  for (uint32_t i = 0; i < elements.repeats(); ++i) {
    const auto own = readers.matrix(elements, i);
    if (!own || glm::mat3(*own) == glm::mat3(0)) continue;  // shrunk to a point: invisible
    scene::Instance instance = one;
    glm::mat3 ownNormal(1);
    for (size_t c = 0; c < readers.normal.size(); ++c) {
      float column[4] = {};
      readOfInstance(readers.normal[c], elements, i, column);
      ownNormal[static_cast<int>(c)] = {column[0], column[1], column[2]};
    }
    if (readers.color.enabled()) readOfInstance(readers.color, elements, i, &instance.color[0]);
    if (turns && scene::isPlaceable(*own)) ownNormal = glm::inverse(glm::transpose(glm::mat3(*own)));
    instance.eyeFromObject = one.eyeFromObject * glm::dmat4(*own);
    instance.lightingFromObject = one.lightingFromObject * *own;
    instance.normalMatrix = one.normalMatrix * ownNormal;
    p_.pending.batch.add(std::move(instance), shading);
  }
}

}  // namespace gluray::gl
