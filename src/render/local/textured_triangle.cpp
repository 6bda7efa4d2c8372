#include "render/local/textured_triangle.h"

#include "render/local/combine.h"
#include "render/local/texgen.h"
#include "render/local/texture_lookup.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::Texture;
using scene::TextureTarget;

/// The vertex's texture coordinates of `unit`.
glm::vec4 givenCoordinates(const Surface& surface, uint32_t unit, uint32_t vertex) {
  const scene::Attribute* carried = surface.mesh->texcoordsOf(unit);
  return carried ? scene::fetch(*carried, vertex) : surface.instance->texcoordOf(unit);
}

glm::vec4 generated(const Surface& surface, const Texture& t, uint32_t vertex, const glm::vec4& given) {
  TexGenVertex v;
  v.object = glm::vec4(surface.mesh->position(vertex), 1);
  v.eye = glm::vec3(surface.eyeFromObject * v.object);
  if (needsNormal(t.texGen)) {
    const scene::Attribute& normals = surface.mesh->normals;
    const glm::vec3 n = normals ? glm::vec3(scene::fetch(normals, vertex)) : surface.instance->normal;
    v.normal = surface.eyeFromObjectNormal * n;
    const scene::Shading& shading = *surface.lighting->shading;
    if (const float length = glm::length(v.normal); shading.normalize && length > 0)
      v.normal /= length;
    else if (shading.rescaleNormal)
      v.normal *= surface.rescale;
  }
  return generateCoordinates(t.texGen, v, given);
}

/// Normalised coordinates for sampleLevel(); `face`: of cube maps.
glm::dvec3 project(const Texture& t, const glm::dvec4& strq, int face) {
  if (t.target == TextureTarget::cubeMap)
    return {coordinatesInFace(face, glm::dvec3(strq)), static_cast<double>(face)};
  const glm::dvec3 str = strq.w == 1 ? glm::dvec3(strq) : glm::dvec3(strq) / strq.w;
  if (t.target != TextureTarget::rectangle) return str;
  return {str.x / t.image->width, str.y / t.image->height, 0};
}

/// Derivative of the coordinates within a face for a change of the direction.
glm::dvec3 changeInFace(int face, const glm::dvec3& direction, const glm::dvec3& change) {
  const glm::dvec3 at = alongFace(face, direction), d = alongFace(face, change);
  return {0.5 * (glm::dvec2(d) * at.z - glm::dvec2(at) * d.z) / (at.z * at.z), 0};
}

/// Texels along each axis of the texture; 0 for axes that it lacks.
glm::dvec3 sizeOf(const Texture& t) {
  const scene::TextureImage& image = *t.image;
  return {image.width, t.target == TextureTarget::texture1D ? 0 : image.height,
          t.target == TextureTarget::texture3D ? image.depth : 0};
}

}  // namespace

TexturedTriangle::TexturedTriangle(const Surface& surface, const scene::Camera& camera)
    : TexturedTriangle(surface, camera, surface.lighting->shading->textures) {}

TexturedTriangle::TexturedTriangle(const Surface& surface, const scene::Camera& camera,
                                   const std::vector<Texture>& textures)
    : surface_(surface), map_(camera.viewport), rowsFromTop_(camera.rowsFromTop), textures_(textures) {
  planes_ = std::any_of(textures_.begin(), textures_.end(), needsFootprint);
}

void TexturedTriangle::cornersOf(const Texture& t, Coordinates& c) const {
  const bool generate = t.texGen.on(), transform = t.textureMatrix != glm::mat4(1);
  for (int k = 0; k < 3; ++k) {
    glm::vec4 given = givenCoordinates(surface_, t.unit, vertex_[k]);
    if (generate) given = generated(surface_, t, vertex_[k], given);
    c.corner[k] = transform ? glm::dmat4(t.textureMatrix) * glm::dvec4(given) : glm::dvec4(given);
  }
}

void TexturedTriangle::enter(uint32_t primitive) {
  primitive_ = primitive;
  for (uint32_t k = 0; k < 3; ++k) vertex_[k] = surface_.mesh->corner(primitive, k);
  for (size_t i = 0; i < textures_.size(); ++i) cornersOf(textures_[i], coordinates_[i]);
  if (!planes_) return;
  glm::dvec3 clip[3];  // x, y, w
  for (int k = 0; k < 3; ++k) {
    const glm::dvec4 c = surface_.clipFromObject * glm::dvec4(surface_.mesh->position(vertex_[k]), 1.0);
    clip[k] = {c.x, c.y, c.w};
  }
  // The edge functions are the corners' perspective-correct weights, up to a factor.
  const glm::dvec3 edge[3] = {glm::cross(clip[1], clip[2]), glm::cross(clip[2], clip[0]),
                              glm::cross(clip[0], clip[1])};
  for (size_t i = 0; i < textures_.size(); ++i) {
    Coordinates& c = coordinates_[i];
    c.start = c.stepX = c.stepY = glm::dvec4(0);
    for (int k = 0; k < 3; ++k) {
      c.stepX += edge[k].x * map_.ndcScale.x * c.corner[k];
      c.stepY += edge[k].y * map_.ndcScale.y * c.corner[k];
      c.start += (edge[k].x * map_.ndcOffset.x + edge[k].y * map_.ndcOffset.y + edge[k].z) * c.corner[k];
    }
  }
}

Footprint TexturedTriangle::footprintOf(const Texture& t, const Coordinates& c, glm::dvec2 window) const {
  // Derivatives are differences to the pixel of the 2x2 quad that is first in the framebuffer.
  glm::dvec2 first = 2.0 * glm::floor(0.5 * window) + 0.5;
  glm::dvec4 stepY = c.stepY;
  if (rowsFromTop_ > 0) {
    const double fromTop = 2.0 * std::floor(0.5 * (rowsFromTop_ - window.y)) + 0.5;
    first.y = rowsFromTop_ - fromTop;
    stepY = -stepY;
  }
  const glm::dvec4 at = c.start + first.x * c.stepX + first.y * c.stepY;
  Footprint footprint;
  if (t.target == TextureTarget::cubeMap) {
    const glm::dvec3 here = glm::dvec3(at) / at.w;
    const int face = cubeFace(here);
    footprint.dx = changeInFace(face, here, glm::dvec3(at + c.stepX) / (at.w + c.stepX.w) - here);
    footprint.dy = changeInFace(face, here, glm::dvec3(at + stepY) / (at.w + stepY.w) - here);
  } else {
    const glm::dvec3 here = project(t, at, 0);
    footprint.dx = project(t, at + c.stepX, 0) - here;
    footprint.dy = project(t, at + stepY, 0) - here;
  }
  footprint.dx *= sizeOf(t);
  footprint.dy *= sizeOf(t);
  return footprint;
}

Footprint TexturedTriangle::footprintOf(const Texture& t, const Coordinates& c, const glm::dvec3& weights,
                                        const WeightSteps& steps) {
  const auto at = [&](const glm::dvec3& w) {
    return w.x * c.corner[0] + w.y * c.corner[1] + w.z * c.corner[2];
  };
  const glm::dvec4 here = at(weights);
  const auto change = [&](const glm::dvec3& step) {
    const glm::dvec4 there = at(weights + step);
    if (t.target != TextureTarget::cubeMap) return project(t, there, 0) - project(t, here, 0);
    return changeInFace(cubeFace(glm::dvec3(here)), glm::dvec3(here), glm::dvec3(there - here));
  };
  return {change(steps.x) * sizeOf(t), change(steps.y) * sizeOf(t)};
}

glm::vec4 TexturedTriangle::sample(const Texture& t, const Coordinates& c, const glm::dvec3& weights,
                                   glm::dvec2 window, const WeightSteps* steps) const {
  const glm::dvec4 strq = weights.x * c.corner[0] + weights.y * c.corner[1] + weights.z * c.corner[2];
  const int face = t.target == TextureTarget::cubeMap ? cubeFace(glm::dvec3(strq)) : 0;
  Footprint footprint;
  if (needsFootprint(t)) footprint = steps ? footprintOf(t, c, weights, *steps) : footprintOf(t, c, window);
  return sampleTexture(t, footprint, project(t, strq, face));
}

glm::vec4 TexturedTriangle::color(uint32_t primitive, float u, float v, glm::dvec2 window,
                                  const glm::vec4& primary, const WeightSteps* steps) {
  if (primitive != primitive_) enter(primitive);
  const glm::dvec3 weights(1.0 - u - v, u, v);
  CombineInputs in;
  in.primary = primary;
  for (size_t i = 0; i < textures_.size(); ++i)
    in.texels[textures_[i].unit] = sample(textures_[i], coordinates_[i], weights, window, steps);
  glm::vec4 color = primary;
  for (const Texture& t : textures_) color = glm::clamp(applyEnvironment(t, in, color), 0.0f, 1.0f);
  return color;
}

void TexturedTriangle::texels(uint32_t primitive, float u, float v, glm::dvec2 window,
                              const WeightSteps* steps, glm::vec4 (&out)[scene::kTextureUnits]) {
  if (primitive != primitive_) enter(primitive);
  const glm::dvec3 weights(1.0 - u - v, u, v);
  for (size_t i = 0; i < textures_.size(); ++i)
    out[i] = sample(textures_[i], coordinates_[i], weights, window, steps);
}

glm::vec4 textureFragment(const Surface& surface, const scene::Camera& camera, uint32_t primitive, float u,
                          float v, glm::dvec2 window, const glm::vec4& primary) {
  return TexturedTriangle(surface, camera).color(primitive, u, v, window, primary);
}

}  // namespace gluray::render
