// The functions of NullGl. Part of null_gl.cpp.

const GLubyte* APIENTRY getString(GLenum name) {
  const char* text = name == GL_VERSION ? "3.3 null" : name == GL_EXTENSIONS ? "" : "null";
  return reinterpret_cast<const GLubyte*>(text);
}

void APIENTRY getPointerv(GLenum name, void** out) {
  *out = nullptr;
  for (const auto& a : kArrays)
    if (name == a.pointer) *out = const_cast<void*>(array(a.array).pointer);
}

void APIENTRY getVertexAttribiv(GLuint index, GLenum name, GLint* out) {
  const NullArray& a = now().attributes[index & 15];
  switch (name) {
    case GL_VERTEX_ATTRIB_ARRAY_ENABLED: *out = a.enabled; break;
    case GL_VERTEX_ATTRIB_ARRAY_SIZE: *out = a.size; break;
    case GL_VERTEX_ATTRIB_ARRAY_TYPE: *out = static_cast<GLint>(a.type); break;
    case GL_VERTEX_ATTRIB_ARRAY_STRIDE: *out = a.stride; break;
    case GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING: *out = static_cast<GLint>(a.buffer); break;
    case GL_VERTEX_ATTRIB_ARRAY_NORMALIZED: *out = a.normalized; break;
    case GL_VERTEX_ATTRIB_ARRAY_DIVISOR: *out = a.divisor; break;
    default: *out = 0;
  }
}

void APIENTRY bufferData(GLenum target, GLsizeiptr size, const void* data, GLenum) {
  auto* bytes = buffer(target);
  if (!bytes || size < 0 || size > 1 << 24) return;
  bytes->assign(static_cast<size_t>(size), std::byte{});
  if (data) std::memcpy(bytes->data(), data, static_cast<size_t>(size));
}

/// Whether the range lies in the buffer.
bool inside(const std::vector<std::byte>* bytes, GLintptr offset, GLsizeiptr size) {
  return bytes && offset >= 0 && size >= 0 && static_cast<size_t>(offset) <= bytes->size() &&
         static_cast<size_t>(size) <= bytes->size() - static_cast<size_t>(offset);
}

void APIENTRY bufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
  auto* bytes = buffer(target);
  if (inside(bytes, offset, size) && size > 0)
    std::memcpy(bytes->data() + offset, data, static_cast<size_t>(size));
}

void APIENTRY getBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
  auto* bytes = buffer(target);
  if (inside(bytes, offset, size) && size > 0)
    std::memcpy(data, bytes->data() + offset, static_cast<size_t>(size));
}

void APIENTRY getBufferParameteriv(GLenum target, GLenum name, GLint* out) {
  auto* bytes = buffer(target);
  *out = bytes && name == GL_BUFFER_SIZE ? static_cast<GLint>(bytes->size()) : 0;
}

void* APIENTRY mapBufferRange(GLenum target, GLintptr offset, GLsizeiptr size, GLbitfield) {
  auto* bytes = buffer(target);
  return inside(bytes, offset, size) ? bytes->data() + offset : nullptr;
}

void APIENTRY getTexLevelParameteriv(GLenum target, GLint level, GLenum name, GLint* out) {
  const auto& levels = texture(target).levels;
  const auto it = levels.find({target, level});
  const bool known = it != levels.end();
  switch (name) {
    case GL_TEXTURE_WIDTH: *out = known ? it->second.width : 0; break;
    case GL_TEXTURE_HEIGHT: *out = known ? it->second.height : 0; break;
    case GL_TEXTURE_DEPTH: *out = known ? it->second.depth : 0; break;
    case GL_TEXTURE_INTERNAL_FORMAT: *out = known ? it->second.format : 0; break;
    case GL_TEXTURE_BUFFER_DATA_STORE_BINDING:
      *out = known ? static_cast<GLint>(it->second.buffer) : 0;
      break;
    case GL_TEXTURE_RED_SIZE:
    case GL_TEXTURE_GREEN_SIZE:
    case GL_TEXTURE_BLUE_SIZE:
    case GL_TEXTURE_ALPHA_SIZE: *out = 8; break;
    default: *out = 0;
  }
}

void APIENTRY vertexAttribPointer(GLuint i, GLint size, GLenum type, GLboolean normalized, GLsizei stride,
                                  const void* at) {
  if (stride < 0 || size < 1 || size > 4) return;
  NullArray& a = now().attributes[i & 15];
  a = {size, stride, normalized, a.enabled, a.divisor, type, now().bound[GL_ARRAY_BUFFER], at};
}

void APIENTRY bindVertexArray(GLuint name) {
  NullGl::State& s = now();
  s.vertexArrays[s.vertexArray] = {std::move(s.arrays), s.attributes, s.bound[GL_ELEMENT_ARRAY_BUFFER]};
  NullGl::State::VertexArray& next = s.vertexArrays[s.vertexArray = name];
  s.arrays = std::move(next.arrays), s.attributes = next.attributes;
  s.bound[GL_ELEMENT_ARRAY_BUFFER] = next.elements;
}

void APIENTRY deleteVertexArrays(GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) {
    if (names[i] == 0) continue;
    if (names[i] == now().vertexArray) bindVertexArray(0);
    now().vertexArrays.erase(names[i]);
  }
}

/// Writes one byte for each texel, all equal.
void APIENTRY getTexImage(GLenum target, GLint level, GLenum format, GLenum type, void* out) {
  const auto& levels = texture(target).levels;
  const auto it = levels.find({target, level});
  if (it == levels.end()) return;
  const size_t components = format == GL_RGBA ? 4 : 1, each = type == GL_FLOAT ? 4 : 1;
  const auto of = [](GLint n) { return static_cast<size_t>(n); };
  const size_t texels = of(it->second.width) * of(it->second.height) * of(it->second.depth);
  std::memset(out, level % 2 ? 0x3f : 0xff, texels * components * each);
}

double usualTexParameter(GLenum name) {
  switch (name) {
    case GL_TEXTURE_MIN_FILTER: return GL_NEAREST_MIPMAP_LINEAR;
    case GL_TEXTURE_MAG_FILTER: return GL_LINEAR;
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
    case GL_TEXTURE_WRAP_R: return GL_REPEAT;
    case GL_TEXTURE_MIN_LOD: return -1000;
    case GL_TEXTURE_SWIZZLE_R: return GL_RED;
    case GL_TEXTURE_SWIZZLE_G: return GL_GREEN;
    case GL_TEXTURE_SWIZZLE_B: return GL_BLUE;
    case GL_TEXTURE_SWIZZLE_A: return GL_ALPHA;
    case GL_DEPTH_TEXTURE_MODE: return GL_LUMINANCE;
    case GL_TEXTURE_MAX_LOD:
    case GL_TEXTURE_MAX_LEVEL: return 1000;
    default: return 0;
  }
}

template <class T>
void APIENTRY getTexParameter(GLenum target, GLenum name, T* out) {
  const auto& parameters = texture(target).parameters;
  const auto it = parameters.find(name);
  answer(it == parameters.end() ? Values(parametersOf(name), usualTexParameter(name)) : it->second, out);
}

template <class T>
void APIENTRY texParameterv(GLenum target, GLenum name, const T* values) {
  texture(target).parameters[name] = Values(values, values + parametersOf(name));
}

void APIENTRY popMatrix() {
  auto& stack = now().matrices[enumOf(GL_MATRIX_MODE)];
  if (stack.size() > 1) stack.pop_back();
}

/// Texture targets are enabled for each unit separately.
GLenum switchOf(GLenum capability) {
  return perUnit(capability) ? capability + 65536 * (1 + enumOf(GL_ACTIVE_TEXTURE)) : capability;
}

GLboolean APIENTRY isEnabled(GLenum capability) {
  for (const auto& a : kArrays)
    if (capability == a.array) return static_cast<GLboolean>(array(capability).enabled);
  return now().enabled.count(switchOf(capability)) ? GL_TRUE : GL_FALSE;
}

void APIENTRY pushMatrix() {
  const glm::dmat4 top = matrix();
  auto& stack = now().matrices[enumOf(GL_MATRIX_MODE)];
  if (stack.size() < 32) stack.push_back(top);
}

void APIENTRY popAttrib() {
  if (now().saved.empty()) return;
  static_cast<Attributes&>(now()) = std::move(now().saved.back());
  now().saved.pop_back();
}

void APIENTRY deleteBuffers(GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) {
    now().objects->buffers.erase(names[i]);
    for (auto& [target, name] : now().bound)
      if (name == names[i]) name = 0;
    for (auto& [key, a] : now().arrays)
      if (a.buffer == names[i]) a = {};
    for (NullArray& a : now().attributes)
      if (a.buffer == names[i]) a = {};
  }
}

GLuint APIENTRY genLists(GLsizei n) {
  return std::exchange(now().objects->nextList,
                       now().objects->nextList + static_cast<GLuint>(std::max(n, 0)));
}

void APIENTRY getFramebufferAttachment(GLenum, GLenum, GLenum name, GLint* out) {
  *out = name == GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE ? GL_UNSIGNED_NORMALIZED
         : name == GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE     ? 8
                                                          : 0;
}

void APIENTRY blendFunc(GLenum source, GLenum target) {
  for (const GLenum name : {GL_BLEND_SRC_RGB, GL_BLEND_SRC_ALPHA}) put(name, {double(source)});
  for (const GLenum name : {GL_BLEND_DST_RGB, GL_BLEND_DST_ALPHA}) put(name, {double(target)});
}
