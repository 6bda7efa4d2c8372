// Vertex arrays of the fixed-function pipeline: where they point now, and meshes made of what they hold. GL
// thread.
#pragma once
#include "gl/arrays/elements.h"
#include "gl/buffers/buffer.h"
#include "gl/capture/captured_vertices.h"
#include "gl/draws/reasons.h"
#include "gl/share_group.h"
#include "scene/mesh.h"

#include <memory>
#include <vector>

namespace gluray::gl {

/// One array. Without a buffer `pointer` is the program's memory, with one it is an offset.
struct ArraySource {
  bool enabled = false;
  GLint size = 4;
  GLenum type = GL_FLOAT;
  GLsizei stride = 0;  // bytes between elements; 0 is not readable
  const std::byte* pointer = nullptr;
  std::shared_ptr<Buffer> buffer;
  bool normalized = false;  // integers stand for fractions (normals, colours)
  bool symmetric = false;   // and those with a sign have an exact 0 (GL 4.2)
  GLint location = -1;      // of shader programs' attributes
  GLuint binding = 0;       // the same: where the buffer is bound to
  GLuint divisor = 0;       // instances an element; 0: one a vertex
};

struct ArrayState {
  ArraySource vertex, normal, color, secondaryColor, fogCoord, texcoord;
  ArraySource radius, axis;  // of impostors (scene/impostors.h)
  scene::Shape shape = scene::Shape::triangles;
  float impostorRadius = 1;                 // where no array gives it
  std::vector<ArraySource> texcoordsAbove;  // of texture units 1, 2 ... up to the last that is enabled
  std::shared_ptr<Buffer> elements;         // bound to GL_ELEMENT_ARRAY_BUFFER
  // Of shader programs: arrays that are on and none of the above, instances' among them.
  std::vector<ArraySource> generic;
  std::vector<ArraySource> instanceTransform, instanceNormal;  // columns of matrices that instances have
  ArraySource instanceColor;
  bool others = false;             // arrays that only the real OpenGL handles are on (edge flags ...)
  Reason reason = Reason::traced;  // why these arrays cannot be traced

  /// All of them, in a fixed order.
  template <class Each>
  void forEach(Each&& each) const {
    for (const ArraySource* source :
         {&vertex, &normal, &color, &secondaryColor, &fogCoord, &texcoord, &radius, &axis})
      each(*source);
    for (const ArraySource& source : texcoordsAbove) each(source);
  }
};

/// Bytes of a component.
size_t sizeOfType(GLenum type);
/// Whether its elements can be read as floats.
bool isReadable(const ArraySource& source);
/// Whether the array, or the indices of `arrays`, lie in a buffer that is written where we take no note.
bool isForeign(const ArraySource& source);
/// Why arrays cannot be traced of which a buffer is; Reason::traced where none is.
Reason foreignReason(const ArrayState& arrays);
/// Whether index values end primitives.
bool restartsPrimitives(const RealGl& real);
/// The buffer of this name, made where it is not known yet; null for 0.
std::shared_ptr<Buffer> bufferNamed(ShareGroup& group, GLuint name);

/// Reads the pointers and enables back from the real OpenGL.
void readArrays(const RealGl& real, ShareGroup& group, ArrayState& state);

/// Reads single elements of an array as floats. The storage must outlive it.
class ArrayReader {
 public:
  ArrayReader(const RealGl& real, const ArraySource& source);
  bool enabled() const { return source_.enabled; }
  /// Elements in the buffer; what the program's own memory holds is unknown, so there it is the largest
  /// number.
  uint32_t available() const { return available_; }
  uint32_t divisor() const { return source_.divisor; }
  /// Element i with missing components from (0, 0, 0, 1). `i` must be available.
  void read(uint32_t i, float out[4]) const;
  const std::byte* data() const { return data_; }
  const std::shared_ptr<const BufferStorage>& storage() const { return storage_; }

 private:
  ArraySource source_;
  std::shared_ptr<const BufferStorage> storage_;
  const std::byte* data_ = nullptr;
  uint32_t available_ = 0;
};

/// The vertex numbers of a draw in order. Indices beyond the element buffer are left out.
std::vector<uint32_t> vertexNumbers(const RealGl& real, const ArrayState& arrays, const Elements& elements);

/// Copies a draw into a capture of its own.
CapturedVertices capture(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements);

/// The mesh of a draw of surfaces; buffers are read in place where their form allows.
KnownMesh buildArrayMesh(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements);

/// The same of a draw of points, or of separate lines, of which the program makes impostors.
KnownMesh buildImpostorMesh(const RealGl& real, const ArrayState& arrays, GLenum mode,
                            const Elements& elements);

/// Identity of what both would read: versions of buffers, contents of the program's memory.
Hash128 contentOf(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements);

/// Slots that the enabled arrays fill.
SlotMask slotsOf(const ArrayState& arrays);

}  // namespace gluray::gl
