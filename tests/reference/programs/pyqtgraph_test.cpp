// The shaders of PyQtGraph's meshes since version 0.14, against the real OpenGL.
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace gluray::test {
namespace {

struct PlotCase {
  const char* name;
  const char* normal;  // of the vertex shader; null: without
  const char* colors;  // main of the fragment shader
};
void PrintTo(const PlotCase& c, std::ostream* out) { *out << c.name; }

constexpr const char* kPlotEye = "normalize(u_normal * a_normal)";
const PlotCase kPlotCases[] = {
    {"shaded", kPlotEye,
     "float p = dot(v_normal, normalize(vec3(1.0, -1.0, -1.0)));\n p = p < 0. ? 0. : p * 0.8;\n"
     "vec3 rgb = v_color.rgb * (0.2 + p);\n gl_FragColor = vec4(rgb, v_color.a);\n"},
    {"view_normals", kPlotEye, "vec3 rgb = (v_normal + 1.0) * 0.5;\n gl_FragColor = vec4(rgb, v_color.a);\n"},
    {"object_normals", "normalize(a_normal)",
     "vec3 rgb = (v_normal + 1.0) * 0.5;\n gl_FragColor = vec4(rgb, v_color.a);\n"},
    {"balloon", kPlotEye,
     "vec4 color = v_color;\n color.w = min(color.w + 2.0 * color.w * pow(v_normal.x*v_normal.x + "
     "v_normal.y*v_normal.y, 5.0), 1.0);\n gl_FragColor = color;\n"},
    {"rim", kPlotEye,
     "float s = pow(v_normal.x*v_normal.x + v_normal.y*v_normal.y, 2.0);\n"
     "vec3 rgb = v_color.rgb + s * (1.0-v_color.rgb);\n gl_FragColor = vec4(rgb, v_color.a);\n"},
    {"heights", nullptr,
     "vec3 color;\n color.x = colorMap[0] * (zpos + colorMap[1]);\n if (colorMap[2] != 1.0)\n color.x = "
     "pow(color.x, colorMap[2]);\n color.x = clamp(color.x, 0.0, 1.0);\n"
     "color.y = colorMap[3] * (zpos + colorMap[4]);\n if (colorMap[5] != 1.0)\n color.y = pow(color.y, "
     "colorMap[5]);\n color.y = clamp(color.y, 0.0, 1.0);\n"
     "color.z = colorMap[6] * (zpos + colorMap[7]);\n if (colorMap[8] != 1.0)\n color.z = pow(color.z, "
     "colorMap[8]);\n color.z = clamp(color.z, 0.0, 1.0);\n gl_FragColor = vec4(color, 1.0);\n"},
};

std::string plotVertexText(const PlotCase& c) {
  const std::string start =
      "#version 120\nuniform mat4 u_mvp;\nuniform mat3 u_normal;\nattribute vec4 a_position;\n"
      "attribute vec3 a_normal;\nattribute vec4 a_color;\nvarying vec4 v_color;\nvarying vec3 v_normal;\n"
      "varying float zpos;\nvoid main() {\n";
  const std::string position = "gl_Position = u_mvp * a_position;\n}\n";
  if (!c.normal) return start + "zpos = a_position.z;\n" + position;
  return start + "v_normal = " + c.normal + ";\nv_color = a_color;\n" + position;
}

std::string plotFragmentText(const PlotCase& c) {
  return std::string(
             "#version 120\n#ifdef GL_ES\nprecision mediump float;\n#endif\nuniform float colorMap[9];\n"
             "varying vec4 v_color;\nvarying vec3 v_normal;\nvarying float zpos;\nvoid main() {\n") +
         c.colors + "}\n";
}

class PyqtgraphPrograms : public testing::TestWithParam<PlotCase> {};

TEST_P(PyqtgraphPrograms, AreTraced) {
  const PlotCase& c = GetParam();
  const auto draw = [&](Gl gl) {
    beginFrame(gl);
    const GLuint program = makeProgram(gl, plotVertexText(c), plotFragmentText(c));
    gl.UseProgram(program);
    const ProgramMesh mesh = ball(16);
    const View view = perspectiveView(35);
    setMat4(gl, program, "u_mvp", glm::mat4(view.clipFromEye * view.eyeFromObject));
    setMat3(gl, program, "u_normal", glm::mat3(glm::transpose(glm::inverse(glm::dmat3(view.eyeFromObject)))));
    const GLfloat colorMap[] = {0.5f, 1, 2, 0.4f, 1.2f, 1, 0.3f, 1.5f, 0.7f};
    gl.Uniform1fv(gl.GetUniformLocation(program, "colorMap"), 9, colorMap);
    const auto array = [&](const char* name, GLint size, GLenum type, const auto& values) {
      const GLint place = gl.GetAttribLocation(program, name);
      makeBuffer(gl, GL_ARRAY_BUFFER, values);
      if (place < 0) return;
      gl.EnableVertexAttribArray(static_cast<GLuint>(place));
      gl.VertexAttribPointer(static_cast<GLuint>(place), size, type, type == GL_UNSIGNED_BYTE, 0, nullptr);
    };
    array("a_position", 3, GL_FLOAT, mesh.positions), array("a_normal", 3, GL_FLOAT, mesh.normals);
    array("a_color", 4, GL_UNSIGNED_BYTE, mesh.colors);
    makeBuffer(gl, GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
    gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  };
  expectBoth(std::string("pyqtgraph_") + c.name, draw, 1, {kProgramWidth, kProgramHeight});
}

INSTANTIATE_TEST_SUITE_P(All, PyqtgraphPrograms, testing::ValuesIn(kPlotCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
