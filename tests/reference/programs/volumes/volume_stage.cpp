#include "tests/reference/programs/volumes/volume_stage.h"

#include <algorithm>
#include <cmath>

namespace gluray::test {
namespace {

const std::string kVertexMain =
    "void main() { place = position; gl_Position = clipFromData * vec4(position, 1.0); }\n";
const std::string kDepthTest =
    "float last = texture(depths, gl_FragCoord.xy * texel).x; if (gl_FragCoord.z >= last) discard;\n"
    "vec4 end = boxFromClip * vec4(gl_FragCoord.xy * texel * 2.0 - 1.0, last * 2.0 - 1.0, 1.0);\n"
    "float steps = length(end.xyz / end.w - at) / length(along); float taken = 0.0;\n";

std::string fragmentMain(const CasterText& text) {
  return "void main() { vec3 along = (boxFromData * vec4(normalize(place - viewer), 0.0)).xyz * stride;\n"
         "vec3 at = (boxFromData * vec4(place, 1.0)).xyz + along; vec4 sum = vec4(0.0);\n" +
         (text.depths ? kDepthTest : "") +
         "while (true) { float v = texture(voxels, at).x * scale + bias;\n"
         "float a = texture(opacities, vec2(v, 0.5)).x;\n"
         "if (a > 0.0) sum += (1.0 - sum.a) * vec4(texture(colors, vec2(v, 0.5)).xyz * a, a);\n"
         "at += along;\n"
         "if (any(greaterThan(max(along, vec3(0.0)) * (at - upper), vec3(0.0))) ||\n"
         "any(greaterThan(min(along, vec3(0.0)) * (at - lower), vec3(0.0)))) break;\n"
         "if (sum.a > 1.0 - 1.0 / 255.0) break;\n" +
         (text.depths ? "if (taken >= steps) break; ++taken;\n" : "") + text.more +
         "}\nfragOutput0 = sum; }\n";
}

bool isSigned(GLenum format) { return format == GL_R8_SNORM || format == GL_R16_SNORM; }

/// A table of one row.
void makeTable(Gl gl, GLenum unit, GLenum internal, GLenum format, const std::vector<float>& values,
               GLsizei entries) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.ActiveTexture(GL_TEXTURE0 + unit), gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), entries, 1, 0, format, GL_FLOAT,
                values.data());
  for (const GLenum what : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, what, GL_LINEAR);
  for (const GLenum what : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl.TexParameteri(GL_TEXTURE_2D, what, GL_CLAMP_TO_EDGE);
}

}  // namespace

GLuint makeCaster(Gl gl, const CasterText& text) {
  return makeProgram(
      gl, "#version 150\nin vec3 position;\nout vec3 place;\nuniform mat4 clipFromData;\n" + kVertexMain,
      "#version 150\nin vec3 place;\nout vec4 fragOutput0;\nuniform sampler3D voxels;\n"
      "uniform sampler2D opacities, colors, depths;\nuniform mat4 boxFromData, boxFromClip;\n"
      "uniform vec3 viewer, lower, upper;\nuniform vec2 texel;\n"
      "uniform float stride, scale, bias;\n" +
          fragmentMain(text));
}

std::string casterFamily(bool depths) {
  return "[[code]]\nname = \"caster\"\nstatements = '''\n" + kVertexMain + fragmentMain({.depths = depths}) +
         "'''\n[[family]]\nname = \"caster\"\n"
         "match.active = [\"position\", \"voxels\", \"opacities\", \"colors\"]\nmatch.code = \"caster\"\n" +
         (depths ? "match.ignored = [\"boxFromClip\"]\n" : "") +
         "vertex.position = \"position\"\ntransform.clip_from_object = \"clipFromData\"\n"
         "volume.grid = \"voxels\"\nvolume.opacity = \"opacities\"\nvolume.color = \"colors\"\n"
         "volume.texture_from_data = \"boxFromData\"\nvolume.viewer = \"viewer\"\nvolume.step = \"stride\"\n"
         "volume.lower = \"lower\"\nvolume.upper = \"upper\"\nvolume.scale = \"scale\"\n"
         "volume.bias = \"bias\"\n" +
         (depths ? "volume.depth = \"depths\"\nvolume.depth_texel = \"texel\"\n" : "");
}

GLuint makeVoxels(Gl gl, const VoxelImage& image) {
  std::vector<float> values;
  for (int z = 0; z < image.size.z; ++z)
    for (int y = 0; y < image.size.y; ++y)
      for (int x = 0; x < image.size.x; ++x) {
        const glm::vec3 p = glm::vec3(x, y, z) / glm::vec3(glm::max(image.size - 1, 1));
        const float v = 0.5f + 0.5f * std::sin(7 * p.x + 1) * std::cos(5 * p.y) * std::sin(6 * p.z);
        values.push_back(isSigned(image.format) ? std::clamp(2.4f * v - 1.2f, -1.0f, 1.0f) : v);
      }
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.ActiveTexture(GL_TEXTURE0), gl.BindTexture(GL_TEXTURE_3D, name);
  gl.TexImage3D(GL_TEXTURE_3D, 0, static_cast<GLint>(image.format), image.size.x, image.size.y, image.size.z,
                0, GL_RED, GL_FLOAT, values.data());
  for (const GLenum what : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_3D, what, image.filter);
  for (const GLenum what : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(GL_TEXTURE_3D, what, image.wrap);
  return name;
}

void changeVoxels(Gl gl, const glm::ivec3& first, const glm::ivec3& size, float value) {
  const std::vector<float> values(static_cast<size_t>(size.x * size.y * size.z), value);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.TexSubImage3D(GL_TEXTURE_3D, 0, first.x, first.y, first.z, size.x, size.y, size.z, GL_RED, GL_FLOAT,
                   values.data());
}

CastBox::CastBox(Gl gl, GLuint program) : program_(program) {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(2.0f * glm::vec3(i & 1, i >> 1 & 1, i >> 2) - 1.0f);
  const std::vector<GLuint> triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                         2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  gl.GenVertexArrays(1, &array_), gl.BindVertexArray(array_);
  const auto at = static_cast<GLuint>(gl.GetAttribLocation(program, "position"));
  makeBuffer(gl, GL_ARRAY_BUFFER, corners);
  gl.EnableVertexAttribArray(at), gl.VertexAttribPointer(at, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  makeBuffer(gl, GL_ELEMENT_ARRAY_BUFFER, triangles);
  makeTable(gl, 1, GL_R32F, GL_RED, {0, 0, 0, 0.02f, 0.1f, 0.05f, 0.3f, 0.3f}, 8);
  makeTable(gl, 2, GL_RGB32F, GL_RGB, {0, 0, 1, 0.5f, 1, 0.3f, 1, 0.8f, 0.1f, 1, 0, 0.2f}, 4);
}

void CastBox::begin(Gl gl, const View& view, float scale, float bias) const {
  const glm::mat4 clipFromData(view.clipFromEye * view.eyeFromObject);
  glm::mat4 boxFromData(0.5f * 0.9f);
  boxFromData[3] = {0.5f, 0.5f, 0.5f, 1};
  gl.UseProgram(program_);
  setMat4(gl, program_, "clipFromData", clipFromData), setMat4(gl, program_, "boxFromData", boxFromData);
  setMat4(gl, program_, "boxFromClip", boxFromData * glm::inverse(clipFromData));
  setVec3(gl, program_, "viewer", glm::vec3(glm::inverse(view.eyeFromObject)[3]));
  setVec3(gl, program_, "lower", glm::vec3(0.05f)), setVec3(gl, program_, "upper", glm::vec3(0.95f));
  setFloat(gl, program_, "stride", 0.0937f), setFloat(gl, program_, "scale", scale);
  setFloat(gl, program_, "bias", bias);
  setInteger(gl, program_, "voxels", 0), setInteger(gl, program_, "opacities", 1);
  setInteger(gl, program_, "colors", 2), setInteger(gl, program_, "depths", 3);
  gl.Uniform2f(gl.GetUniformLocation(program_, "texel"), 1.0f / kProgramWidth, 1.0f / kProgramHeight);
  gl.DepthMask(GL_FALSE), gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable(GL_CULL_FACE), gl.CullFace(GL_BACK), gl.FrontFace(GL_CCW);
}

void CastBox::draw(Gl gl) const {
  gl.BindVertexArray(array_);
  gl.DrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_INT, nullptr);
}

}  // namespace gluray::test
