// The shaders of Open3D's visualizer, against the real OpenGL.
#include "tests/reference/programs/viewers/viewer_stage.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

const char* const kOpen3dPhongVertex = R"(#version 330

in vec3 vertex_position;
in vec3 vertex_normal;
in vec3 vertex_color;

out vec3 vertex_position_world;
out vec3 vertex_normal_camera;
out vec3 eye_dir_camera;
out mat4 light_dir_camera_4;
out vec3 fragment_color;

uniform mat4 MVP;
uniform mat4 V;
uniform mat4 M;
uniform mat4 light_position_world_4;

void main()
{
    gl_Position = MVP * vec4(vertex_position, 1);
    vertex_position_world = (M * vec4(vertex_position, 1)).xyz;

    vec3 vertex_position_camera = (V * M * vec4(vertex_position, 1)).xyz;
    eye_dir_camera = vec3(0, 0, 0) - vertex_position_camera;

    vec4 v = vec4(vertex_position_camera, 1);
    light_dir_camera_4 = V * light_position_world_4 - mat4(v, v, v, v);

    vertex_normal_camera = (V * M * vec4(vertex_normal, 0)).xyz;
    if (dot(eye_dir_camera, vertex_normal_camera) < 0.0)
        vertex_normal_camera = vertex_normal_camera * -1.0;

    fragment_color = vertex_color;
}
)";
const char* const kOpen3dPhongFragment = R"(#version 330

in vec3 vertex_position_world;
in vec3 vertex_normal_camera;
in vec3 eye_dir_camera;
in mat4 light_dir_camera_4;
in vec3 fragment_color;

uniform mat4 light_color_4;
uniform vec4 light_diffuse_power_4;
uniform vec4 light_specular_power_4;
uniform vec4 light_specular_shininess_4;
uniform vec4 light_ambient;

out vec4 FragColor;

void main()
{
    vec3 diffuse_color = fragment_color;
    vec3 ambient_color = light_ambient.xyz * diffuse_color;
    vec3 specular_color = vec3(1.0, 1.0, 1.0);
    vec4 cos_theta;
    vec4 cos_alpha;
    vec3 n, e, l, r;

    n = normalize(vertex_normal_camera);
    e = normalize(eye_dir_camera);
    l = normalize(light_dir_camera_4[0].xyz);
    r = reflect(-l, n);
    cos_theta[0] = clamp(dot(n, l), 0, 1);
    cos_alpha[0] = clamp(dot(e, r), 0, 1);

    l= normalize(light_dir_camera_4[1].xyz);
    r = reflect(-l, n);
    cos_theta[1] = clamp(dot(n, l), 0, 1);
    cos_alpha[1] = clamp(dot(e, r), 0, 1);

    l= normalize(light_dir_camera_4[2].xyz);
    r = reflect(-l, n);
    cos_theta[2] = clamp(dot(n, l), 0, 1);
    cos_alpha[2] = clamp(dot(e, r), 0, 1);

    l= normalize(light_dir_camera_4[3].xyz);
    r = reflect(-l, n);
    cos_theta[3] = clamp(dot(n, l), 0, 1);
    cos_alpha[3] = clamp(dot(e, r), 0, 1);

    FragColor = vec4(ambient_color + 
            diffuse_color * light_color_4[0].xyz * light_diffuse_power_4[0] * cos_theta[0] +
            specular_color * light_color_4[0].xyz * light_specular_power_4[0] * pow(cos_alpha[0], light_specular_shininess_4[0]) +
            diffuse_color * light_color_4[1].xyz * light_diffuse_power_4[1] * cos_theta[1] +
            specular_color * light_color_4[1].xyz * light_specular_power_4[1] * pow(cos_alpha[1], light_specular_shininess_4[1]) +
            diffuse_color * light_color_4[2].xyz * light_diffuse_power_4[2] * cos_theta[2] +
            specular_color * light_color_4[2].xyz * light_specular_power_4[2] * pow(cos_alpha[2], light_specular_shininess_4[2]) +
            diffuse_color * light_color_4[3].xyz * light_diffuse_power_4[3] * cos_theta[3] +
            specular_color * light_color_4[3].xyz * light_specular_power_4[3] * pow(cos_alpha[3], light_specular_shininess_4[3]), 1);
}
)";
const char* const kOpen3dSimpleVertex =
    "#version 330\nin vec3 vertex_position;\nin vec3 vertex_color;\nuniform mat4 MVP;\nout vec3 "
    "fragment_color;\n"
    "void main()\n{\n    gl_Position = MVP * vec4(vertex_position, 1);\n    fragment_color = "
    "vertex_color;\n}\n";
const char* const kOpen3dSimpleFragment =
    "#version 330\nin vec3 fragment_color;\nout vec4 FragColor;\n"
    "void main()\n{\n    FragColor = vec4(fragment_color, 1);\n}\n";
const char* const kOpen3dNormalVertex =
    "#version 330\nin vec3 vertex_position;\nin vec3 vertex_normal;\nout vec3 vertex_normal_camera;\n"
    "uniform mat4 MVP;\nuniform mat4 V;\nuniform mat4 M;\n"
    "void main()\n{\n    gl_Position = MVP * vec4(vertex_position, 1);\n"
    "    vertex_normal_camera = (V * M * vec4(vertex_normal, 0)).xyz;\n}\n";
const char* const kOpen3dNormalFragment =
    "#version 330\nin vec3 vertex_normal_camera;\nout vec4 FragColor;\n"
    "void main()\n{\n    FragColor = vec4(vertex_normal_camera * 0.5 + 0.5, 1);\n}\n";

void drawOpen3d(Gl gl, GLuint program, const glm::mat4& model) {
  beginFrame(gl);
  gl.Disable(GL_BLEND);
  gl.UseProgram(program);
  const Bowl bowl = bowlWithColors();
  const View view = perspectiveView(35);
  setMat4(gl, program, "V", glm::mat4(view.eyeFromObject));
  setMat4(gl, program, "M", model);
  setMat4(gl, program, "MVP", glm::mat4(view.clipFromEye * view.eyeFromObject) * model);
  setMat4(gl, program, "light_position_world_4",
          glm::mat4({4, 3, 2, 1}, {4, -3, -2, 1}, {-4, 3, -2, 1}, {-4, -3, 2, 1}));
  setMat4(gl, program, "light_color_4",
          glm::mat4({1, 0.9f, 0.8f, 0}, {1, 1, 1, 0}, {0.5f, 1, 0.7f, 0}, {1, 1, 1, 0}));
  const auto set4 = [&](const char* name, const glm::vec4& v) {
    gl.Uniform4fv(gl.GetUniformLocation(program, name), 1, &v.x);
  };
  set4("light_diffuse_power_4", {0.66f, 0.5f, 0.6f, 0.4f}),
      set4("light_specular_power_4", {0.2f, 0.3f, 0.25f, 0});
  set4("light_specular_shininess_4", {100, 20, 5, 100}), set4("light_ambient", {0.1f, 0.05f, 0.2f, 0});
  const BowlDraw arrays(gl, bowl);
  setArray(gl, program, "vertex_position", bowl.mesh.positions),
      setArray(gl, program, "vertex_color", bowl.colors);
  setArray(gl, program, "vertex_normal", bowl.mesh.normals);
  arrays.draw();
}
void drawOpen3dInPlace(Gl gl, GLuint program) { drawOpen3d(gl, program, glm::mat4(1)); }
void drawOpen3dMoved(Gl gl, GLuint program) {
  drawOpen3d(gl, program, glm::mat4({1, 0, 0, 0}, {0, 0.5f, 0, 0}, {0, 0, 1, 0}, {0.2f, 0, 0, 1}));
}

TEST(Open3dPrograms, LitOnesAreTraced) {
  expectTraced("open3d_phong", kOpen3dPhongVertex, kOpen3dPhongFragment, drawOpen3dInPlace);
}
TEST(Open3dPrograms, UnlitOnesAreTraced) {
  expectTraced("open3d_simple", kOpen3dSimpleVertex, kOpen3dSimpleFragment, drawOpen3dMoved);
}
TEST(Open3dPrograms, ColorsOfNormalsAreTraced) {
  expectTraced("open3d_normals", kOpen3dNormalVertex, kOpen3dNormalFragment, drawOpen3dInPlace);
}
TEST(Open3dPrograms, MovedObjectsAreLeft) {
  expectLeft("open3d_moved", kOpen3dPhongVertex, kOpen3dPhongFragment, drawOpen3dMoved);
}
TEST(Open3dPrograms, MutantsAreSeen) {
  expectViewerMutantsSeen("open3d_phong", kOpen3dPhongVertex, kOpen3dPhongFragment, drawOpen3dInPlace);
}

}  // namespace
}  // namespace gluray::test
