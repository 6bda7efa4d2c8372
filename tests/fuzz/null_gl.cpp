#include "tests/fuzz/null_gl_state.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstring>
#include <initializer_list>

namespace gluray::fuzz {

namespace {

NullGl::State* g_state = nullptr;

}  // namespace

NullGl::State& now() { return *g_state; }

namespace {

double first(GLenum name) {
  const auto it = now().values.find(name);
  return it == now().values.end() || it->second.empty() ? 0 : it->second[0];
}
GLenum enumOf(GLenum name) { return static_cast<GLenum>(first(name)); }
void put(GLenum name, std::initializer_list<double> values) { now().values[name] = values; }

glm::dmat4& matrix(GLenum mode) {
  auto& stack = now().matrices[mode];
  if (stack.empty()) stack.emplace_back(1.0);
  return stack.back();
}
glm::dmat4& matrix() { return matrix(enumOf(GL_MATRIX_MODE)); }

std::vector<std::byte>* buffer(GLenum target) {
  const auto it = now().bound.find(target);
  if (it == now().bound.end() || it->second == 0) return nullptr;
  return &now().objects->buffers[it->second];
}
NullGl::Objects::Texture& texture(GLenum target) {
  if (target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z)
    target = GL_TEXTURE_CUBE_MAP;
  return now().objects->textures[now().images[{enumOf(GL_ACTIVE_TEXTURE), target}]];
}
bool perUnit(GLenum capability) {
  return capability == GL_TEXTURE_1D || capability == GL_TEXTURE_2D || capability == GL_TEXTURE_3D ||
         capability == GL_TEXTURE_CUBE_MAP || capability == GL_TEXTURE_RECTANGLE;
}
NullArray& array(GLenum name) {
  return now().arrays[{name == GL_TEXTURE_COORD_ARRAY ? enumOf(GL_CLIENT_ACTIVE_TEXTURE) : 0, name}];
}

constexpr struct {
  GLenum array, size, type, stride, pointer, buffer;
} kArrays[] = {
    {GL_VERTEX_ARRAY, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE,
     GL_VERTEX_ARRAY_POINTER, GL_VERTEX_ARRAY_BUFFER_BINDING},
    {GL_NORMAL_ARRAY, 0, GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE, GL_NORMAL_ARRAY_POINTER,
     GL_NORMAL_ARRAY_BUFFER_BINDING},
    {GL_COLOR_ARRAY, GL_COLOR_ARRAY_SIZE, GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_STRIDE, GL_COLOR_ARRAY_POINTER,
     GL_COLOR_ARRAY_BUFFER_BINDING},
    {GL_SECONDARY_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY_SIZE, GL_SECONDARY_COLOR_ARRAY_TYPE,
     GL_SECONDARY_COLOR_ARRAY_STRIDE, GL_SECONDARY_COLOR_ARRAY_POINTER,
     GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING},
    {GL_FOG_COORD_ARRAY, 0, GL_FOG_COORD_ARRAY_TYPE, GL_FOG_COORD_ARRAY_STRIDE, GL_FOG_COORD_ARRAY_POINTER,
     GL_FOG_COORD_ARRAY_BUFFER_BINDING},
    {GL_TEXTURE_COORD_ARRAY, GL_TEXTURE_COORD_ARRAY_SIZE, GL_TEXTURE_COORD_ARRAY_TYPE,
     GL_TEXTURE_COORD_ARRAY_STRIDE, GL_TEXTURE_COORD_ARRAY_POINTER, GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING},
};

constexpr std::pair<GLenum, GLenum> kBufferBindings[] = {
    {GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING},
    {GL_ELEMENT_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER_BINDING},
    {GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING},
    {GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING},
    {GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING},
    {GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER_BINDING},
    {GL_TEXTURE_BUFFER, GL_TEXTURE_BUFFER_BINDING},
};

/// The result of glGet; a single 0 for unknown names.
Values ask(GLenum name) {
  const auto of = [](GLenum mode) {
    const glm::dmat4& m = matrix(mode);
    return Values(glm::value_ptr(m), glm::value_ptr(m) + 16);
  };
  if (name == GL_MODELVIEW_MATRIX) return of(GL_MODELVIEW);
  if (name == GL_PROJECTION_MATRIX) return of(GL_PROJECTION);
  if (name == GL_TEXTURE_MATRIX) return of(GL_TEXTURE);
  if (name == GL_CURRENT_PROGRAM) return {static_cast<double>(now().program)};
  if (name == GL_VERTEX_ARRAY_BINDING) return {static_cast<double>(now().vertexArray)};
  if (name == GL_TEXTURE_BINDING_2D)
    return {static_cast<double>(now().images[{enumOf(GL_ACTIVE_TEXTURE), GL_TEXTURE_2D}])};
  if (name == GL_TEXTURE_BINDING_BUFFER)
    return {static_cast<double>(now().images[{enumOf(GL_ACTIVE_TEXTURE), GL_TEXTURE_BUFFER}])};
  for (const auto& [target, binding] : kBufferBindings)
    if (name == binding) return {static_cast<double>(now().bound[target])};
  for (const auto& a : kArrays) {
    const NullArray& source = array(a.array);
    if (name == a.size && a.size) return {static_cast<double>(source.size)};
    if (name == a.type) return {static_cast<double>(source.type)};
    if (name == a.stride) return {static_cast<double>(source.stride)};
    if (name == a.buffer) return {static_cast<double>(source.buffer)};
  }
  const auto it = now().values.find(name);
  return it == now().values.end() || it->second.empty() ? Values{0} : it->second;
}

template <class T>
void answer(const Values& values, T* data) {
  for (size_t i = 0; i < values.size(); ++i) {
    if constexpr (std::is_integral_v<T>)
      data[i] = std::abs(values[i]) < 4e9 ? static_cast<T>(static_cast<int64_t>(values[i])) : T{0};
    else
      data[i] = static_cast<T>(values[i]);
  }
}
template <class T>
void APIENTRY get(GLenum name, T* data) {
  answer(ask(name), data);
}

size_t parametersOf(GLenum name) {
  switch (name) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
    case GL_AMBIENT_AND_DIFFUSE:
    case GL_POSITION:
    case GL_OBJECT_PLANE:
    case GL_EYE_PLANE:
    case GL_TEXTURE_ENV_COLOR:
    case GL_TEXTURE_BORDER_COLOR:
    case GL_LIGHT_MODEL_AMBIENT:
    case GL_FOG_COLOR: return 4;
    case GL_SPOT_DIRECTION:
    case GL_COLOR_INDEXES: return 3;
    default: return 1;
  }
}
using Table = std::map<std::pair<GLenum, GLenum>, Values>;
template <class T>
void set(Table& table, GLenum object, GLenum name, const T* values) {
  table[{object, name}] = Values(values, values + parametersOf(name));
}
template <class T>
void read(const Table& table, GLenum object, GLenum name, T* out) {
  const auto it = table.find({object, name});
  answer(it == table.end() ? Values(parametersOf(name), name == GL_SHININESS ? 0 : 0.5) : it->second, out);
}

void setMaterial(GLenum face, GLenum name, const GLfloat* values) {
  for (const GLenum side : {GL_FRONT, GL_BACK}) {
    if (face != side && face != GL_FRONT_AND_BACK) continue;
    if (name != GL_AMBIENT_AND_DIFFUSE) set(now().materials, side, name, values);
    if (name == GL_AMBIENT_AND_DIFFUSE)
      set(now().materials, side, GL_AMBIENT, values), set(now().materials, side, GL_DIFFUSE, values);
  }
}

template <GLenum Array>
void APIENTRY pointer(GLint size, GLenum type, GLsizei stride, const void* at) {
  NullArray& a = array(Array);
  if (size < 1 || size > 4 || stride < 0) return;
  a.size = size, a.type = type, a.stride = stride, a.pointer = at, a.buffer = now().bound[GL_ARRAY_BUFFER];
}
template <GLenum Array, GLint Size>
void APIENTRY pointerOf(GLenum type, GLsizei stride, const void* at) {
  pointer<Array>(Size, type, stride, at);
}

void image(GLenum target, GLint level, GLint format, GLsizei w, GLsizei h, GLsizei d) {
  if (level < 0 || level > 16 || w < 0 || h < 0 || d < 0 || w > 64 || h > 64 || d > 64) return;
  texture(target).levels[{target, level}] = {w, h, d, format, 0};
}

void generate(GLsizei n, GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) names[i] = now().objects->nextName++;
}

void setDefaults() {
  put(GL_VIEWPORT, {0, 0, 32, 32}), put(GL_SCISSOR_BOX, {0, 0, 32, 32}), put(GL_DEPTH_RANGE, {0, 1});
  put(GL_MATRIX_MODE, {GL_MODELVIEW}), put(GL_ACTIVE_TEXTURE, {GL_TEXTURE0}),
      put(GL_CLIENT_ACTIVE_TEXTURE, {GL_TEXTURE0});
  put(GL_DEPTH_FUNC, {GL_LESS}), put(GL_DEPTH_WRITEMASK, {1}), put(GL_COLOR_WRITEMASK, {1, 1, 1, 1});
  put(GL_DRAW_BUFFER, {GL_FRONT}), put(GL_READ_BUFFER, {GL_FRONT}), put(GL_RENDER_MODE, {GL_RENDER});
  put(GL_DEPTH_BITS, {24}), put(GL_STENCIL_BITS, {8}), put(GL_RGBA_MODE, {1});
  for (const GLenum bits : {GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS}) put(bits, {8});
  put(GL_MAX_LIGHTS, {8}), put(GL_MAX_CLIP_PLANES, {6}), put(GL_MAX_TEXTURE_COORDS, {8});
  put(GL_MAX_TEXTURE_UNITS, {8}), put(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, {16});
  put(GL_MAX_ATTRIB_STACK_DEPTH, {16}), put(GL_MAX_VERTEX_ATTRIBS, {16}), put(GL_MAX_TEXTURE_LOD_BIAS, {15});
  put(GL_SHADE_MODEL, {GL_SMOOTH}), put(GL_CULL_FACE_MODE, {GL_BACK}), put(GL_FRONT_FACE, {GL_CCW});
  put(GL_POLYGON_MODE, {GL_FILL, GL_FILL}), put(GL_ALPHA_TEST_FUNC, {GL_ALWAYS});
  put(GL_BLEND_SRC_RGB, {GL_ONE}), put(GL_BLEND_SRC_ALPHA, {GL_ONE});
  put(GL_BLEND_EQUATION_RGB, {GL_FUNC_ADD}), put(GL_BLEND_EQUATION_ALPHA, {GL_FUNC_ADD});
  put(GL_CURRENT_COLOR, {1, 1, 1, 1}), put(GL_CURRENT_NORMAL, {0, 0, 1}), put(GL_EDGE_FLAG, {1});
  put(GL_CURRENT_SECONDARY_COLOR, {0, 0, 0, 1}), put(GL_CURRENT_TEXTURE_COORDS, {0, 0, 0, 1});
  put(GL_COLOR_MATERIAL_FACE, {GL_FRONT_AND_BACK}),
      put(GL_COLOR_MATERIAL_PARAMETER, {GL_AMBIENT_AND_DIFFUSE});
  put(GL_LIGHT_MODEL_AMBIENT, {0.2, 0.2, 0.2, 1}), put(GL_LIGHT_MODEL_COLOR_CONTROL, {GL_SINGLE_COLOR});
  put(GL_FOG_MODE, {GL_EXP}), put(GL_FOG_COLOR, {0, 0, 0, 0}), put(GL_FOG_COORD_SRC, {GL_FRAGMENT_DEPTH});
  put(GL_FOG_DENSITY, {1}), put(GL_FOG_END, {1}), put(GL_PROVOKING_VERTEX, {GL_LAST_VERTEX_CONVENTION});
  put(GL_DOUBLEBUFFER, {0}), put(GL_LOGIC_OP_MODE, {GL_COPY});
  now().enabled.insert(GL_MULTISAMPLE);
}

#include "tests/fuzz/null_gl_functions.inl.h"
// What follows names them.
#include "tests/fuzz/null_gl_names.inl.h"

}  // namespace

NullGl::NullGl(const NullGl* share)
    : state_(std::make_unique<State>()), objects_(share ? share->objects_ : std::make_shared<Objects>()) {
  state_->objects = objects_.get();
  makeCurrent();
  setDefaults();
}

NullGl::~NullGl() {
  if (g_state == state_.get()) g_state = nullptr;
}

void NullGl::makeCurrent() { g_state = state_.get(); }

const gl::RealGl& NullGl::table() {
  static const gl::RealGl loaded = [] {
    gl::RealGl t;
    gl::loadRealGl(
        t,
        [](void*, const char* name) -> void* {
          static const NullFunctions functions = functionsByName();
          const auto it = functions.find(name);
          return it == functions.end() ? nullptr : it->second;
        },
        nullptr);
    return t;
  }();
  return loaded;
}

}  // namespace gluray::fuzz
