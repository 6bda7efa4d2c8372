// Fog, highlights and back faces of family files, each tested by a program that computes exactly that.
#include "tests/reference/programs/built_in/built_in_stage.h"
#include "tests/reference/programs/program_stage.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

/// A program of its own with a family. Its uniforms are set by `set`, the view and `unlit` before.
struct LookCase {
  const char *name, *fragment, *family;
  void (*set)(Gl gl, GLuint program);
  bool inside = false;    // only back faces are drawn
  bool parallel = false;  // projection
};
void PrintTo(const LookCase& c, std::ostream* out) { *out << c.name; }

const char* const kLookVertex =
    "in vec3 vertexMC, normalMC; in vec4 scalarColor; uniform mat4 mvp, modelview; uniform mat3 turn;\n"
    "out vec3 n, p; out vec4 c;\n"
    "void main() { n = turn * normalMC; p = (modelview * vec4(vertexMC, 1)).xyz; c = scalarColor;\n"
    "  gl_Position = mvp * vec4(vertexMC, 1); }\n";

const char* const kLookFamily =
    "[[family]]\nname = \"look\"\nmatch.active = \"vertexMC\"\nvertex.position = \"vertexMC\"\n"
    "vertex.normal = \"normalMC\"\nvertex.color = \"scalarColor\"\ntransform.clip_from_object = \"mvp\"\n"
    "transform.eye_from_object = \"modelview\"\ntransform.normal_matrix = \"turn\"\n";

/// Two lamps, the first with a highlight of its own; light from both is clamped.
const char* const kLampsFragment =
    "struct Lamp { vec4 glow; vec3 way; }; uniform Lamp lamps[2]; uniform vec4 dim; uniform float shine0, "
    "shine;\n"
    "uniform float spark0; uniform vec3 spark; uniform bool turned; in vec3 n, p; in vec4 c; out vec4 "
    "color;\n"
    "void main() { vec3 m = normalize(n), light = vec3(dim.g), gleam = vec3(0);\n"
    "  if (!gl_FrontFacing) m = turned ? -m : vec3(0);\n"
    "  for (int i = 0; i < 2; ++i) { vec3 l = normalize(lamps[i].way); float d = dot(m, l);\n"
    "    if (d > 0.0) { light += d * lamps[i].glow.r;\n"
    "      float e = max(dot(m, normalize(l + vec3(0, 0, 1))), 0.0);\n"
    "      gleam += i == 0 ? vec3(spark0) * pow(e, shine0) : spark * pow(e, shine); } }\n"
    "  color = vec4(c.rgb * min(light, 1.0) + gleam, 1); }\n";
const char* const kLampsFamily =
    "lights.direction = \"lamps[{}].way\"\nlights.direction_towards_light = true\nlights.color = "
    "\"lamps[{}].glow.r\"\nlights.specular = \"half\"\nlights.viewer = \"infinite\"\nlights.clamped = true\n"
    "lights.specular_color = [\"spark0\", \"spark\"]\nlights.shininess = [\"shine0\", \"shine\"]\n"
    "material.ambient_intensity = \"dim.g\"\nnormals.flip_back_faces = \"turned\"\n"
    "normals.dark_back_faces = true\n";

void setLamps(Gl gl, GLuint program) {
  const auto place = [&](const char* name) { return gl.GetUniformLocation(program, name); };
  gl.Uniform4f(place("lamps[0].glow"), 0.7f, 0, 0, 0), gl.Uniform4f(place("lamps[1].glow"), 0.6f, 1, 1, 1);
  setVec3(gl, program, "lamps[0].way", {0, 0.2f, 3}), setVec3(gl, program, "lamps[1].way", {4, 3, 2});
  gl.Uniform4f(place("dim"), 0.9f, 0.25f, 0.9f, 1);
  setFloat(gl, program, "spark0", 0.4f), setVec3(gl, program, "spark", {0.3f, 0.1f, 0.5f});
  setFloat(gl, program, "shine0", 40), setFloat(gl, program, "shine", 8);
}

void setHaze(Gl gl, GLuint program) {
  setVec3(gl, program, "haze", {0.2f, 0.3f, 0.9f});
  setFloat(gl, program, "far", 4.2f), setFloat(gl, program, "near", 3.1f);
  setFloat(gl, program, "thick", 0.3f), setFloat(gl, program, "steep", 0.8f);
}

const char* const kSwitchedFragment =
    "uniform vec3 haze, way, dim; uniform float near, far; uniform bool lit; in vec3 n, p; in vec4 c; out "
    "vec4 "
    "color;\n"
    "void main() { vec3 shown = c.rgb; if (lit) shown *= dim + max(dot(normalize(n), way), 0.0);\n"
    "  color = vec4(mix(haze, shown, clamp((far + p.z) / (far - near), 0.0, 1.0)), 1); }\n";
const char* const kSwitchedFamily =
    "lights.enabled = \"lit\"\nlights.direction = \"way\"\nlights.direction_towards_light = true\n"
    "material.ambient_intensity = \"dim\"\nfog.color = \"haze\"\nfog.start = \"near\"\nfog.end = \"far\"\n";

void setSwitched(Gl gl, GLuint program) {
  setHaze(gl, program), setVec3(gl, program, "way", {0, 0.6f, 0.8f});
  setVec3(gl, program, "dim", glm::vec3(0.5f));
}

const char* const kPaintedFragment =
    "uniform vec3 haze, way, paint; uniform float near, far; uniform bool painted; in vec3 n, p; in vec4 c; "
    "out vec4 color;\n"
    "void main() { vec3 shown = c.rgb * (0.3 + max(dot(normalize(n), way), 0.0));\n"
    "  shown = mix(haze, shown, clamp((far + p.z) / (far - near), 0.0, 1.0));\n"
    "  color = vec4(painted && !gl_FrontFacing ? paint : shown, 1); }\n";
const char* const kPaintedFamily =
    "color.back_faces = \"paint\"\ncolor.back_faces_if = \"painted\"\nlights.direction = \"way\"\n"
    "lights.direction_towards_light = true\nmaterial.ambient_intensity = 0.3\nfog.color = \"haze\"\n"
    "fog.start = \"near\"\nfog.end = \"far\"\n";

void setPainted(Gl gl, GLuint program) {
  setHaze(gl, program), setVec3(gl, program, "way", {0, 0.6f, 0.8f});
  setVec3(gl, program, "paint", {0.9f, 0.4f, 0.1f});
}

const LookCase kLookCases[] = {
    {"lamps", kLampsFragment, kLampsFamily, setLamps},
    {"dark_back_faces", kLampsFragment, kLampsFamily, setLamps, true},
    {"flipped_back_faces", kLampsFragment, kLampsFamily,
     [](Gl gl, GLuint program) { setLamps(gl, program), setInteger(gl, program, "turned", 1); }, true},
    // Back faces have a colour of their own, which neither light nor fog changes.
    {"painted_back_faces", kPaintedFragment, kPaintedFamily,
     [](Gl gl, GLuint program) { setPainted(gl, program), setInteger(gl, program, "painted", 1); }, true},
    {"back_faces_not_painted", kPaintedFragment, kPaintedFamily, setPainted, true},
    {"front_faces_not_painted", kPaintedFragment, kPaintedFamily,
     [](Gl gl, GLuint program) { setPainted(gl, program), setInteger(gl, program, "painted", 1); }},
    // The array's last element is no light; the source says how many there are.
    {"unrolled",
     "uniform vec3 glow[3], way[2]; in vec3 n, p; in vec4 c; out vec4 color;\n"
     "void main() {\nvec3 m = normalize(n), sum = glow[2];\nsum += glow[0] * max(dot(m, -way[0]), 0.0);\n"
     "sum += glow[1] * max(dot(m, -way[1]), 0.0);\ncolor = vec4(c.rgb * sum, 1);\n}\n",
     "lights.color = \"glow[{}]\"\nlights.direction = \"way[{}]\"\nlights.count_in_source = \"sum += \"\n"
     "material.ambient_intensity = \"glow[2]\"\nmatch.code = \"lamps\"\n[[code]]\nname = \"lamps\"\n"
     "statements = \"\"\"\nn = turn * normalMC; p = (modelview * vec4(vertexMC, 1)).xyz; c = scalarColor;\n"
     "gl_Position = mvp * vec4(vertexMC, 1);\nvec3 m = normalize(n), sum = glow[2];\n"
     "sum += glow[0] * max(dot(m, -way[0]), 0.0);\nsum += glow[1] * max(dot(m, -way[1]), 0.0);\n"
     "color = vec4(c.rgb * sum, 1);\n\"\"\"\n",
     [](Gl gl, GLuint program) {
       setVec3(gl, program, "glow[0]", {0.8f, 0.6f, 0.5f}),
           setVec3(gl, program, "glow[1]", {0.1f, 0.3f, 0.5f});
       setVec3(gl, program, "glow[2]", glm::vec3(0.2f));
       setVec3(gl, program, "way[0]", {0, 0, -1}), setVec3(gl, program, "way[1]", {0.6f, -0.8f, 0});
     }},
    // The last two of three lights have no highlights: the source says so.
    {"few_highlights",
     "uniform vec3 glow[3], way[3]; uniform float shine; in vec3 n, p; in vec4 c; out vec4 color;\n"
     "vec3 m; vec3 lit(vec3 paint, vec3 g, vec3 w, float s) {\nfloat d = max(dot(m, -w), 0.0);\n"
     "float e = d > 0.0 ? pow(max(dot(m, normalize(normalize(-p) - w)), 0.0), shine) : 0.0;\n"
     "return paint * g * d + s * e * g;\n}\nvoid main() {\nm = normalize(n);\n"
     "vec3 sum = c.rgb * 0.1;\nsum += lit(c.rgb, glow[0], way[0], 1.0);\n"
     "sum += lit(c.rgb, glow[1], way[1], 0.0);\nsum += lit(c.rgb, glow[2], way[2], 0.0);\n"
     "color = vec4(sum, 1);\n}\n",
     "lights.color = \"glow[{}]\"\nlights.direction = \"way[{}]\"\nlights.count_in_source = \"sum += \"\n"
     "lights.no_highlight_in_source = \"], 0.0);\"\nlights.specular = \"half\"\n"
     "material.ambient_intensity = 0.1\nmaterial.specular_intensity = 1\nmaterial.shininess = \"shine\"\n"
     "match.code = \"few\"\n[[code]]\nname = \"few\"\n"
     "statements = \"\"\"\nn = turn * normalMC; p = (modelview * vec4(vertexMC, 1)).xyz; c = scalarColor;\n"
     "gl_Position = mvp * vec4(vertexMC, 1);\n"
     "vec3 lit(vec3 paint, vec3 g, vec3 w, float s) {\nfloat d = max(dot(m, -w), 0.0);\n"
     "float e = d > 0.0 ? pow(max(dot(m, normalize(normalize(-p) - w)), 0.0), shine) : 0.0;\n"
     "return paint * g * d + s * e * g;\n}\nvec3 m;\nm = normalize(n);\n"
     "vec3 sum = c.rgb * 0.1;\nsum += lit(c.rgb, glow[0], way[0], 1.0);\n"
     "sum += lit(c.rgb, glow[1], way[1], 0.0);\nsum += lit(c.rgb, glow[2], way[2], 0.0);\n"
     "color = vec4(sum, 1);\n\"\"\"\n",
     [](Gl gl, GLuint program) {
       setVec3(gl, program, "glow[0]", {0.5f, 0.6f, 0.5f}),
           setVec3(gl, program, "glow[1]", {0.3f, 0.3f, 0.5f});
       setVec3(gl, program, "glow[2]", {0.2f, 0.1f, 0.3f}), setVec3(gl, program, "way[0]", {0, 0, -1});
       setVec3(gl, program, "way[1]", {0.6f, -0.8f, 0}), setVec3(gl, program, "way[2]", {-0.6f, 0, -0.8f});
       setFloat(gl, program, "shine", 20);
     }},
    // Highlights by the reflected ray of a viewer at infinity, with the lamp's colour and the lamp's
    // exponent.
    {"mirror",
     "uniform vec3 glow, way; uniform float shine; in vec3 n, p; in vec4 c; out vec4 color;\n"
     "void main() { vec3 m = normalize(n), l = normalize(way); float d = max(dot(m, -l), 0.0);\n"
     "  float e = d > 0.0 ? pow(max(reflect(l, m).z, 0.00001), shine) : 0.0;\n"
     "  color = vec4(c.rgb * (0.1 + d * glow) + e * glow, 1); }\n",
     "lights.direction = \"way\"\nlights.color = \"glow\"\nlights.viewer = \"infinite\"\nlights.shininess = "
     "\"shine\"\nmaterial.ambient_intensity = 0.1\n",
     [](Gl gl, GLuint program) {
       setVec3(gl, program, "glow", {0.9f, 0.8f, 0.5f}), setVec3(gl, program, "way", {-1, -2, -2});
       setFloat(gl, program, "shine", 20);
     }},
    // Fog begins and ends within the ball.
    {"fog_start",
     "uniform vec3 haze; uniform float near, far; in vec3 n, p; in vec4 c; out vec4 color;\n"
     "void main() { float dim = (far + p.z) / (far - near);\n"
     "  color = vec4(mix(haze, c.rgb, clamp(dim, 0.0, 1.0)), 1); }\n",
     "lights.model = \"unlit\"\nfog.color = \"haze\"\nfog.start = \"near\"\nfog.end = \"far\"\n", setHaze},
    {"fog_scale_parallel",
     "uniform vec3 haze; uniform float far, steep; in vec3 n, p; in vec4 c; out vec4 color;\n"
     "void main() { float dim = (far + p.z) * steep; vec3 lit = c.rgb * max(normalize(n).z, 0.0);\n"
     "  color = vec4(mix(haze, lit, clamp(dim, 0.0, 1.0)), 1); }\n",
     "lights.direction = [0, 0, -1]\nfog.color = \"haze\"\nfog.end = \"far\"\nfog.scale = \"steep\"\n",
     setHaze, false, true},
    // Beyond its end colours go on beyond that of the fog.
    {"fog_extrapolated",
     "uniform vec3 haze; uniform float far, steep; in vec3 n, p; in vec4 c; out vec4 color;\n"
     "void main() { float dim = (far + p.z) * steep;\n"
     "  color = vec4(dim >= 1.0 ? c.rgb : mix(haze, c.rgb, dim), 1); }\n",
     "lights.model = \"unlit\"\nfog.color = \"haze\"\nfog.end = \"far\"\nfog.scale = \"steep\"\n"
     "fog.extrapolated = true\n",
     [](Gl gl, GLuint program) { setHaze(gl, program), setFloat(gl, program, "far", 3.4f); }},
    {"fog_exp",
     "uniform float thick; in vec3 n, p; in vec4 c; out vec4 color;\n"
     "void main() { color = vec4(mix(vec3(0.9, 0.5, 0.1), c.rgb, exp(p.z * thick)), 1); }\n",
     "lights.model = \"unlit\"\nfog.mode = \"exp\"\nfog.color = [0.9, 0.5, 0.1]\nfog.density = \"thick\"\n",
     setHaze},
    {"fog_exp2",
     "uniform float thick; in vec3 n, p; in vec4 c; out vec4 color;\n"
     "void main() { float d = p.z * thick; color = vec4(mix(vec3(0.9), c.rgb, exp(-d * d)), 1); }\n",
     "lights.model = \"unlit\"\nfog.mode = \"exp2\"\nfog.color = 0.9\nfog.density = \"thick\"\n", setHaze},
    // Lights that are switched off leave the colours themselves, in fog.
    {"lights_on", kSwitchedFragment, kSwitchedFamily,
     [](Gl gl, GLuint program) { setSwitched(gl, program), setInteger(gl, program, "lit", 1); }},
    {"lights_off", kSwitchedFragment, kSwitchedFamily, setSwitched},
};

void drawLook(Gl gl, const LookCase& c) {
  const ProgramMesh mesh = ball(24);
  const std::string version = "#version 150\n";
  const GLuint program = makeProgram(gl, version + kLookVertex, version + c.fragment);
  upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  const View view = c.parallel ? parallelView(35) : perspectiveView(35);
  setMat4(gl, program, "mvp", glm::mat4(view.clipFromEye * view.eyeFromObject));
  setMat4(gl, program, "modelview", glm::mat4(view.eyeFromObject));
  setMat3(gl, program, "turn", glm::mat3(view.eyeFromObject));
  c.set(gl, program);
  if (c.inside) gl.Enable(GL_CULL_FACE), gl.CullFace(GL_FRONT);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

class ProgramLook : public testing::TestWithParam<LookCase> {};

TEST_P(ProgramLook, SaysWhatTheProgramComputes) {
  const LookCase& c = GetParam();
  expectBoth(
      c.name, [&](Gl gl) { drawLook(gl, c); }, 1, {}, kProgramTolerance, std::string(kLookFamily) + c.family);
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramLook, testing::ValuesIn(kLookCases),
                         [](const auto& info) { return std::string(info.param.name); });

struct FrontColorCase {
  const char* name;
  void (*before)(Gl gl);
  int traced;
  void (*after)(Gl gl) = [](Gl) {};
};
void PrintTo(const FrontColorCase& c, std::ostream* out) { *out << c.name; }

const FrontColorCase kFrontColorCases[] = {
    {"smooth", [](Gl) {}, 1},
    {"flat", [](Gl gl) { gl.ShadeModel(GL_FLAT); }, 0},
    {"flat_later", [](Gl) {}, 1,
     [](Gl gl) { gl.ShadeModel(GL_FLAT), gl.Enable(GL_VERTEX_PROGRAM_TWO_SIDE); }},
    {"two_sided", [](Gl gl) { gl.Enable(GL_VERTEX_PROGRAM_TWO_SIDE); }, 0},
    {"unclamped", [](Gl gl) { gl.ClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE); }, 0},
};

/// The program's colours pass through gl_FrontColor.
void drawThroughFrontColor(Gl gl, const FrontColorCase& c) {
  const GLuint program =
      makeProgram(gl,
                  "attribute vec3 vertexMC; attribute vec4 scalarColor; uniform mat4 mvp;\n"
                  "void main() { gl_FrontColor = scalarColor; gl_BackColor = vec4(0.5);\n"
                  "  gl_Position = mvp * vec4(vertexMC, 1.0); }\n",
                  "void main() { gl_FragColor = vec4(gl_Color.rgb, 1.0); }\n");
  const ProgramMesh mesh = ball(12);
  upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  const View view = perspectiveView(35);
  setMat4(gl, program, "mvp", glm::mat4(view.clipFromEye * view.eyeFromObject));
  gl.Enable(GL_CULL_FACE), gl.CullFace(GL_FRONT);
  c.before(gl);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  c.after(gl);
}

class ProgramFrontColor : public testing::TestWithParam<FrontColorCase> {};

TEST_P(ProgramFrontColor, IsTracedUnlessFixedFunctionChangesIt) {
  const std::string family =
      "[[family]]\nname = \"front\"\nmatch.active = \"vertexMC\"\nvertex.position = \"vertexMC\"\n"
      "vertex.color = \"scalarColor\"\ntransform.clip_from_object = \"mvp\"\ncolor.clamped = true\n"
      "lights.model = \"unlit\"\n";
  const FrontColorCase& c = GetParam();
  expectBoth(
      std::string("front_color_") + c.name, [&](Gl gl) { drawThroughFrontColor(gl, c); }, c.traced,
      compatibleWish(), kProgramTolerance, family);
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramFrontColor, testing::ValuesIn(kFrontColorCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
