#include "tests/reference/programs/sent/sent_impostors.h"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>

namespace gluray::test {
namespace {

const std::string kSentHead =
    "#version 150\nin vec4 place; in vec3 paint; in float corner;\n"
    "uniform mat4 modelview, projection; uniform mat3 turn; uniform float scale;\n"
    "float side(float bit) { return 2.0 * mod(floor(corner / bit), 2.0) - 1.0; }\n";

const std::string kSquareVertex =
    "out vec3 center, at, tint; out float r;\n"
    "void main() { center = (modelview * vec4(place.xyz, 1)).xyz; tint = paint;\n"
    "  r = place.w * scale / length(turn[0]); vec2 wider = vec2(1);\n";
const std::string kWidened =
    "  vec2 away = vec2(length(center.xz), length(center.yz));\n"
    "  wider = min(abs(1.0 / cos(acos(clamp(center.z / away, -1.0, 1.0)) - atan(r / away))), 10.0);\n";
const std::string kSquareEnd =
    "  at = center + vec3(r * wider * vec2(side(1.0), side(2.0)), 0);\n"
    "  gl_Position = projection * vec4(at, 1); }\n";

const std::string kBoxVertex =
    "in vec3 tip, tipPaint; in float caps;\n"
    "out vec3 at, foot, head, way, tint, tipTint; out float r, kinds;\n"
    "void main() { vec3 w = normalize(tip - place.xyz);\n"
    "  vec3 u = normalize(cross(w, abs(w.x) < 0.9 ? vec3(1, 0, 0) : vec3(0, 1, 0))), v = cross(u, w);\n"
    "  float wide = place.w * (scale != 0.0 ? scale : 1.0);\n"
    "  vec3 p = (side(2.0) > 0.0 ? tip : place.xyz) + wide * (side(4.0) * u + side(1.0) * v + side(2.0) * "
    "w);\n"
    "  at = (modelview * vec4(p, 1)).xyz; foot = (modelview * vec4(place.xyz, 1)).xyz;\n"
    "  head = (modelview * vec4(tip, 1)).xyz; way = normalize(turn * w); r = wide / length(turn[0]);\n"
    "  tint = paint, tipTint = tipPaint, kinds = caps; gl_Position = projection * vec4(at, 1);\n"
    "  gl_Position.z = max(gl_Position.z, -gl_Position.w); }\n";

/// Light, depth, and the line of sight o + t d.
const std::string kSentFragmentHead =
    "#version 150\nin vec3 at, tint; in float r; uniform mat4 projection; uniform vec3 sun; uniform float "
    "opacity;\nout vec4 pixel;\n"
    "void show(vec3 p, vec3 n, vec3 base) { vec4 clip = projection * vec4(0, 0, p.z, 1);\n"
    "  float depth = 0.5 * clip.z / clip.w + 0.5; if (depth <= 0.0) discard; gl_FragDepth = depth;\n"
    "  pixel = vec4(base * (0.2 + 0.8 * max(dot(n, -sun), 0.0)), opacity); }\n";
const std::string kPerspectiveLine = "vec3 o = vec3(0), d = normalize(at);\n";
const std::string kParallelLine = "vec3 o = vec3(at.xy, 0), d = vec3(0, 0, -1);\n";

const std::string kSquareFragment =
    "  float b = dot(center - o, d); vec3 beside = o + b * d - center;\n"
    "  float q = r * r - dot(beside, beside); if (q < 0.0) discard;\n"
    "  vec3 p = o + (b - sqrt(q)) * d; show(p, (p - center) / r, tint); }\n";

const std::string kBoxFragment =
    "  vec3 m = o - foot; float h = distance(foot, head), dz = dot(d, way), mz = dot(m, way);\n"
    "  vec3 e = d - dz * way, f = m - mz * way; float a = dot(e, e), s = -dot(e, f) / a;\n"
    "  vec3 beside = f + s * e; float q = r * r - dot(beside, beside); if (q < 0.0) discard;\n"
    "  float t = s - sqrt(q / a), z = mz + t * dz, share = clamp(z / h, 0.0, 1.0), bits = floor(kinds + "
    "0.5);\n"
    "  if (mod(floor(bits / 16.0), 2.0) < 0.5) {\n"
    "    float around = clamp(-blend * (o + t * d).z, 0.0, 0.5);\n"
    "    share = smoothstep(0.5 - around, 0.5 + around, share); }\n"
    "  vec3 base = mix(tint, tipTint, share);\n"
    "  if (z >= 0.0 && z <= h) { show(o + t * d, (f + t * e) / r, base); return; }\n"
    "  float one = z < 0.0 ? 1.0 : 2.0; vec3 end = z < 0.0 ? foot : head, out_ = z < 0.0 ? -way : way;\n"
    "  if (mod(floor(bits / one), 2.0) < 0.5) discard;\n"
    "  if (roundCaps != 0 && mod(floor(bits / (4.0 * one)), 2.0) > 0.5) {\n"
    "    float c = dot(end - o, d); vec3 off = o + c * d - end; float k = r * r - dot(off, off);\n"
    "    if (k < 0.0) discard; vec3 p = o + (c - sqrt(k)) * d; show(p, (p - end) / r, base); return; }\n"
    "  if (dot(out_, d) > 0.0) discard;\n"
    "  vec3 p = o + dot(end - o, out_) / dot(d, out_) * d; if (distance(p, end) > r) discard;\n"
    "  show(p, out_, base); }\n";

std::string vertexTextOf(bool sticks, bool parallel) {
  if (sticks) return kSentHead + kBoxVertex;
  return kSentHead + kSquareVertex + (parallel ? "" : kWidened) + kSquareEnd;
}

std::string fragmentTextOf(bool sticks, bool parallel) {
  const std::string inputs = sticks
                                 ? "in vec3 foot, head, way, tipTint; in float kinds; uniform float blend;\n"
                                   "uniform int roundCaps;\n"
                                 : "in vec3 center;\n";
  return kSentFragmentHead + inputs + "void main() {" + (parallel ? kParallelLine : kPerspectiveLine) +
         (sticks ? kBoxFragment : kSquareFragment);
}

template <class Vector>
std::vector<float> flat(const std::vector<Vector>& values) {
  std::vector<float> out;
  for (const Vector& v : values)
    for (int c = 0; c < Vector::length(); ++c) out.push_back(v[c]);
  return out;
}

}  // namespace

void SentImpostors::addCorners() {
  const auto first = static_cast<GLushort>(corners.size());
  for (uint32_t k = 0; k < cornersEach(); ++k) corners.push_back(static_cast<float>(k));
  const auto square = [&](int zero, int a, int b) {
    for (const int k : {0, a, a | b, 0, a | b, b})
      numbers.push_back(static_cast<GLushort>(first + (zero | k)));
  };
  if (!sticks) return square(0, 1, 2);
  for (int side = 0; side < 3; ++side) {
    const int a = 1 << (side + 1) % 3, b = 1 << (side + 2) % 3;
    square(1 << side, a, b), square(0, b, a);
  }
}

void SentImpostors::addSphere(const glm::vec3& center, float radius, const glm::vec3& paint) {
  addCorners();
  places.insert(places.end(), cornersEach(), glm::vec4(center, radius));
  paints.insert(paints.end(), cornersEach(), paint);
}

void SentImpostors::addStick(const glm::vec3& from, const glm::vec3& to, float radius, int bits,
                             const glm::vec3& first, const glm::vec3& second) {
  sticks = true;
  addSphere(from, radius, first);
  tips.insert(tips.end(), cornersEach(), to), tipPaints.insert(tipPaints.end(), cornersEach(), second);
  caps.insert(caps.end(), cornersEach(), static_cast<float>(bits));
}

SentImpostors manySpheres() {
  SentImpostors s;
  for (int i = 0; i < kImpostors; ++i) {
    const auto t = static_cast<float>(i);
    s.addSphere({std::sin(1.7f * t), std::sin(2.3f * t + 1), std::cos(0.9f * t)},
                0.08f + 0.05f * std::sin(5 * t), {1, 0.5f + 0.5f * std::sin(t), 0.3f});
  }
  return s;
}

SentImpostors manySticks() {
  SentImpostors s;
  for (int i = 0; i < kImpostors; ++i) {
    const auto t = static_cast<float>(i);
    const glm::vec3 at(std::sin(1.7f * t), std::sin(2.3f * t + 1), std::cos(0.9f * t));
    s.addStick(at, at + 0.5f * glm::vec3(std::sin(t), std::cos(3 * t), std::sin(2 * t)),
               0.07f + 0.03f * std::sin(5 * t), i % 32, {1, 0.5f + 0.5f * std::sin(t), 0.3f},
               {0.2f, 0.4f, 1});
  }
  return s;
}

void prepareSent(Gl gl, const SentImpostors& sent, const SentView& look) {
  const GLuint program = linkImpostors(gl, vertexTextOf(sent.sticks, look.parallel), "",
                                       fragmentTextOf(sent.sticks, look.parallel));
  GLuint array = 0;
  gl.GenVertexArrays(1, &array), gl.BindVertexArray(array);
  addImpostorValues(gl, program, "place", 4, flat(sent.places));
  addImpostorValues(gl, program, "paint", 3, flat(sent.paints));
  addImpostorValues(gl, program, "corner", 1, sent.corners);
  if (sent.sticks) {
    addImpostorValues(gl, program, "tip", 3, flat(sent.tips));
    addImpostorValues(gl, program, "tipPaint", 3, flat(sent.tipPaints));
    addImpostorValues(gl, program, "caps", 1, sent.caps);
  }
  beginFrame(gl);
  gl.DepthFunc(GL_LESS);
  gl.UseProgram(program);
  lookAtImpostors(gl, program, look.view, look.parallel);
  setMat3(gl, program, "turn", glm::mat3(glm::transpose(glm::inverse(glm::dmat3(look.view.eyeFromObject)))));
  setFloat(gl, program, "scale", look.scale), setFloat(gl, program, "blend", look.blend);
  setInteger(gl, program, "roundCaps", look.roundCaps), setFloat(gl, program, "opacity", look.opacity);
}

void drawSent(Gl gl, const SentImpostors& sent) { drawNumbered(gl, GL_TRIANGLES, sent.numbers); }

std::string sentFamily(bool sticks, bool parallel) {
  const std::string common =
      "[[code]]\nname = \"sent\"\nstatements = '''\n" + vertexTextOf(sticks, parallel) +
      fragmentTextOf(sticks, parallel) +
      "'''\n[[family]]\nname = \"sent\"\nmatch.active = [\"place\", \"modelview\", \"corner\"]\n"
      "match.code = \"sent\"\nvertex.position = \"place\"\nvertex.color = \"paint\"\n"
      "transform.clip_from_object = [\"projection\", \"modelview\"]\n"
      "transform.eye_from_object = \"modelview\"\ntransform.normal_matrix = \"turn\"\n"
      "material.ambient_intensity = 0.2\nmaterial.ambient_color = 1\nmaterial.diffuse_intensity = 0.8\n"
      "lights.direction = \"sun\"\nimpostors.billboards = \"sent\"\nimpostors.corners = \"corner\"\n"
      "impostors.projection = \"projection\"\nimpostors.radius_in_position = true\n"
      "impostors.radius_in_object_space = true\nimpostors.scale = \"scale\"\nmaterial.opacity = "
      "\"opacity\"\n";
  const std::string own =
      sticks ? "impostors.shape = \"sticks\"\nimpostors.end = \"tip\"\nimpostors.end_color = \"tipPaint\"\n"
               "impostors.caps = \"caps\"\nimpostors.round_caps = \"roundCaps\"\n"
               "impostors.halves_blend = [\"blend\", 1]\nimpostors.zero_scale_is_one = true\n"
             : "impostors.shape = \"spheres\"\n";
  return common + own + (parallel ? "impostors.viewer = \"infinite\"\n" : "");
}

}  // namespace gluray::test
