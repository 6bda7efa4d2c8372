// Programs as objects: linked again, deleted, named anew, shared between contexts, wrong; and programs of
// families that a test writes itself, with uniforms in blocks, lights in arrays, light in the world's space.
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Lights = Surface::Lights;

View placed(double x) {
  View view = perspectiveView(20);
  view.eyeFromObject = glm::scale(glm::translate(view.eyeFromObject, {x, 0, 0}), glm::dvec3(0.6));
  return view;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// A ball by each of two programs, with something done in between.
void drawTwo(Gl gl, const std::function<GLuint(GLuint first)>& between) {
  const Surface surface{.lightCount = 2};
  const ProgramMesh mesh = ball(16);
  const GLuint first = makeProgram(gl, surface);
  const Upload up = upload(gl, mesh, first);
  beginFrame(gl);
  drawSurface(gl, first, up, mesh, placed(-0.8), surface);
  const GLuint second = between(first);
  gl.UseProgram(second);
  setAll(gl, second, placed(0.8), surface);
  gl.BindVertexArray(upload(gl, mesh, second).array);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

TEST(ProgramObjects, LinkedAgainAsAnotherSurface) {
  expectBoth(
      "relinked",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint program) {
          const Surface other{.color = Color::vertex, .lights = Lights::none};
          GLuint shaders[2] = {};
          GLsizei count = 0;
          gl.GetAttachedShaders(program, 2, &count, shaders);
          for (GLsizei i = 0; i < count; ++i) gl.DetachShader(program, shaders[i]);
          const GLuint donor = makeProgram(gl, other);
          gl.GetAttachedShaders(donor, 2, &count, shaders);
          for (GLsizei i = 0; i < count; ++i) gl.AttachShader(program, shaders[i]);
          gl.LinkProgram(program);
          return program;
        });
      },
      2);
}

TEST(ProgramObjects, LinkedAgainInVain) {
  expectBoth(
      "unlinked",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint program) {
          GLuint shaders[2] = {};
          GLsizei count = 0;
          gl.GetAttachedShaders(program, 2, &count, shaders);
          const char* wrong = "#version 150\nvoid main() { nothing }\n";
          gl.ShaderSource(shaders[0], 1, &wrong, nullptr), gl.CompileShader(shaders[0]);
          gl.LinkProgram(program);  // fails: what is in use stays, and can still be drawn with
          const ProgramMesh mesh = ball(8);
          gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
          return makeProgram(gl, Surface{.lightCount = 2});
        });
      },
      -1);
}

TEST(ProgramObjects, NeverLinked) {
  expectBoth(
      "never_linked",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint) {
          gl.UseProgram(gl.CreateProgram());  // refused: the first one stays in use
          gl.DrawArrays(GL_TRIANGLES, 0, 3);
          return makeProgram(gl, Surface{.lightCount = 2});
        });
      },
      3);
}

TEST(ProgramObjects, DeletedWhileInUseAndItsNameUsedAgain) {
  expectBoth(
      "deleted",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint program) {
          gl.DeleteProgram(program);  // it lives on as long as it is in use, whatever is drawn meanwhile
          const ProgramMesh mesh = ball(8);
          for (const double x : {-0.2, 0.2}) {
            setView(gl, program, placed(x));
            gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
            gl.Finish();
          }
          gl.UseProgram(0);
          return makeProgram(gl, Surface{.color = Color::vertex, .lights = Lights::headlight});
        });
      },
      2);
}

TEST(ProgramObjects, LinkedAgainWithOtherPlacesOfUniforms) {
  expectBoth(
      "replaced",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint program) {
          gl.BindAttribLocation(program, 7, "vertexMC");
          gl.LinkProgram(program);
          return program;
        });
      },
      2);
}

TEST(ProgramObjects, NoProgramInACoreProfile) {
  expectBoth(
      "none",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint program) {
          gl.UseProgram(0);
          gl.DrawArrays(GL_TRIANGLES, 0, 3);  // undefined, but not the end
          return program;
        });
      },
      -1);
}

TEST(ProgramObjects, TwoContextsOfAShareGroup) {
  // Each context has its uniforms' program, linked again in the other one.
  const auto frame = [](Gl gl, GLuint program, const Surface& surface, const ProgramMesh& mesh) {
    const Upload up = upload(gl, mesh, program);
    beginFrame(gl);
    drawSurface(gl, program, up, mesh, perspectiveView(), surface);
    return readPicture(gl, kProgramWidth, kProgramHeight);
  };
  const Surface first{.lightCount = 2};
  const ProgramMesh mesh = ball(24);
  const auto all = [&](Gl one, Gl two, auto&& useOne, auto&& useTwo) {
    std::vector<Picture> pictures;
    useOne();
    const GLuint program = makeProgram(one, first);
    pictures.push_back(frame(one, program, first, mesh));
    useTwo();
    pictures.push_back(frame(two, program, first, mesh));
    two.BindAttribLocation(program, 5, "vertexMC"), two.LinkProgram(program);
    pictures.push_back(frame(two, program, first, mesh));
    useOne();
    pictures.push_back(frame(one, program, first, mesh));
    return pictures;
  };
  std::vector<Picture> expected;
  {
    const auto one = OsmesaContext::create(coreWish()), two = OsmesaContext::create(coreWish(), one.get());
    expected = all(
        one->real(), two->real(), [&] { one->makeCurrent(); }, [&] { two->makeCurrent(); });
  }
  TracedContext one(coreWish(), TracedContext::tracing()),
      two(coreWish(), TracedContext::tracing(), nullptr, &one);
  const std::vector<Picture> got = all(
      one.gl(), two.gl(), [&] { one.makeCurrent(); }, [&] { two.makeCurrent(); });
  for (size_t i = 0; i < expected.size(); ++i) {
    const Comparison c = compare(expected[i], got[i], kProgramTolerance);
    EXPECT_TRUE(c.accepted) << i << ": " << c.text;
  }
  EXPECT_EQ(one.context().counts.statistics.drawsTraced, 2u);
  EXPECT_EQ(two.context().counts.statistics.drawsTraced, 2u);
}

/// VTK's names with types that mean something else: not what the family describes.
struct WrongType {
  const char *name, *what, *by, *use, *instead;
};
const WrongType kWrongTypes[] = {
    {"matrix_of_3x3", "uniform mat4 MCDCMatrix", "uniform mat3 MCDCMatrix", "MCDCMatrix * vertexMC",
     "vec4(MCDCMatrix * vertexMC.xyz, 4.0)"},
    {"matrix_as_array", "uniform mat4 MCDCMatrix", "uniform vec4 MCDCMatrix[4]", "MCDCMatrix * vertexMC",
     "MCDCMatrix[0] * vertexMC.x + MCDCMatrix[1] * vertexMC.y + MCDCMatrix[2] * vertexMC.z + MCDCMatrix[3]"},
    {"positions_of_integers", "in vec4 vertexMC", "in ivec4 vertexMC", "Matrix * vertexMC",
     "Matrix * vec4(intBitsToFloat(vertexMC.x), intBitsToFloat(vertexMC.y), intBitsToFloat(vertexMC.z), "
     "1.0)"},
};
class WrongTypes : public testing::TestWithParam<WrongType> {};

TEST_P(WrongTypes, AreLeftToTheRealOne) {
  const WrongType& w = GetParam();
  expectSame(
      w.name,
      [&](Gl gl) {
        const Surface surface{.version = "#version 330\n"};
        const ProgramMesh mesh = ball(16);
        const GLuint program =
            makeProgram(gl, replaced(replaced(vertexText(surface), w.what, w.by), w.use, w.instead),
                        fragmentText(surface));
        const Upload up = upload(gl, mesh, program);
        if (std::string(w.by).find("ivec4") != std::string::npos) {
          gl.BindBuffer(GL_ARRAY_BUFFER, up.positions);
          gl.VertexAttribIPointer(static_cast<GLuint>(gl.GetAttribLocation(program, "vertexMC")), 3, GL_INT,
                                  0, nullptr);
        }
        beginFrame(gl);
        gl.UseProgram(program);
        const View view = perspectiveView();
        setAll(gl, program, view, surface);
        const glm::mat4 clip(view.clipFromEye * view.eyeFromObject);
        const GLint place = gl.GetUniformLocation(program, "MCDCMatrix");
        gl.Uniform4fv(place, 4, glm::value_ptr(clip));
        setMat3(gl, program, "MCDCMatrix", glm::mat3(1));
        while (gl.GetError() != GL_NO_ERROR) {}  // one of the two is of the wrong type
        setMat4(gl, program, "MCDCMatrix", clip);
        while (gl.GetError() != GL_NO_ERROR) {}
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
      },
      0, coreWish(3, 3));
}
INSTANTIATE_TEST_SUITE_P(All, WrongTypes, testing::ValuesIn(kWrongTypes),
                         [](const auto& info) { return std::string(info.param.name); });

// --- Families of our own
// ---------------------------------------------------------------------------------------------

const char* const kOwnVertex =
    "#version 150\nin vec3 position;\nin vec3 normal;\nout vec3 place;\nout vec3 n;\n"
    "layout(std140) uniform Camera { mat4 projection; mat4 view; vec3 eye; };\nuniform mat4 model;\n"
    "void main() { place = (model * vec4(position, 1)).xyz; n = mat3(model) * normal;\n"
    "  gl_Position = projection * view * vec4(place, 1); }\n";
const char* const kOwnFragment =
    "#version 150\nin vec3 place;\nin vec3 n;\nout vec4 color;\n"
    "layout(std140) uniform Camera { mat4 projection; mat4 view; vec3 eye; };\n"
    "struct Light { vec3 where; vec3 color; };\nuniform Light lights[4];\nuniform int lightCount;\n"
    "layout(std140) uniform Material { vec3 base; float shininess; } material;\n"
    "void main() { vec3 sum = 0.1 * material.base;\n"
    "  for (int i = 0; i < lightCount; ++i) {\n"
    "    vec3 l = normalize(lights[i].where - place), h = normalize(l + normalize(eye - place));\n"
    "    float d = max(dot(normalize(n), l), 0.0);\n"
    "    sum += lights[i].color * (d * material.base);\n"
    "    if (d > 0.0) sum += 0.5 * lights[i].color * pow(max(dot(normalize(n), h), 0.0), "
    "material.shininess); }\n"
    "  color = vec4(sum, 1); }\n";
const char* const kOwnFamily = R"([[family]]
name = "own"
match.active = ["position", "projection", "model"]
vertex.position = "position"
vertex.normal = "normal"
transform.clip_from_object = ["projection", "view", "model"]
transform.eye_from_object = "model"
transform.viewer = "eye"
transform.normal_matrix = "model"
lights.specular = "half"
lights.count = "lightCount"
lights.color = "lights[{}].color"
lights.position = "lights[{}].where"
material.ambient_intensity = 0.1
material.ambient_color = "Material.base"
material.diffuse_color = "Material.base"
material.specular_intensity = 0.5
material.shininess = "Material.shininess"
)";

struct Block {
  GLuint buffer = 0;
  void set(Gl gl, const std::vector<GLfloat>& values) const {
    gl.BindBuffer(GL_UNIFORM_BUFFER, buffer);
    gl.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(4 * values.size()), values.data(),
                  GL_DYNAMIC_DRAW);
  }
};

void setCamera(Gl gl, const Block& block, double degrees) {
  const View view = perspectiveView(degrees);
  const glm::mat4 p(view.clipFromEye), v(view.eyeFromObject);
  const glm::vec4 eye = glm::inverse(v)[3];
  std::vector<GLfloat> values(glm::value_ptr(p), glm::value_ptr(p) + 16);
  values.insert(values.end(), glm::value_ptr(v), glm::value_ptr(v) + 16);
  values.insert(values.end(), glm::value_ptr(eye), glm::value_ptr(eye) + 4);
  block.set(gl, values);
}

void drawOwn(Gl gl) {
  const GLuint program = makeProgram(gl, kOwnVertex, kOwnFragment);
  ProgramMesh mesh = ball(20);
  const Upload up = [&] {
    Upload u = upload(gl, mesh, program);  // VTK's names are not there: positions and normals by hand
    const auto add = [&](const char* name, const std::vector<glm::vec3>& values) {
      GLuint made = 0;
      const auto place = static_cast<GLuint>(gl.GetAttribLocation(program, name));
      gl.GenBuffers(1, &made), gl.BindBuffer(GL_ARRAY_BUFFER, made);
      gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(12 * values.size()), values.data(),
                    GL_STATIC_DRAW);
      gl.EnableVertexAttribArray(place), gl.VertexAttribPointer(place, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    };
    add("position", mesh.positions), add("normal", mesh.normals);
    return u;
  }();
  Block camera, material;
  gl.GenBuffers(1, &camera.buffer), gl.GenBuffers(1, &material.buffer);
  gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Camera"), 2);
  gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Material"), 5);
  beginFrame(gl);
  gl.UseProgram(program), gl.BindVertexArray(up.array);
  setCamera(gl, camera, 30);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 2, camera.buffer);
  setInteger(gl, program, "lightCount", 2);
  setVec3(gl, program, "lights[0].where", {3, 2, 3}),
      setVec3(gl, program, "lights[0].color", {0.8f, 0.7f, 0.6f});
  setVec3(gl, program, "lights[1].where", {-3, 1, 2}),
      setVec3(gl, program, "lights[1].color", {0.1f, 0.2f, 0.5f});
  setVec3(gl, program, "lights[2].color", {1, 0, 0});
  for (int i = 0; i < 3; ++i) {
    const auto f = static_cast<float>(i);
    material.set(gl, {0.9f - 0.4f * f, 0.3f, 0.1f + 0.4f * f, 5 + 20 * f});
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 5, material.buffer);
    const glm::mat4 model =
        glm::scale(glm::translate(glm::mat4(1), glm::vec3(1.1f * f - 1.1f, 0, 0.3f * f)), glm::vec3(0.5f));
    setMat4(gl, program, "model", model);
    gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  }
}

TEST(ProgramFamilies, UniformsInBlocksLightsInArraysAndTheWorldsSpace) {
  expectBoth("own", drawOwn, 3, {}, kProgramTolerance, kOwnFamily);
}

TEST(ProgramFamilies, ProgramsOfNoFamilyAreLeftToTheRealOne) { expectBoth("unknown", drawOwn, 0); }

}  // namespace
}  // namespace gluray::test
