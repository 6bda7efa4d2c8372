// Many small draws: a wall, and balls before and behind it, each a draw of its own with its own place.
#pragma once
#include "tests/reference/culled/culled_frames.h"
#include "tests/reference/culled/culled_programs.h"

#include <functional>
#include <string>

namespace gluray::test::culled {

/// All draws are small.
inline Settings smallDraws(Culling how = Culling::always) {
  Settings settings = culling(how);
  settings.cull.from = 1'000'000;
  return settings;
}

inline constexpr ContextWish kCompatible{kSide, kSide, false, 0, 0};

class SmallScene {
 public:
  void prepare(Gl gl, const std::string& vertex = kCulledVertex,
               const std::string& fragment = kCulledFragment) {
    program = makeProgram(gl, vertex, fragment);
    wallMesh_ = sheet(40), boardMesh_ = sheet(4), ballMesh_ = ball(10);
    wall_ = send(gl, wallMesh_, program), board_ = send(gl, boardMesh_, program);
    ball_ = send(gl, ballMesh_, program);
  }
  void begin(Gl gl) const {
    clear(gl);
    gl.UseProgram(program);
    setMat4(gl, program, "clipFromEye", glm::perspective(glm::radians(40.0f), 1.0f, 0.5f, 20.0f));
  }
  void wall(Gl gl, float distance, float size = 1.6f) const {
    draw(gl, wall_.array, wallMesh_.count(), glm::vec3(0, 0, -distance), glm::vec3(size, size, 0.05f));
  }
  /// A wall of so few vertices that no look follows.
  void board(Gl gl, float distance, float size) const {
    draw(gl, board_.array, boardMesh_.count(), glm::vec3(0, 0, -distance), glm::vec3(size, size, 0.05f));
  }
  void ballAt(Gl gl, const glm::vec3& place, float radius = 0.4f) const {
    draw(gl, ball_.array, ballMesh_.count(), place, glm::vec3(radius));
  }
  /// Seven balls around a place, two of them beside the wall.
  void balls(Gl gl, float distance, float shift = 0) const {
    for (int i = 0; i < 7; ++i) {
      const auto step = static_cast<float>(i);
      ballAt(gl, {0.55f * (step - 3) + shift, 0.3f * std::sin(2 * step), -distance - 0.1f * step});
    }
  }
  /// The wall, with a draw after it that has its depths read.
  void wallSeen(Gl gl) const { wall(gl, 4), ballAt(gl, {0, 0, -6}); }
  GLuint ballPositions() const { return ball_.positions; }
  GLuint ballArray() const { return ball_.array; }
  const ProgramMesh& ballMesh() const { return ballMesh_; }

  GLuint program = 0;

 private:
  void draw(Gl gl, GLuint array, GLsizei count, const glm::vec3& place, const glm::vec3& size) const {
    const glm::mat4 to = glm::scale(glm::translate(glm::mat4(1), place), size);
    setMat4(gl, program, "eyeFromObject", to);
    gl.BindVertexArray(array);
    gl.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
  }

  ProgramMesh wallMesh_, boardMesh_, ballMesh_;
  Buffers wall_, board_, ball_;
};

using Step = std::function<void(Gl, const SmallScene&)>;

/// Three frames of the scene, whole and culled.
inline gl::Statistics compareScene(
    const std::string& name, const Step& draw, const Step& prepare = [](Gl, const SmallScene&) {},
    const Settings& settings = smallDraws()) {
  SmallScene scene;
  return compareFrames(
      "small_" + name, 3, [&](Gl gl) { scene.prepare(gl), prepare(gl, scene); },
      [&](Gl gl, int) { scene.begin(gl), draw(gl, scene); }, &settings, kCompatible);
}

}  // namespace gluray::test::culled
