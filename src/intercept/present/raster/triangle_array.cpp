#include "intercept/present/raster/triangle_array.h"

#include "gl/real/clip_depths.h"
#include "gl/real/state_queries.h"

#include <glm/gtc/type_ptr.hpp>

#include <vector>

namespace gluray::present {

TriangleArray::TriangleArray(const gl::RealGl& real, const Features& features, const scene::Mesh& mesh)
    : real_(real), features_(features) {
  std::vector<glm::vec3> corners;
  corners.reserve(size_t{mesh.triangleCount} * 3);
  for (uint32_t t = 0; t < mesh.triangleCount; ++t)
    for (uint32_t k = 0; k < 3; ++k) corners.push_back(mesh.position(mesh.corner(t, k)));
  count_ = static_cast<GLsizei>(corners.size());
  real.GenVertexArrays(1, &array_);
  real.GenBuffers(1, &buffer_);
  StateGuard guard(real, features);
  guard.vertexArray(array_);
  const auto bound = static_cast<GLuint>(gl::integer(real, GL_ARRAY_BUFFER_BINDING));
  real.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  real.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(glm::vec3)),
                  corners.data(), GL_STREAM_DRAW);
  real.EnableVertexAttribArray(0);
  real.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  real.BindBuffer(GL_ARRAY_BUFFER, bound);
}

TriangleArray::~TriangleArray() {
  real_.DeleteVertexArrays(1, &array_);
  real_.DeleteBuffers(1, &buffer_);
}

void TriangleArray::draw(const scene::Snapshot& snapshot, const glm::dmat4& clipFromObject, GLenum depthFunc,
                         const DepthPass& pass) const {
  StateGuard guard(real_, features_);
  guard.drawInto(snapshot, depthFunc);
  guard.colorWrites({false, false, false, false});
  guard.capability(GL_POLYGON_OFFSET_FILL, false);
  guard.program(pass.program);
  if (pass.sample >= 0) guard.onlySample(pass.sample);
  if (pass.multisampled)
    guard.textureMultisample(0, pass.depth);
  else
    guard.texture2D(0, pass.depth);
  guard.vertexArray(array_);
  guard.capability(GL_CULL_FACE, false);
  const glm::mat4 matrix(snapshot.camera.depthsFromZero ? gl::toDepthsFromZero(clipFromObject)
                                                        : clipFromObject);
  real_.UniformMatrix4fv(real_.GetUniformLocation(pass.program, "MCDCMatrix"), 1, GL_FALSE,
                         glm::value_ptr(matrix));
  real_.DrawArrays(GL_TRIANGLES, 0, count_);
}

}  // namespace gluray::present
