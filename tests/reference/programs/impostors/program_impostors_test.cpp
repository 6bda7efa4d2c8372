// Impostors other than VTK's: the keys of the section [impostors] of family files, each tested by a program
// that computes exactly that.
#include "tests/reference/programs/impostors/own_impostors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gluray::test {
namespace {

const char* const kImpostorsVertex =
    "#version 150\nin vec3 place, way; in float size; in vec3 paint; uniform mat4 modelview;\n"
    "out vec3 c, a, tint; out float r;\n"
    "void main() { c = (modelview * vec4(place, 1)).xyz; a = mat3(modelview) * way; tint = paint; r = size; "
    "}\n";

/// A square that covers the bounding sphere of the whole impostor.
const char* const kImpostorsGeometry =
    "#version 150\nlayout(points) in; layout(triangle_strip, max_vertices = 4) out;\n"
    "in vec3 c[], a[], tint[]; in float r[]; uniform mat4 projection; out vec3 center, axis, color, at; out "
    "float radius;\n"
    "void main() { for (int i = 0; i < 4; ++i) {\n"
    "  center = c[0], axis = a[0], color = tint[0], radius = r[0];\n"
    "  float side = 2.0 * (r[0] + 0.5 * length(a[0]));\n"
    "  at = c[0] + side * vec3(i % 2 == 0 ? -1 : 1, i / 2 == 0 ? -1 : 1, 0);\n"
    "  gl_Position = projection * vec4(at, 1); EmitVertex(); } }\n";

const std::string kImpostorsFragmentHead =
    "#version 150\nin vec3 center, axis, color, at; in float radius; uniform mat4 projection; uniform int "
    "ortho;\n"
    "uniform vec3 sun; out vec4 pixel;\n"
    "void show(vec3 p, vec3 n, vec3 base) { vec4 clip = projection * vec4(p, 1);\n"
    "  gl_FragDepth = 0.5 * clip.z / clip.w + 0.5;\n"
    "  pixel = vec4(base * (0.2 + 0.8 * max(dot(n, -sun), 0.0)), 1); }\n"
    "void main() { vec3 o = ortho != 0 ? vec3(at.xy, 0) : vec3(0), d = ortho != 0 ? vec3(0, 0, -1) : "
    "normalize(at);\n"
    "  vec3 m = o - center;\n";

const std::string kImpostorsFamilyHead =
    kOwnFamily + "match.geometry_shader = true\ntransform.normal_matrix = \"modelview\"\n";

struct ImpostorCase {
  const char *name, *fragment, *family;
  bool parallel = false, indices = false;
};
void PrintTo(const ImpostorCase& c, std::ostream* out) { *out << c.name; }

const char* const kBall =
    "  float b = dot(m, d), q = b * b - dot(m, m) + radius * radius;\n"
    "  if (q < 0.0) discard;\n  vec3 p = o + (-b - sqrt(q)) * d; show(p, (p - center) / radius, color); }\n";
const char* const kDisc =
    "  vec3 n = ortho != 0 ? vec3(0, 0, 1) : normalize(-center); vec3 p = o - dot(m, n) / dot(d, n) * d;\n"
    "  vec3 from = p - center; float share = dot(from, from) / (radius * radius);\n"
    "  if (share > 1.0) discard;\n  show(p, n, (1.0 - share) * color); }\n";
const char* const kCylinder =
    "  vec3 z = normalize(axis); if (z.z < 0.0) z = -z;\n  float h = 0.5 * length(axis), dz = dot(d, z), mz "
    "= dot(m, z);\n"
    "  vec3 e = d - dz * z, f = m - mz * z; float a = dot(e, e), b = dot(e, f);\n"
    "  float q = b * b - a * (dot(f, f) - radius * radius); if (q < 0.0) discard;\n"
    "  float s = (-b - sqrt(q)) / a, in_ = mz + s * dz, out_ = mz + (-b + sqrt(q)) / a * dz;\n"
    "  if (abs(in_) <= h) { show(o + s * d, (f + s * e) / radius, color); return; }\n"
    "  if (in_ < -h || out_ > h) discard;\n  show(o + (h - mz) / dz * d, z, color); }\n";
const char* const kBallFamily =
    "impostors.shape = \"spheres\"\nimpostors.radius = \"size\"\nmatch.ignored = \"way\"\n";
const char* const kDiscFamily =
    "impostors.shape = \"discs\"\nimpostors.radius = \"size\"\nimpostors.fades = true\nmatch.ignored = "
    "\"way\"\n";
const char* const kCylinderFamily =
    "impostors.shape = \"cylinders\"\nimpostors.radius = \"size\"\nimpostors.axis = \"way\"\n";

const ImpostorCase kImpostorCases[] = {
    {"balls", kBall, kBallFamily},
    {"balls_parallel", kBall, kBallFamily, true},
    {"balls_by_number", kBall, kBallFamily, false, true},
    {"discs", kDisc, kDiscFamily},
    {"discs_parallel", kDisc, kDiscFamily, true},
    {"cylinders", kCylinder, kCylinderFamily},
    {"cylinders_parallel", kCylinder, kCylinderFamily, true, true},
};

void drawImpostorCase(Gl gl, const ImpostorCase& c) {
  const GLuint program =
      linkImpostors(gl, kImpostorsVertex, kImpostorsGeometry, kImpostorsFragmentHead + c.fragment);
  std::vector<float> ways, sizes;
  for (int i = 0; i < kImpostors; ++i) {
    const auto t = static_cast<float>(i);
    for (const float v : {std::sin(t), std::cos(3 * t), std::sin(2 * t)}) ways.push_back(0.4f * v);
    sizes.push_back(0.08f + 0.03f * std::sin(5 * t));
  }
  placeImpostors(gl, program);
  addImpostorValues(gl, program, "way", 3, ways), addImpostorValues(gl, program, "size", 1, sizes);
  beginFrame(gl);
  gl.UseProgram(program);
  lookAtImpostors(gl, program, c.parallel ? parallelView(35) : perspectiveView(35), c.parallel);
  if (!c.indices) return gl.DrawArrays(GL_POINTS, 5, kImpostors - 5);
  std::vector<GLushort> numbers;
  for (int i = 0; i < kImpostors; i += 2) numbers.push_back(static_cast<GLushort>(kImpostors - 1 - i));
  drawNumbered(gl, GL_POINTS, numbers);
}

class ProgramImpostors : public testing::TestWithParam<ImpostorCase> {};

TEST_P(ProgramImpostors, AreWhatTheProgramComputes) {
  const ImpostorCase& c = GetParam();
  expectBoth(
      std::string("impostors_") + c.name, [&](Gl gl) { drawImpostorCase(gl, c); }, 1, {}, kProgramTolerance,
      kImpostorsFamilyHead + c.family);
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramImpostors, testing::ValuesIn(kImpostorCases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(ProgramImpostor, TheViewerTurnsAndNothingIsBuilt) {
  const Outcome outcome = expectSame(
      "impostors_turned",
      [&](Gl gl) {
        drawImpostorCase(gl, kImpostorCases[0]);
        GLint program = 0;
        gl.GetIntegerv(GL_CURRENT_PROGRAM, &program);
        for (int i = 0; i < 5; ++i) {
          gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
          setMat4(gl, static_cast<GLuint>(program), "modelview",
                  glm::mat4(perspectiveView(35 + 20 * i).eyeFromObject));
          gl.DrawArrays(GL_POINTS, 5, kImpostors - 5);
        }
      },
      6, {}, kProgramTolerance, kImpostorsFamilyHead + kBallFamily);
  EXPECT_EQ(outcome.statistics.meshesBuilt, 1u);
}

TEST(ProgramImpostor, CulledOnesAndThoseOfTrianglesAreLeftToTheRealOne) {
  expectBoth(
      "impostors_culled",
      [](Gl gl) {
        gl.Enable(GL_CULL_FACE);
        drawImpostorCase(gl, kImpostorCases[0]);
      },
      0, {}, kProgramTolerance, kImpostorsFamilyHead + kBallFamily);
}

}  // namespace
}  // namespace gluray::test
