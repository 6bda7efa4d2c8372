#include "gl/arrays/arrays.h"

#include "gl/real/extensions.h"
#include "gl/real/state_queries.h"
#include "gl/sharing/share_group.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace gluray::gl {

size_t sizeOfType(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT: return 2;
    case GL_DOUBLE: return 8;
    default: return 4;
  }
}

namespace {

bool isPlainType(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT:
    case GL_DOUBLE: return true;
    default: return false;
  }
}

struct ArrayNames {
  GLenum enable, size, type, stride, pointer, buffer;
};
constexpr ArrayNames kVertexNames{GL_VERTEX_ARRAY,         GL_VERTEX_ARRAY_SIZE,
                                  GL_VERTEX_ARRAY_TYPE,    GL_VERTEX_ARRAY_STRIDE,
                                  GL_VERTEX_ARRAY_POINTER, GL_VERTEX_ARRAY_BUFFER_BINDING};
constexpr ArrayNames kNormalNames{GL_NORMAL_ARRAY,         0,
                                  GL_NORMAL_ARRAY_TYPE,    GL_NORMAL_ARRAY_STRIDE,
                                  GL_NORMAL_ARRAY_POINTER, GL_NORMAL_ARRAY_BUFFER_BINDING};
constexpr ArrayNames kColorNames{GL_COLOR_ARRAY,         GL_COLOR_ARRAY_SIZE,
                                 GL_COLOR_ARRAY_TYPE,    GL_COLOR_ARRAY_STRIDE,
                                 GL_COLOR_ARRAY_POINTER, GL_COLOR_ARRAY_BUFFER_BINDING};
constexpr ArrayNames kSecondaryColorNames{
    GL_SECONDARY_COLOR_ARRAY,         GL_SECONDARY_COLOR_ARRAY_SIZE,
    GL_SECONDARY_COLOR_ARRAY_TYPE,    GL_SECONDARY_COLOR_ARRAY_STRIDE,
    GL_SECONDARY_COLOR_ARRAY_POINTER, GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING};
constexpr ArrayNames kFogCoordNames{GL_FOG_COORD_ARRAY,         0,
                                    GL_FOG_COORD_ARRAY_TYPE,    GL_FOG_COORD_ARRAY_STRIDE,
                                    GL_FOG_COORD_ARRAY_POINTER, GL_FOG_COORD_ARRAY_BUFFER_BINDING};
constexpr ArrayNames kTexCoordNames{GL_TEXTURE_COORD_ARRAY,         GL_TEXTURE_COORD_ARRAY_SIZE,
                                    GL_TEXTURE_COORD_ARRAY_TYPE,    GL_TEXTURE_COORD_ARRAY_STRIDE,
                                    GL_TEXTURE_COORD_ARRAY_POINTER, GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING};

/// `size`: components of arrays that always have the same number.
ArraySource readArray(const RealGl& real, ShareGroup& group, const ArrayNames& names, bool normalized,
                      GLint size = 3) {
  ArraySource source;
  source.enabled = real.IsEnabled(names.enable) == GL_TRUE;
  if (!source.enabled) return source;
  source.size = names.size ? integer(real, names.size) : size;
  source.type = static_cast<GLenum>(integer(real, names.type));
  source.stride = integer(real, names.stride);
  if (source.stride == 0) source.stride = static_cast<GLsizei>(sizeOfType(source.type)) * source.size;
  void* pointer = nullptr;
  real.GetPointerv(names.pointer, &pointer);
  source.pointer = static_cast<const std::byte*>(pointer);
  if (isPresent(real.GenBuffers))
    source.buffer = bufferNamed(group, static_cast<GLuint>(integer(real, names.buffer)));
  source.normalized = normalized;
  return source;
}

/// Whether arrays are enabled that tracing ignores, but that matter to recorded and rasterised draws.
bool otherArraysOn(const RealGl& real) {
  return real.IsEnabled(GL_EDGE_FLAG_ARRAY) || real.IsEnabled(GL_INDEX_ARRAY);
}

/// Texture coordinate arrays of all units.
void readTexCoords(const RealGl& real, ShareGroup& group, ArrayState& state) {
  if (!isPresent(real.ClientActiveTexture)) {
    state.texcoord = readArray(real, group, kTexCoordNames, false);
    return;
  }
  const GLint active = integer(real, GL_CLIENT_ACTIVE_TEXTURE), units = integer(real, GL_MAX_TEXTURE_COORDS);
  for (GLint i = 0; i < units; ++i) {
    real.ClientActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + i));
    ArraySource source = readArray(real, group, kTexCoordNames, false);
    if (i == 0) {
      state.texcoord = std::move(source);
    } else if (source.enabled && i < 8) {
      state.texcoordsAbove.resize(static_cast<size_t>(i));
      state.texcoordsAbove.back() = std::move(source);
    } else if (source.enabled) {
      state.others = true;
    }
  }
  real.ClientActiveTexture(static_cast<GLenum>(active));
}

bool genericArrayOn(const RealGl& real, GLuint index) {
  if (!isPresent(real.GetVertexAttribiv)) return false;
  GLint on = 0;
  real.GetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &on);
  return on != 0;
}

}  // namespace

std::shared_ptr<Buffer> bufferNamed(ShareGroup& group, GLuint name) {
  if (name == 0) return nullptr;
  auto buffer = group.buffers.find(name);
  if (!buffer) group.buffers.put(name, buffer = std::make_shared<Buffer>(name, group.heldBackBuffers));
  return buffer;
}

bool isForeign(const ArraySource& source) {
  return source.enabled && source.buffer && (source.buffer->foreign || source.buffer->mappedBelow);
}

Reason foreignReason(const ArrayState& arrays) {
  bool any = false, persistent = false;
  const auto look = [&](const Buffer* buffer) {
    any = any || (buffer && (buffer->foreign || buffer->mappedBelow));
    persistent = persistent || (buffer && buffer->foreign && buffer->persistent);
  };
  const auto lookAt = [&](const ArraySource& source) {
    look(source.enabled ? source.buffer.get() : nullptr);
  };
  look(arrays.elements.get());
  arrays.forEach(lookAt);
  for (const ArraySource& source : arrays.generic) lookAt(source);
  return persistent ? Reason::persistentMapping : any ? Reason::foreignBuffer : Reason::traced;
}

bool isReadable(const ArraySource& source) {
  return !source.enabled || (isPlainType(source.type) && source.stride > 0 && source.size >= 1 &&
                             source.size <= 4 && !isForeign(source));
}

void readArrays(const RealGl& real, ShareGroup& group, ArrayState& state) {
  state = {};
  state.restart = readRestart(real);
  state.vertex = readArray(real, group, kVertexNames, false);
  state.normal = readArray(real, group, kNormalNames, true);
  state.color = readArray(real, group, kColorNames, true);
  if (isPresent(real.SecondaryColorPointer))
    state.secondaryColor = readArray(real, group, kSecondaryColorNames, true);
  if (isPresent(real.FogCoordPointer)) state.fogCoord = readArray(real, group, kFogCoordNames, false, 1);
  readTexCoords(real, group, state);
  if (isPresent(real.GenBuffers))
    state.elements = bufferNamed(group, static_cast<GLuint>(integer(real, GL_ELEMENT_ARRAY_BUFFER_BINDING)));
  state.others = state.others || otherArraysOn(real);
  for (GLuint i = 0; i < 16; ++i) state.others = state.others || genericArrayOn(real, i);
  bool readable = true;
  state.forEach([&](const ArraySource& source) { readable = readable && isReadable(source); });
  if (const Reason foreign = foreignReason(state); foreign != Reason::traced)
    state.reason = foreign;
  else if (!readable || genericArrayOn(real, 0))
    state.reason = Reason::arrayState;
}

ArrayReader::ArrayReader(const RealGl& real, const ArraySource& source, Fractions fractions)
    : source_(source) {
  if (fractions == Fractions::ofCommands) source_.symmetric = false;
  if (!source.enabled) return;
  if (!source.buffer) {
    data_ = source.pointer;
    available_ = data_ ? std::numeric_limits<uint32_t>::max() : 0;
    return;
  }
  storage_ = source.buffer->read(real);
  const auto offset = reinterpret_cast<size_t>(source.pointer);
  const size_t element = sizeOfType(source.type) * static_cast<size_t>(source.size);
  if (!storage_ || offset > storage_->size || storage_->size - offset < element) return;
  data_ = storage_->data + offset;
  const size_t count = (storage_->size - offset - element) / static_cast<size_t>(source.stride) + 1;
  available_ = static_cast<uint32_t>(std::min<size_t>(count, std::numeric_limits<uint32_t>::max()));
}

namespace {

/// Converts one component to a float. `normalized` integers are converted by GL 2.1, table 2.9, or if
/// `symmetric`, by GL 4.2, equation 2.2.
float component(const std::byte* p, GLenum type, bool normalized, bool symmetric) {
  const auto load = [&]<class T>(T) {
    T value;
    std::memcpy(&value, p, sizeof value);
    if constexpr (std::is_floating_point_v<T>) return static_cast<float>(value);
    if (!normalized) return static_cast<float>(value);
    constexpr double most = static_cast<double>(
        std::numeric_limits<std::make_unsigned_t<std::conditional_t<std::is_integral_v<T>, T, int>>>::max());
    if (std::is_signed_v<T> && symmetric)
      return static_cast<float>(
          std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0));
    if constexpr (std::is_signed_v<T>)
      return static_cast<float>((2.0 * static_cast<double>(value) + 1.0) / most);
    return static_cast<float>(static_cast<double>(value) / most);
  };
  switch (type) {
    case GL_BYTE: return load(int8_t{});
    case GL_UNSIGNED_BYTE: return load(uint8_t{});
    case GL_SHORT: return load(int16_t{});
    case GL_UNSIGNED_SHORT: return load(uint16_t{});
    case GL_INT: return load(int32_t{});
    case GL_UNSIGNED_INT: return load(uint32_t{});
    case GL_DOUBLE: return load(double{});
    default: return load(float{});
  }
}

}  // namespace

void ArrayReader::read(uint32_t i, float out[4]) const {
  out[0] = out[1] = out[2] = 0, out[3] = 1;
  const std::byte* p = data_ + static_cast<size_t>(i) * static_cast<size_t>(source_.stride);
  const size_t step = sizeOfType(source_.type);
  for (GLint k = 0; k < source_.size; ++k)
    out[k] =
        component(p + static_cast<size_t>(k) * step, source_.type, source_.normalized, source_.symmetric);
}

std::vector<uint32_t> vertexNumbers(const RealGl& real, const ArrayState& arrays, const Elements& elements) {
  std::vector<uint32_t> numbers;
  if (!elements.type) {
    size_t count = static_cast<size_t>(elements.count);
    if (arrays.vertex.buffer) {  // vertices beyond the buffer draw nothing
      const uint32_t available = ArrayReader(real, arrays.vertex).available(),
                     first = static_cast<uint32_t>(elements.first);
      count = std::min<size_t>(count, available > first ? available - first : 0);
    }
    numbers.resize(count);
    for (size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = static_cast<uint32_t>(elements.first) + static_cast<uint32_t>(i);
    return numbers;
  }
  const auto* p = static_cast<const std::byte*>(elements.indices);
  size_t count = static_cast<size_t>(elements.count);
  std::shared_ptr<const BufferStorage> storage;
  const size_t size = sizeOfType(elements.type);
  if (arrays.elements) {
    storage = arrays.elements->read(real);
    const auto offset = reinterpret_cast<size_t>(elements.indices);
    if (!storage || offset > storage->size) return numbers;
    count = std::min(count, (storage->size - offset) / size);
    p = storage->data + offset;
  }
  if (!p) return numbers;
  numbers.resize(count);
  const auto convert = [&]<class T>(T) {
    for (size_t i = 0; i < count; ++i) {
      T value;
      std::memcpy(&value, p + i * sizeof(T), sizeof value);
      numbers[i] = static_cast<uint32_t>(value) + static_cast<uint32_t>(elements.base);
    }
  };
  if (size == 1)
    convert(uint8_t{});
  else if (size == 2)
    convert(uint16_t{});
  else
    convert(uint32_t{});
  return numbers;
}

SlotMask slotsOf(const ArrayState& arrays) {
  SlotMask slots =
      bit(kPosition) | (arrays.normal.enabled ? bit(kNormal) : 0) | (arrays.color.enabled ? bit(kColor) : 0) |
      (arrays.secondaryColor.enabled ? bit(kSecondaryColor) : 0) |
      (arrays.fogCoord.enabled ? bit(kFogCoord) : 0) | (arrays.texcoord.enabled ? bit(kTexCoord0) : 0);
  for (size_t i = 0; i < arrays.texcoordsAbove.size(); ++i)
    if (arrays.texcoordsAbove[i].enabled) slots |= bit(texCoordSlot(static_cast<uint32_t>(i) + 1));
  return slots;
}

}  // namespace gluray::gl
