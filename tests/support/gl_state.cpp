#include "tests/support/gl_state.h"

#include "state_names.gen.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>
#include <string_view>
#include <tuple>

namespace gluray::test {
namespace {

/// What a query has not written, by type.
template <class T>
constexpr T kUntouched = static_cast<T>(-7.25e77);
template <>
constexpr GLint kUntouched<GLint> = -1234567891;

/// Memory for the answer to one query: untouched between queries.
template <class T>
class Answer {
 public:
  Answer() { values_.fill(kUntouched<T>); }
  T* data() { return values_.data(); }
  /// How many values were written: up to the last one that is not untouched.
  size_t count() const {
    size_t end = kMax;
    while (end > 0 && std::memcmp(&values_[end - kBlock], kBlank.data(), sizeof kBlank) == 0) end -= kBlock;
    while (end > 0 && std::memcmp(&values_[end - 1], kBlank.data(), sizeof(T)) == 0) --end;
    return end;
  }
  void clear(size_t count) { std::fill_n(values_.begin(), count, kUntouched<T>); }

 private:
  static constexpr size_t kMax = 512, kBlock = 64;
  static inline const std::array<T, kBlock> kBlank = [] {
    std::array<T, kBlock> blank;
    blank.fill(kUntouched<T>);
    return blank;
  }();
  std::array<T, kMax> values_;
};

class Query {
 public:
  explicit Query(const gl::RealGl& gl) : gl_(gl) {
    while (gl_.GetError() != GL_NO_ERROR) continue;
  }

  /// Runs `ask(buffer)`, which fills up to 512 values of type T; keeps what was written, as prefix + name,
  /// unless an error arose.
  template <class T, class Ask>
  void put(std::string_view prefix, std::string_view name, Ask ask) {
    Answer<T>& answer = std::get<Answer<T>>(answers_);
    ask(answer.data());
    const bool known = gl_.GetError() == GL_NO_ERROR;
    const size_t count = answer.count();
    if (known) state_[std::string(prefix).append(name)].assign(answer.data(), answer.data() + count);
    answer.clear(count);
  }
  GLint integer(GLenum name) {
    GLint value = 0;
    gl_.GetIntegerv(name, &value);
    gl_.GetError();
    return value;
  }
  GlState state_;
  const gl::RealGl& gl_;

 private:
  std::tuple<Answer<GLint>, Answer<GLfloat>, Answer<GLdouble>> answers_;
};

void general(Query& q) {
  for (const StateName& n : kGetNames)
    q.put<GLdouble>("", n.name, [&](GLdouble* v) { q.gl_.GetDoublev(n.value, v); });
  for (const StateName& n : kCapabilities)
    q.put<GLint>("enabled ", n.name, [&](GLint* v) { v[0] = q.gl_.IsEnabled(n.value); });
  for (const StateName& n : kPointerNames)
    q.put<GLdouble>("pointer ", n.name, [&](GLdouble* v) {
      void* pointer = nullptr;
      q.gl_.GetPointerv(n.value, &pointer);
      v[0] = static_cast<double>(reinterpret_cast<uintptr_t>(pointer));
    });
}

void indexed(Query& q) {
  for (GLuint i = 0; i < 16; ++i) {
    const std::string prefix = "index " + std::to_string(i) + " ", ints = prefix + "int ",
                      enabled = prefix + "enabled ";
    for (const StateName& n : kGetNames)
      q.put<GLdouble>(prefix, n.name, [&](GLdouble* v) { q.gl_.GetDoublei_v(n.value, i, v); });
    for (const StateName& n : kGetNames)
      q.put<GLint>(ints, n.name, [&](GLint* v) { q.gl_.GetIntegeri_v(n.value, i, v); });
    for (const StateName& n : kCapabilities)
      q.put<GLint>(enabled, n.name, [&](GLint* v) { v[0] = q.gl_.IsEnabledi(n.value, i); });
  }
}

void textureUnit(Query& q, int unit) {
  const auto& gl = q.gl_;
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  if (gl.GetError() != GL_NO_ERROR) return;
  const std::string prefix = "unit " + std::to_string(unit) + " ";
  for (const StateName& n : kGetNames) {
    const std::string_view name = n.name;
    if (name.find("TEXTURE") == name.npos && name.find("SAMPLER") == name.npos) continue;
    if (name.find("ACTIVE_TEXTURE") != name.npos) continue;
    q.put<GLdouble>(prefix, n.name, [&](GLdouble* v) { gl.GetDoublev(n.value, v); });
  }
  for (GLenum target :
       {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE}) {
    const std::string text = prefix + "target " + std::to_string(target) + " ";
    q.put<GLint>(text, "enabled", [&](GLint* v) { v[0] = gl.IsEnabled(target); });
    for (const StateName& n : kTextureParameters)
      q.put<GLfloat>(text, n.name, [&](GLfloat* v) { gl.GetTexParameterfv(target, n.value, v); });
    for (GLenum name : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_INTERNAL_FORMAT})
      q.put<GLint>(text, std::to_string(name),
                   [&](GLint* v) { gl.GetTexLevelParameteriv(target, 0, name, v); });
  }
  for (GLenum target : {GL_TEXTURE_ENV, GL_TEXTURE_FILTER_CONTROL, GL_POINT_SPRITE}) {
    const std::string text = prefix + "env " + std::to_string(target) + " ";
    for (GLenum name :
         {GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR, GL_COMBINE_RGB,  GL_COMBINE_ALPHA,    GL_SRC0_RGB,
          GL_SRC1_RGB,         GL_SRC2_RGB,          GL_SRC0_ALPHA,   GL_SRC1_ALPHA,       GL_SRC2_ALPHA,
          GL_OPERAND0_RGB,     GL_OPERAND1_RGB,      GL_OPERAND2_RGB, GL_OPERAND0_ALPHA,   GL_OPERAND1_ALPHA,
          GL_OPERAND2_ALPHA,   GL_RGB_SCALE,         GL_ALPHA_SCALE,  GL_TEXTURE_LOD_BIAS, GL_COORD_REPLACE})
      q.put<GLfloat>(text, std::to_string(name), [&](GLfloat* v) { gl.GetTexEnvfv(target, name, v); });
  }
  for (GLenum coordinate : {GL_S, GL_T, GL_R, GL_Q}) {
    const std::string text = prefix + "gen " + std::to_string(coordinate) + " ";
    for (const StateName& n : kTextureGenParameters)
      q.put<GLdouble>(text, n.name, [&](GLdouble* v) { gl.GetTexGendv(coordinate, n.value, v); });
  }
}

void fixedFunction(Query& q) {
  const auto& gl = q.gl_;
  for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 8; ++light)
    for (const StateName& n : kLightParameters)
      q.put<GLfloat>("light " + std::to_string(light - GL_LIGHT0) + " ", n.name,
                     [&](GLfloat* v) { gl.GetLightfv(light, n.value, v); });
  for (GLenum face : {GL_FRONT, GL_BACK})
    for (const StateName& n : kMaterialParameters)
      q.put<GLfloat>("material " + std::to_string(face) + " ", n.name,
                     [&](GLfloat* v) { gl.GetMaterialfv(face, n.value, v); });
  for (GLenum plane = GL_CLIP_PLANE0; plane < GL_CLIP_PLANE0 + 8; ++plane)
    q.put<GLdouble>("clip plane ", std::to_string(plane), [&](GLdouble* v) { gl.GetClipPlane(plane, v); });
  for (GLenum map = GL_PIXEL_MAP_I_TO_I; map <= GL_PIXEL_MAP_A_TO_A; ++map)
    q.put<GLfloat>("pixel map ", std::to_string(map), [&](GLfloat* v) { gl.GetPixelMapfv(map, v); });
  q.put<GLint>("", "polygon stipple", [&](GLint* v) { gl.GetPolygonStipple(reinterpret_cast<GLubyte*>(v)); });
}

void arraysAndBuffers(Query& q) {
  const auto& gl = q.gl_;
  for (GLuint i = 0; i < 16; ++i) {
    const std::string prefix = "attribute " + std::to_string(i) + " ";
    for (GLenum name :
         {GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE,
          GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL_VERTEX_ATTRIB_ARRAY_TYPE, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED,
          GL_VERTEX_ATTRIB_ARRAY_INTEGER, GL_VERTEX_ATTRIB_ARRAY_DIVISOR, GL_CURRENT_VERTEX_ATTRIB})
      q.put<GLdouble>(prefix, std::to_string(name), [&](GLdouble* v) { gl.GetVertexAttribdv(i, name, v); });
    q.put<GLdouble>(prefix, "pointer", [&](GLdouble* v) {
      void* pointer = nullptr;
      gl.GetVertexAttribPointerv(i, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
      v[0] = static_cast<double>(reinterpret_cast<uintptr_t>(pointer));
    });
  }
  for (GLenum target : {GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER})
    for (GLenum attachment : {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_DEPTH_ATTACHMENT,
                              GL_STENCIL_ATTACHMENT, GL_BACK_LEFT, GL_FRONT_LEFT, GL_DEPTH, GL_STENCIL})
      for (const StateName& n : kAttachmentParameters)
        q.put<GLint>(
            "attachment " + std::to_string(target) + " " + std::to_string(attachment) + " ", n.name,
            [&](GLint* v) { gl.GetFramebufferAttachmentParameteriv(target, attachment, n.value, v); });
}

}  // namespace

GlState queryState(const gl::RealGl& gl) {
  Query q(gl);
  general(q);
  indexed(q);
  fixedFunction(q);
  arraysAndBuffers(q);
  const GLint active = q.integer(GL_ACTIVE_TEXTURE), units = q.integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
  for (int unit = 0; unit < units; ++unit) textureUnit(q, unit);
  gl.ActiveTexture(static_cast<GLenum>(active));
  return std::move(q.state_);
}

std::vector<std::string> differences(const GlState& before, const GlState& after) {
  std::vector<std::string> lines;
  const auto text = [](const std::vector<double>* values) {
    std::ostringstream out;
    out.precision(17);
    if (!values) out << "nothing";
    for (size_t i = 0; values && i < values->size() && i < 16; ++i) out << (i ? " " : "") << (*values)[i];
    return out.str();
  };
  const auto same = [](const std::vector<double>& a,
                       const std::vector<double>& b) {  // to the bit: NaN equals itself
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
  };
  // Both are sorted by name.
  for (auto a = before.begin(), b = after.begin(); a != before.end() || b != after.end();) {
    const bool first = b == after.end() || (a != before.end() && a->first <= b->first);
    const bool second = a == before.end() || (b != after.end() && b->first <= a->first);
    if (!first || !second || !same(a->second, b->second))
      lines.push_back((first ? a->first : b->first) + ": " + text(first ? &a->second : nullptr) + " -> " +
                      text(second ? &b->second : nullptr));
    if (first) ++a;
    if (second) ++b;
  }
  return lines;
}

}  // namespace gluray::test
