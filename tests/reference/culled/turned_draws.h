// Draws by a program of no family while the camera turns, whole and culled.
#pragma once
#include "tests/reference/culled/culled_frames.h"
#include "tests/reference/culled/culled_programs.h"

#include <functional>
#include <string>

namespace gluray::test::culled {

/// The shaders of a draw, and what is done once they and the mesh are there.
struct TurnedDraw {
  std::string vertex = kCulledVertex, fragment = kCulledFragment;
  std::function<void(Gl)> prepare = [](Gl) {};
  const Settings* settings = nullptr;  // null: those of compareFrames()
};

/// compareFrames() of so many frames, in each of which `draw` draws the mesh.
inline gl::Statistics compareTurned(const std::string& name, int frames, const ProgramMesh& mesh,
                                    const std::function<void(Gl)>& draw, const TurnedDraw& how = {}) {
  GLuint program = 0;
  return compareFrames(
      name, frames,
      [&](Gl gl) {
        program = makeProgram(gl, how.vertex, how.fragment);
        send(gl, mesh, program);
        how.prepare(gl);
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program);
        turn(gl, program, frame);
        draw(gl);
      },
      how.settings);
}

}  // namespace gluray::test::culled
