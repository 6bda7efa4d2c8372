#include "tests/reference/programs/avogadro/avogadro_text.h"

#include <cmath>
#include <cstddef>

namespace gluray::test {
namespace {

const std::string kAtomVertex =
    "attribute vec4 vertex; attribute vec3 color; attribute vec2 texCoordinate;\n"
    "varying vec2 v_texCoord; varying vec3 fColor; varying vec4 eyePosition; varying float radius;\n"
    "uniform mat4 modelView; uniform mat4 projection;\n"
    "void main()\n{\n"
    "  radius = abs(texCoordinate.x);\n  fColor = color;\n  v_texCoord = texCoordinate / radius;\n"
    "  gl_Position = modelView * vertex;\n  eyePosition = gl_Position;\n"
    "  // Test if the closest point on the sphere would be clipped.\n"
    "  vec4 clipTestNear = eyePosition;\n  clipTestNear.z += radius;\n"
    "  clipTestNear = projection * clipTestNear;\n"
    "  if (clipTestNear.z > -clipTestNear.w) {\n"
    "    gl_Position.xy += texCoordinate;\n    gl_Position = projection * gl_Position;\n  }\n"
    "  else {\n    gl_Position.w = 0.0;\n  }\n}\n";

const std::string kLightVectors =
    "  vec3 L = normalize(vec3(0, 1, 1));\n  vec3 E = vec3(0, 0, 1);\n  vec3 H = normalize(L + E);\n";

const std::string kAtomFragment =
    "varying vec2 v_texCoord; varying vec4 eyePosition; varying vec3 fColor; varying float radius;\n"
    "uniform mat3 normal; uniform float opacity; uniform mat4 projection;\n"
    "void main()\n{\n"
    "  float zz = 1.0 - v_texCoord.x*v_texCoord.x - v_texCoord.y*v_texCoord.y;\n"
    "  if (zz <= 0.0)\n    discard;\n  vec3 N = vec3(v_texCoord, sqrt(zz));\n" +
    kLightVectors +
    "  float df = max(0.0, dot(N, L)); // cos_alpha\n  float sf = max(0.0, dot(N, H)); // cos_beta\n"
    "  vec3 ambient = 0.4 * fColor;\n  vec3 diffuse = 0.55 * fColor;\n"
    "  vec3 specular = 0.5 * (vec3(1, 1, 1) - fColor);\n"
    "  vec3 color = ambient + df * diffuse + pow(sf, 20.0) * specular;\n"
    "  gl_FragColor = vec4(color, opacity);\n"
    "  vec4 pos = eyePosition;\n  pos.z += N.z * radius;\n  pos = projection * pos;\n"
    "  gl_FragDepth = (pos.z / pos.w + 1.0) / 2.0;\n}\n";

std::string meshVertex(bool cylinders) {
  return std::string("attribute vec4 vertex; attribute vec3 normal;\nattribute ") +
         (cylinders ? "vec3" : "vec4") +
         " color;\nuniform mat4 modelView; uniform mat4 projection; uniform mat3 normalMatrix;\n"
         "varying vec3 fnormal;\nvoid main()\n{\n  gl_FrontColor = " +
         (cylinders ? "vec4(color, 1.0)" : "color") +
         ";\n  gl_Position = projection * modelView * vertex;\n"
         "  fnormal = normalize(normalMatrix * normal);\n}\n";
}

const std::string kMeshHead =
    "varying vec3 fnormal;\nvoid main()\n{\n  vec3 N = normalize(fnormal);\n" + kLightVectors;
const std::string kFromOutside = "  float df = max(0.0, dot(N, L));\n  float sf = max(0.0, dot(N, H));\n";
const std::string kFromWithin = "  float df = max(0.0, dot(N, -L));\n  float sf = max(0.0, dot(N, -H));\n";
const std::string kSum =
    "  gl_FragColor = ambient + df * diffuse + sf * specular;\n"
    "  gl_FragColor.a = gl_Color.a;\n}\n";

}  // namespace

std::string avogadroVertexText(AvogadroKind kind) {
  return kind == AvogadroKind::spheres ? kAtomVertex : meshVertex(kind == AvogadroKind::cylinders);
}

std::string avogadroFragmentText(AvogadroKind kind) {
  if (kind == AvogadroKind::spheres) return kAtomFragment;
  if (kind == AvogadroKind::cylinders)
    return kMeshHead + kFromOutside +
           "  vec4 ambient = 0.4 * gl_Color;\n  vec4 diffuse = 0.55 * gl_Color;\n"
           "  vec4 specular = 0.5 * (vec4(1, 1, 1, 1) - gl_Color);\n"
           "  gl_FragColor = ambient + df * diffuse + pow(sf, 20.0) * specular;\n  gl_FragColor.a = "
           "1.0;\n}\n";
  if (kind == AvogadroKind::meshes)
    return kMeshHead + kFromOutside +
           "  sf = pow(sf, 20.0);\n  vec4 ambient = gl_Color / 3.0;\n  vec4 diffuse = gl_Color;\n"
           "  vec4 specular = gl_Color * 3.0;\n" +
           kSum;
  return kMeshHead + kFromWithin +
         "  sf = pow(sf, 32.0);\n  vec4 ambient = gl_Color / 2.2;\n  vec4 diffuse = gl_Color * 1.1;\n"
         "  vec4 specular = gl_Color * 5.0;\n" +
         kSum;
}

std::vector<Atom> manyAtoms() {
  std::vector<Atom> atoms;
  for (int i = 0; i < 60; ++i) {
    const auto t = static_cast<float>(i);
    atoms.push_back({{std::sin(1.7f * t), std::sin(2.3f * t + 1), std::cos(0.9f * t)},
                     0.16f + 0.1f * std::sin(5 * t),
                     {30 + 37 * i % 220, 60 + 91 * i % 190, 20 + 53 * i % 230}});
  }
  return atoms;
}

AtomCorners::AtomCorners(const std::vector<Atom>& atoms) {
  for (const Atom& a : atoms) {
    const auto first = static_cast<GLuint>(vertices.size());
    for (const glm::vec2 side : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      vertices.push_back({a.center, glm::u8vec4(a.color, 255), a.radius * side, {}});
    for (const GLuint k : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + k);
  }
}

namespace {

void setAvogadroView(Gl gl, GLuint program, const View& view) {
  gl.UseProgram(program);
  setMat4(gl, program, "modelView", glm::mat4(view.eyeFromObject));
  setMat4(gl, program, "projection", glm::mat4(view.clipFromEye));
}

void pointTo(Gl gl, GLuint program, const char* name, GLint size, GLenum type, size_t stride, size_t offset) {
  const GLint at = gl.GetAttribLocation(program, name);
  if (at < 0) return;
  gl.EnableVertexAttribArray(static_cast<GLuint>(at));
  gl.VertexAttribPointer(static_cast<GLuint>(at), size, type, type == GL_UNSIGNED_BYTE,
                         static_cast<GLsizei>(stride), reinterpret_cast<const void*>(offset));
}

}  // namespace

void drawAtoms(Gl gl, GLuint program, const AtomCorners& atoms, const View& view, float opacity) {
  setAvogadroView(gl, program, view);
  setFloat(gl, program, "opacity", opacity);
  makeBuffer(gl, GL_ARRAY_BUFFER, atoms.vertices);
  constexpr size_t kStride = sizeof(AtomCorner);
  pointTo(gl, program, "vertex", 3, GL_FLOAT, kStride, offsetof(AtomCorner, center));
  pointTo(gl, program, "color", 3, GL_UNSIGNED_BYTE, kStride, offsetof(AtomCorner, color));
  pointTo(gl, program, "texCoordinate", 2, GL_FLOAT, kStride, offsetof(AtomCorner, corner));
  makeBuffer(gl, GL_ELEMENT_ARRAY_BUFFER, atoms.indices);
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(atoms.indices.size()), GL_UNSIGNED_INT, nullptr);
}

void drawAvogadroMesh(Gl gl, GLuint program, const ProgramMesh& mesh, const View& view) {
  setAvogadroView(gl, program, view);
  setMat3(gl, program, "normalMatrix",
          glm::mat3(glm::transpose(glm::inverse(glm::dmat3(view.eyeFromObject)))));
  makeBuffer(gl, GL_ARRAY_BUFFER, mesh.positions), pointTo(gl, program, "vertex", 3, GL_FLOAT, 0, 0);
  makeBuffer(gl, GL_ARRAY_BUFFER, mesh.normals), pointTo(gl, program, "normal", 3, GL_FLOAT, 0, 0);
  makeBuffer(gl, GL_ARRAY_BUFFER, mesh.colors), pointTo(gl, program, "color", 4, GL_UNSIGNED_BYTE, 0, 0);
  makeBuffer(gl, GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

}  // namespace gluray::test
