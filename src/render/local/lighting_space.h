// The space in which a program lights an instance. Any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::render {

/// Where the viewer is in eye space: at the point away.xyz / away.w, or, with w = 0, infinitely far away
/// against the direction away.xyz.
using Viewer = glm::dvec4;

/// Maps object space to the space of the program's normals and lights. A program whose only light is at the
/// viewer needs no such matrix for points and gives none (Instance::lightingFromObject is the identity); that
/// of its normals says how the space is turned, and the viewer is its origin.
glm::dmat4 lightingFromObject(const scene::Instance&, const scene::Shading&, const Viewer&);

/// Maps it to eye space; exactly the identity where they are the same up to the rounding of float matrices,
/// as in fixed function.
glm::dmat4 eyeFromLighting(const scene::Instance&, const scene::Shading&, const Viewer&);

/// Turns the normals of the mesh's vertices to eye space, up to their length. Toolkits such as VTK scale the
/// positions of a mesh, each axis by itself, and not its normals. None where it is the inverse transpose of
/// Instance::eyeFromObject, up to the rounding of float matrices.
std::optional<glm::dmat3> eyeFromVertexNormal(const scene::Instance&, const scene::Shading&);

/// Whether two such matrices are the same up to that rounding. `reach`: how far from the viewer things are.
bool isNearly(const glm::dmat4& a, const glm::dmat4& b, double reach);

}  // namespace gluray::render
