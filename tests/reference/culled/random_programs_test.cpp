// Random shader programs, meshes and states: images of culled draws are those of whole ones to the bit.
#include "tests/reference/culled/swarm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  bool oneIn(int n) { return below(n) == 0; }
  float number(float low, float high) {
    return low + (high - low) * static_cast<float>(random_()) / 4294967296.0f;
  }
  template <size_t N>
  std::string of(const std::array<const char*, N>& words) {
    return words[static_cast<size_t>(below(int(N)))];
  }
  std::mt19937& engine() { return random_; }

 private:
  std::mt19937 random_;
};

struct RandomProgram {
  std::string vertex, fragment;
  bool linear = true;      // gl_Position is a matrix times `position`
  bool instanced = false;  // by attributes of instances: `where` and `other`
};

/// A statement on `vec4 p` that places instances; the first two are polynomials.
std::string placesOfInstances(Dice& dice, bool& linear) {
  const std::array ways{
      "  p.xyz = 0.5 * p.xyz + where.xyz;\n",
      "  p.xyz *= where.w, p.xyz += 0.7 * where.xyz;\n",
      "  p.xyz = 0.6 * p.xyz + 0.5 * normalize(where.xyz + 0.01);\n",
      "  p.xyz = 0.5 * p.xyz + 0.5 * sin(3.0 * where.zxy);\n",
      "  p.xyz = 0.5 * p.xyz + 0.04 * float(gl_InstanceID) * where.xyz;\n",
  };
  const int way = dice.below(int(ways.size()));
  linear = linear && way < 2;
  return ways[static_cast<size_t>(way)];
}

/// gl_Position by statements on `vec4 p`, all linear or all but one: then positions come by feedback.
std::string positions(Dice& dice, bool instanced, bool& linear) {
  std::string s = dice.of(std::array{
      "  vec4 p = vec4(position, 1.0);\n", "  vec4 p = vec4(position.xyz * scale, 1.0);\n",
      "  vec4 p = vec4(position.x, position.yz, 1.0);\n", "  vec4 p;\n  p.xyz = position;\n  p.w = 1.0;\n",
      "  vec4 p = vec4(position, 0.5) * 2.0 - vec4(position, 0);\n"});
  const std::array steps{
      "  p = moved(p);\n",
      "  p.xyz += shift;\n",
      "  for (int i = 0; i < rounds; ++i) p = turns[i] * p;\n",
      "  if (scale > 0.5) p.x = -p.x; else p.y *= 2.0;\n",
      "  p = p * transpose(turns[1]);\n",
      "  p.xyz = mat3(turns[0]) * p.xyz;\n",
      "  p = p.zxyw, p = p.yzxw;\n",
      "  { vec4 q = p; q *= 0.5; p = q + q; }\n",
      "  p = mix(p, p + vec4(shift, 0.0), scale);\n",
      "  switch (rounds) { case 2: break; default: break; }\n",
      "  p = vec4(dot(p, vec4(1, 0, 0, 0)), p.y, p.z, p.w);\n",
  };
  for (int n = dice.below(4); n > 0; --n) s += dice.of(steps);
  linear = !dice.oneIn(3);
  if (!linear)
    s += dice.of(std::array{"  p.y += 0.1 * sin(4.0 * position.x);\n", "  p.xyz += 0.05 * normal;\n",
                            "  if (position.x > 0.2) p.z += 0.3;\n",
                            "  p.x += 0.01 * float(gl_VertexID % 3);\n"});
  if (instanced) s += placesOfInstances(dice, linear);
  return s + dice.of(std::array{
                 "  gl_Position = clipFromEye * (eyeFromObject * p);\n",
                 "  gl_Position = clipFromEye * eyeFromObject * p;\n",
                 "  mat4 all = clipFromEye * eyeFromObject;\n  gl_Position = all * p;\n",
                 "  vec4 e = eyeFromObject * p;\n  gl_Position = clipFromEye * vec4(e.xyz, 1.0);\n"});
}

RandomProgram randomProgram(Dice& dice) {
  RandomProgram made;
  const std::string how = dice.of(std::array{"", "centroid ", "noperspective "});
  const bool flat = dice.oneIn(2), block = dice.oneIn(2);
  made.instanced = dice.oneIn(2);
  made.vertex =
      std::string("#version 150\nin vec3 position, normal;\nuniform mat4 clipFromEye, eyeFromObject;\n") +
      "uniform mat4 turns[2];\nuniform vec3 shift;\nuniform float scale;\nuniform int rounds;\n" +
      (block ? "out Surface { " + how + "vec3 place; vec3 n; } s;\n" : how + "out vec3 place, n;\n") +
      (flat ? "flat out int number;\n" : "") + (made.instanced ? "in vec4 where, other;\n" : "") +
      "vec4 moved(in vec4 v) { v.xyz = 0.9 * v.xyz - 0.1 * v.zyx; return v; }\nvoid main() {\n";
  made.vertex += positions(dice, made.instanced, made.linear);
  const std::string in = block ? "s." : "";
  made.vertex += "  " + in + "place = position" + (made.instanced ? " + 0.3 * other.xyz" : "") + ";\n  " +
                 in + "n = mat3(eyeFromObject) * normal;\n";
  if (flat) made.vertex += "  number = gl_VertexID;\n";
  made.vertex += "}\n";

  made.fragment =
      std::string("#version 150\n") +
      (block ? "in Surface { " + how + "vec3 place; vec3 n; } s;\n" : how + "in vec3 place, n;\n") +
      (flat ? "flat in int number;\n" : "") + "out vec4 color;\nuniform float scale;\n" +
      "float noise(vec3 p) { return fract(sin(dot(p, vec3(12.9, 78.2, 37.7))) * 437.5); }\n" +
      "void main() {\n  vec3 c = vec3(0.2) + 0.8 * abs(normalize(" + in + "n));\n";
  const std::array parts{
      "  c *= noise(floor(9.0 * PLACE));\n",
      "  if (fract(5.0 * PLACE.x + 3.0 * PLACE.y) < 0.4) discard;\n",
      "  c += 2.0 * fwidth(PLACE);\n",
      "  c.r += abs(dFdx(PLACE.z)) * 9.0 + abs(dFdy(PLACE.z));\n",
      "  if (!gl_FrontFacing) c = c.bgr * 0.5;\n",
      "  if ((int(gl_FragCoord.x) + int(gl_FragCoord.y)) % 3 == 0) discard;\n",
      "  c.g = fract(100.0 * gl_FragCoord.z);\n",
      "  if (noise(PLACE) > 0.8) discard;\n",
      "  for (int i = 0; i < 3; ++i) c = c.gbr * (0.9 + 0.1 * float(i));\n",
  };
  for (int n = 1 + dice.below(3); n > 0; --n) made.fragment += dice.of(parts);
  if (flat) made.fragment += "  c.b = float(number % 17) / 16.0;\n";
  made.fragment += "  color = vec4(c, " +
                   dice.of(std::array{"1.0", "1.0", "0.4", "scale > 100.0 ? 0.5 : 1.0",
                                      "clamp(PLACE.x + 0.7, 0.0, 1.0)"}) +
                   ");\n}\n";
  for (size_t at; (at = made.fragment.find("PLACE")) != std::string::npos;)
    made.fragment.replace(at, 5, in + "place");
  return made;
}

ProgramMesh randomMesh(Dice& dice) {
  ProgramMesh mesh = shells(2 + dice.below(4), 30 + dice.below(50));
  std::vector<std::array<GLuint, 3>> triangles(mesh.triangles());
  for (size_t t = 0; t < triangles.size(); ++t)
    triangles[t] = {mesh.indices[3 * t], mesh.indices[3 * t + 1], mesh.indices[3 * t + 2]};
  if (dice.oneIn(3)) std::ranges::shuffle(triangles, dice.engine());
  if (dice.oneIn(3))  // some twice: the order decides which one shows
    for (size_t t = 0, all = triangles.size(); t < all; t += 1 + static_cast<size_t>(dice.below(5)))
      triangles.push_back({triangles[t][1], triangles[t][2], triangles[t][0]});
  if (dice.oneIn(4)) mesh.positions[static_cast<size_t>(dice.below(200))].y = NAN;
  if (dice.oneIn(4)) mesh.positions[static_cast<size_t>(dice.below(200))] *= 1e6f;
  mesh.indices.clear();
  for (const auto& t : triangles) mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
  return mesh;
}

/// How many instances of a mesh are drawn: few of all of it, or many of a part.
struct RandomCopies {
  std::vector<glm::vec4> places;
  std::array<GLuint, 2> divisors{1, 1};
  GLsizei instances = 0, vertices = 0;
  GLuint base = 0;

  RandomCopies(Dice& dice, const ProgramMesh& mesh) {
    for (int i = 0; i < 80; ++i)
      places.emplace_back(dice.number(-1, 1), dice.number(-1, 1), dice.number(-1, 1), dice.number(0.2f, 1));
    for (GLuint& divisor : divisors) divisor = dice.oneIn(2) ? 1 : 1 + static_cast<GLuint>(dice.below(5));
    const bool many = dice.oneIn(2);
    instances = many ? 20 + dice.below(40) : 2 + dice.below(8);
    vertices = many ? mesh.count() / 60 * 3 : mesh.count();
    base = dice.oneIn(2) ? 0 : static_cast<GLuint>(dice.below(9));
  }
  /// Into the bound vertex array object.
  void send(Gl gl, GLuint program) const {
    sendOfInstances(gl, program, "where", 1, 4, places, divisors[0]);
    sendOfInstances(gl, program, "other", 1, 4, places, divisors[1]);
  }
  void draw(Gl gl, GLenum mode) const {
    gl.DrawElementsInstancedBaseInstance(mode, vertices, GL_UNSIGNED_INT, nullptr, instances, base);
  }
};

struct RandomState {
  GLenum function, cull;
  bool blend, scissor, offset, flipped;
  glm::vec2 range, offsets;

  explicit RandomState(Dice& dice) {
    const std::array functions{GL_LESS, GL_LESS, GL_LEQUAL, GL_GREATER, GL_GEQUAL};
    function = static_cast<GLenum>(functions[static_cast<size_t>(dice.below(5))]);
    const std::array culls{GL_NONE, GL_NONE, GL_BACK, GL_FRONT};
    cull = static_cast<GLenum>(culls[static_cast<size_t>(dice.below(4))]);
    blend = dice.oneIn(3), scissor = dice.oneIn(4), offset = dice.oneIn(4);
    flipped = dice.oneIn(5);
    range = dice.oneIn(4) ? glm::vec2(dice.number(0, 1), dice.number(0, 1)) : glm::vec2(0, 1);
    offsets = {dice.number(-1, 2), dice.number(-2, 4)};
  }
  void set(Gl gl) const {
    gl.DepthFunc(function), gl.DepthRange(range.x, range.y);
    if (function == GL_GREATER || function == GL_GEQUAL) gl.ClearDepth(0), gl.Clear(GL_DEPTH_BUFFER_BIT);
    const auto turn = [&](GLenum what, bool on) { on ? gl.Enable(what) : gl.Disable(what); };
    turn(GL_CULL_FACE, cull != GL_NONE), turn(GL_BLEND, blend), turn(GL_SCISSOR_TEST, scissor);
    turn(GL_POLYGON_OFFSET_FILL, offset);
    if (cull != GL_NONE) gl.CullFace(cull);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.PolygonOffset(offsets.x, offsets.y);
    gl.FrontFace(flipped ? GL_CW : GL_CCW);
    gl.Scissor(20, 35, 120, 140);
  }
  static void reset(Gl gl) {
    for (const GLenum what :
         {GL_CULL_FACE, GL_BLEND, GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL, GL_PRIMITIVE_RESTART})
      gl.Disable(what);
    gl.DepthRange(0, 1);
  }
};

void setUniforms(Gl gl, GLuint program, const std::array<glm::mat4, 2>& turns, float scale) {
  gl.UniformMatrix4fv(gl.GetUniformLocation(program, "turns"), 2, GL_FALSE, &turns[0][0][0]);
  setVec3(gl, program, "shift", {0.05f, -0.1f, 0.07f});
  setFloat(gl, program, "scale", scale), setInteger(gl, program, "rounds", 2);
}

/// The counts of the culled draws of the programs, meshes and states that this seed gives.
gl::Statistics compareRandom(unsigned seed, bool& linear) {
  Dice dice(seed);
  const std::array<RandomProgram, 2> texts{randomProgram(dice), randomProgram(dice)};
  const std::array<ProgramMesh, 2> meshes{randomMesh(dice), randomMesh(dice)};
  const std::array<RandomCopies, 2> copies{RandomCopies(dice, meshes[0]), RandomCopies(dice, meshes[1])};
  const RandomState state(dice);
  const int draws = 1 + dice.below(2);
  linear = texts[0].linear || (draws == 2 && texts[1].linear);
  const std::array<glm::mat4, 2> turns{glm::rotate(glm::mat4(1), dice.number(0, 3), glm::vec3(0, 0.6f, 0.8f)),
                                       glm::scale(glm::mat4(1), glm::vec3(1, dice.number(0.7f, 1.3f), 1))};
  const float scale = dice.number(0.3f, 1.2f);
  const int samples = dice.oneIn(3) ? 2 << dice.below(2) : 1;
  const bool within = dice.oneIn(4);  // the viewport is
  const std::array<GLint, 4> viewport{dice.below(60), dice.below(60), 70 + dice.below(60),
                                      70 + dice.below(60)};
  const GLenum mode = dice.oneIn(4) ? GL_TRIANGLE_STRIP : GL_TRIANGLES;
  const bool restart = dice.oneIn(4), first = dice.oneIn(4);
  std::array<GLuint, 2> programs{};
  std::array<Buffers, 2> buffers;
  SCOPED_TRACE(texts[0].vertex + texts[0].fragment + texts[1].vertex + texts[1].fragment);
  SCOPED_TRACE(std::to_string(samples) + " samples");
  return compareSamples(
      "random" + std::to_string(seed), 4, samples, GL_DEPTH24_STENCIL8,
      [&](Gl gl) {
        for (size_t i = 0; i < 2; ++i) {
          programs[i] = makeProgram(gl, texts[i].vertex, texts[i].fragment);
          buffers[i] = send(gl, meshes[i], programs[i]);
          if (texts[i].instanced) copies[i].send(gl, programs[i]);
        }
      },
      [&](Gl gl, int frame) {
        RandomState::reset(gl);
        clear(gl);
        if (within) gl.Viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
        for (int i = 0; i < draws; ++i) {
          const auto at = static_cast<size_t>(i);
          if (i == 0) state.set(gl);
          gl.UseProgram(programs[at]);
          gl.BindVertexArray(buffers[at].array);
          turn(gl, programs[at], frame + 3 * i);
          setUniforms(gl, programs[at], turns, scale);
          if (restart) gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(11);
          gl.ProvokingVertex(first ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
          if (texts[at].instanced)
            copies[at].draw(gl, mode);
          else
            gl.DrawElements(mode, meshes[at].count(), GL_UNSIGNED_INT, nullptr);
        }
        RandomState::reset(gl);
      },
      nullptr, {kSide, kSide, true, 3, 3});
}

TEST(RandomPrograms, AreTheSameCulled) {
  uint64_t culled = 0;
  int culledPrograms = 0, linearPrograms = 0, others = 0;
  // GLURAY_SEEDS: more of them.
  const char* const wish = std::getenv("GLURAY_SEEDS");
  const unsigned seeds = wish ? static_cast<unsigned>(std::strtoul(wish, nullptr, 10)) : 25;
  for (unsigned seed = 1; seed <= seeds && !HasFailure(); ++seed) {
    bool linear = false;
    const gl::Statistics counts = compareRandom(seed, linear);
    culled += counts.drawsCulled, culledPrograms += counts.drawsCulled > 0, linearPrograms += linear;
    others += !linear && counts.drawsCulled > 0;
  }
  EXPECT_GT(culledPrograms, linearPrograms / 3);
  EXPECT_GT(culled, 40u);
  EXPECT_GT(others, 1);
}

}  // namespace
}  // namespace gluray::test
