#include "tests/reference/programs/viewers/viewer_stage.h"

namespace gluray::test {

Bowl bowlWithColors() {
  Bowl bowl;
  bowl.mesh = ball(16);
  bowl.mesh.indices.resize(bowl.mesh.indices.size() / 6 * 3);
  for (const glm::vec3& p : bowl.mesh.positions) bowl.colors.push_back(p * 0.4f + 0.55f);
  return bowl;
}

BowlDraw::BowlDraw(Gl of, const Bowl& bowl) : gl(of), count(bowl.mesh.count()) {
  GLuint array = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  makeBuffer(gl, GL_ELEMENT_ARRAY_BUFFER, bowl.mesh.indices);
}

void BowlDraw::draw(GLsizei instances) const {
  if (instances > 0)
    gl.DrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr, instances);
  else
    gl.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
}

namespace {

DrawProgram whole(const std::string& vertex, const std::string& fragment, const DrawViewer& draw) {
  return [=](Gl gl) { draw(gl, makeProgram(gl, vertex, fragment)); };
}

}  // namespace

void expectTraced(const std::string& name, const std::string& vertex, const std::string& fragment,
                  const DrawViewer& draw, const scenes::Tolerance& tolerance) {
  expectBoth(name, whole(vertex, fragment, draw), 1, coreWish(3, 3), tolerance);
}

void expectLeft(const std::string& name, const std::string& vertex, const std::string& fragment,
                const DrawViewer& draw) {
  expectSame(name, whole(vertex, fragment, draw), 0, coreWish(3, 3));
}

void expectViewerMutantsSeen(const std::string& name, const std::string& vertex, const std::string& fragment,
                             const DrawViewer& draw) {
  expectMutantsSeen(name, {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}, draw, coreWish(3, 3));
}

}  // namespace gluray::test
