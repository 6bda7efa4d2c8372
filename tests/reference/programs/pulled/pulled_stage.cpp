#include "tests/reference/programs/pulled/pulled_stage.h"

namespace gluray::test {
namespace {

enum PulledUnit : GLint {
  kPulledPositions,
  kPulledIds,
  kPulledCells,
  kPulledFlags,
  kPulledPointNormals,
  kPulledCellNormals,
  kPulledPointColors,
  kPulledCellColors,
  kPulledMapCoords,
  kPulledCoords,
  kPulledMap,
  kPulledImage
};

/// A buffer texture on `unit`. Returns its buffer.
template <class T>
GLuint pulledTexture(Gl gl, GLint unit, GLenum format, const std::vector<T>& values) {
  const GLuint filled = makeBuffer(gl, GL_TEXTURE_BUFFER, values);
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_BUFFER, name);
  gl.TexBuffer(GL_TEXTURE_BUFFER, format, filled);
  return filled;
}

/// The values after `before` others.
template <class T>
std::vector<T> valuesAfter(GLint before, const T& other, const std::vector<T>& values) {
  std::vector<T> all(static_cast<size_t>(before), other);
  all.insert(all.end(), values.begin(), values.end());
  return all;
}

uint32_t packedColor(const glm::vec3& color) {
  const glm::uvec3 bytes(glm::clamp(color, 0.0f, 1.0f) * 255.0f + 0.5f);
  return bytes.r | bytes.g << 8 | bytes.b << 16 | 0xff000000u;
}

}  // namespace

GLuint makeProgram(Gl gl, const PulledSurface& s) {
  return makeProgram(gl, pulledVertexText(s), pulledFragmentText(s));
}

PulledMesh::PulledMesh(Gl gl, const ProgramMesh& mesh, const PulledWay& way, bool scalars)
    : way_(way), count_(mesh.count()) {
  gl.GenVertexArrays(1, &array_);
  gl.BindVertexArray(array_);
  const GLenum vectors = scalars ? GL_R32F : GL_RGB32F;
  positions_ = pulledTexture(gl, kPulledPositions, vectors,
                             valuesAfter(way.pointsBefore, glm::vec3(9), mesh.positions));
  pulledTexture(gl, kPulledPointNormals, vectors,
                valuesAfter(way.pointsBefore, glm::vec3(1, 0, 0), mesh.normals));
  std::vector<GLint> ids(mesh.indices.begin(), mesh.indices.end());
  pulledTexture(gl, kPulledIds, GL_R32I, valuesAfter(way.verticesBefore, 0, ids));
  std::vector<GLint> cells;
  std::vector<glm::vec3> normals;
  std::vector<uint32_t> colors;
  std::vector<uint8_t> flags;
  for (size_t i = 0; i < mesh.triangles(); ++i) {
    const size_t cell = way.quads ? i / 2 : i;
    cells.push_back(static_cast<GLint>(cell));
    flags.push_back(static_cast<uint8_t>(i % 2 ? 3 : 5));
    if (normals.size() > cell) continue;
    const glm::vec3 *const p = mesh.positions.data(), a = p[mesh.indices[3 * i]],
                           b = p[mesh.indices[3 * i + 1]], c = p[mesh.indices[3 * i + 2]];
    const glm::vec3 n = glm::cross(b - a, c - a);
    normals.push_back(n == glm::vec3(0) ? glm::vec3(0, 0, 1) : 0.7f * glm::normalize(n));
    const float t = static_cast<float>(cell % 13) / 12.0f;
    colors.push_back(packedColor({t, 1 - t, 0.3f + 0.4f * t}));
  }
  cells_ = pulledTexture(gl, kPulledCells, GL_R32I, valuesAfter(way.trianglesBefore, 0, cells));
  pulledTexture(gl, kPulledCellNormals, vectors, valuesAfter(way.cellsBefore, glm::vec3(0, 1, 0), normals));
  pulledTexture(gl, kPulledFlags, GL_R8UI, valuesAfter(way.flagsBefore, uint8_t{7}, flags));
  pulledTexture(gl, kPulledPointColors, GL_RGBA8UI, valuesAfter(way.pointsBefore, 0xff0000ffu, mesh.colors));
  cellColors_ =
      pulledTexture(gl, kPulledCellColors, GL_RGBA8UI, valuesAfter(way.cellsBefore, 0xff0000ffu, colors));
  pulledTexture(gl, kPulledCoords, GL_RG32F, valuesAfter(way.pointsBefore, glm::vec2(0), mesh.texcoords));
  std::vector<glm::vec2> turned;
  for (const glm::vec2& at : mesh.texcoords) turned.emplace_back(at.y, 0.3f * at.x);
  pulledTexture(gl, kPulledMapCoords, GL_RG32F, valuesAfter(way.pointsBefore, glm::vec2(0), turned));
  colorMap(gl, kPulledMap), chequers(gl, kPulledImage);
  if (way.indexed) makeBuffer(gl, GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
}

void PulledMesh::move(Gl gl, size_t point, const glm::vec3& to) const {
  gl.BindBuffer(GL_TEXTURE_BUFFER, positions_);
  gl.BufferSubData(GL_TEXTURE_BUFFER,
                   static_cast<GLintptr>((point + static_cast<size_t>(way_.pointsBefore)) * sizeof to),
                   sizeof to, &to);
}

namespace {

template <class T>
void replaceInPulled(Gl gl, GLuint buffer, size_t first, const std::vector<T>& values) {
  gl.BindBuffer(GL_TEXTURE_BUFFER, buffer);
  gl.BufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(first * sizeof(T)),
                   static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data());
}

}  // namespace

void PulledMesh::recolor(Gl gl, size_t cell) const {
  replaceInPulled(gl, cellColors_, cell + static_cast<size_t>(way_.cellsBefore),
                  std::vector<uint32_t>(9, 0xff20c0f0u));
}

void PulledMesh::regroup(Gl gl, size_t cell) const {
  replaceInPulled(gl, cells_, cell + static_cast<size_t>(way_.trianglesBefore), std::vector<GLint>(9, 0));
}

void PulledMesh::set(Gl gl, GLuint program, const View& view, const PulledSurface& surface) const {
  gl.BindVertexArray(array_);
  gl.UseProgram(program);
  Surface lights;
  lights.lightCount = surface.lightCount;
  setAll(gl, program, view, lights);
  const auto integer = [&](const char* name, GLint value) { setInteger(gl, program, name, value); };
  const auto number = [&](const char* name, float value) { setFloat(gl, program, name, value); };
  integer("positions", kPulledPositions), integer("vertexIdBuffer", kPulledIds),
      integer("primitiveToCellBuffer", kPulledCells);
  integer("edgeValueBuffer", kPulledFlags), integer("pointNormals", kPulledPointNormals);
  integer("cellNormals", kPulledCellNormals), integer("colorTCoords", kPulledMapCoords),
      integer("tcoords", kPulledCoords);
  integer("colors", surface.color == PulledColor::cells ? kPulledCellColors : kPulledPointColors);
  integer("colortexture", kPulledMap), integer("actortexture", kPulledImage);
  integer("pointIdOffset", way_.pointsBefore), integer("vertexIdOffset", way_.verticesBefore);
  integer("cellIdOffset", way_.cellsBefore), integer("primitiveIdOffset", way_.trianglesBefore);
  integer("edgeValueBufferOffset", way_.flagsBefore), integer("useIndexedPointId", way_.indexed);
  integer("usesCellMap", way_.quads), integer("cellType", 5), integer("primitiveSize", 3);
  integer("wireframe", way_.wireframe);
  integer("edgeVisibility", way_.edges), integer("usesEdgeValues", way_.flagged);
  integer("enable_lights", way_.lit), integer("overridesColor", way_.overrides);
  number("intensity_opacity_override", way_.opacity);
  setVec3(gl, program, "color_ambient_override", {0.9f, 0.3f, 0.2f});
  setVec3(gl, program, "color_diffuse_override", {0.8f, 0.4f, 0.1f});
  number("edgeWidth", 1.5f), number("edgeOpacity", way_.edgeOpacity), number("pointSize", 1);
  number("lineWidth", 1);
  setVec3(gl, program, "edgeColor", {0.9f, 0.2f, 0.1f});
  gl.Uniform4f(gl.GetUniformLocation(program, "viewportDimensions"), 0, 0, kProgramWidth, kProgramHeight);
  for (const std::string side : {"", "_bf"}) {
    const auto named = [&](const char* name) { return name + side; };
    number(named("intensity_ambient").c_str(), 0.2f), number(named("intensity_diffuse").c_str(), 0.9f);
    number(named("intensity_specular").c_str(), 0.4f), number(named("power_specular").c_str(), 20);
    number(named("intensity_opacity").c_str(), way_.opacity);
    const bool front = side.empty();
    setVec3(gl, program, named("color_ambient").c_str(), {1, 0.8f, 0.6f});
    setVec3(gl, program, named("color_diffuse").c_str(),
            front ? glm::vec3(0.3f, 0.6f, 0.9f) : glm::vec3(0.9f, 0.4f, 0.1f));
    setVec3(gl, program, named("color_specular").c_str(), {1, 1, 0.9f});
  }
  const glm::vec4 planes[] = {{0.8f, 0.3f, 0.5f, 0.4f}, {-0.3f, 0.9f, 0, 0.6f}};
  gl.Uniform4fv(gl.GetUniformLocation(program, "clipPlanes"), 2, &planes[0].x);
  integer("numClipPlanes", 2), number("cOffset", 200), number("cFactor", 0);
}

void PulledMesh::draw(Gl gl) const {
  if (way_.indexed) return gl.DrawElementsInstanced(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr, 1);
  gl.DrawArraysInstanced(GL_TRIANGLES, way_.verticesBefore, count_, 1);
}

void PulledMesh::drawSolids(Gl gl, GLuint program, PulledKind kind, const View& view, float pixels) const {
  const bool lines = kind == PulledKind::lines;
  const GLsizei each = kind == PulledKind::vertices ? 1 : kind == PulledKind::corners ? 3 : 2;
  const GLint cellTypes[] = {1, 3, 5, 3};
  setInteger(gl, program, "cellType", cellTypes[static_cast<int>(kind)]);
  setInteger(gl, program, "primitiveSize", lines ? 3 : 1);
  setInteger(gl, program, "renderPointsAsSpheres", 1), setInteger(gl, program, "renderLinesAsTubes", 1);
  setFloat(gl, program, "pointSize", pixels), setFloat(gl, program, "lineWidth", pixels);
  const bool parallel = view.clipFromEye[3][3] == 1;
  const double zz = view.clipFromEye[2][2];
  setFloat(gl, program, "ZCalcR", static_cast<float>(pixels / (kProgramWidth * view.clipFromEye[0][0])));
  setFloat(gl, program, "ZCalcS", static_cast<float>(parallel ? zz : 0.5 - 0.5 * zz));
  gl.Enable(GL_PROGRAM_POINT_SIZE);
  const GLsizei triangles = count_ / 3, first = way_.verticesBefore;
  if (lines)
    gl.DrawArraysInstanced(GL_TRIANGLES, first, 6 * triangles, 1);
  else if (way_.indexed)
    gl.DrawElementsInstanced(GL_POINTS, each * triangles, GL_UNSIGNED_INT, nullptr, 1);
  else
    gl.DrawArraysInstanced(GL_POINTS, first, each * triangles, 1);
}

}  // namespace gluray::test
