// Lighting space: the space in which a program evaluates lights. Any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::render {

/// Position of the viewer in eye space: the point away.xyz / away.w, or if w = 0, infinitely far away
/// opposite to the direction away.xyz.
using Viewer = glm::dvec4;

/// Maps object space to lighting space. A program with only a headlight has no such matrix for points
/// (Instance::lightingFromObject is the identity). Then the normal matrix gives the rotation of the space,
/// and the viewer is its origin.
glm::dmat4 lightingFromObject(const scene::Instance&, const scene::Shading&, const Viewer&);

/// Maps lighting space to eye space; exactly the identity if the spaces are equal up to the rounding of float
/// matrices, as in fixed function.
glm::dmat4 eyeFromLighting(const scene::Instance&, const scene::Shading&, const Viewer&);

/// Maps the normals of the mesh's vertices to eye space, up to their length. Toolkits such as VTK scale the
/// positions of a mesh per axis, but not its normals. None if the result is the inverse transpose of
/// Instance::eyeFromObject, up to the rounding of float matrices.
std::optional<glm::dmat3> eyeFromVertexNormal(const scene::Instance&, const scene::Shading&);

/// Whether two such matrices are equal up to the rounding of float. `reach`: largest distance of surfaces
/// from the viewer.
bool isNearly(const glm::dmat4& a, const glm::dmat4& b, double reach);

}  // namespace gluray::render
