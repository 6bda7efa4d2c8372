// State of vertex arrays, read back from the real OpenGL, and the meshes and captures built from them. GL
// thread.
#pragma once
#include "gl/arrays/primitive_restart.h"
#include "gl/basics/reasons.h"
#include "gl/buffers/buffer.h"
#include "gl/capture/captured_vertices.h"
#include "gl/real/elements.h"
#include "gl/sharing/share_group.h"
#include "scene/mesh.h"

#include <memory>
#include <vector>

namespace gluray::gl {

/// One array. `pointer` is an offset into `buffer` or, without a buffer, an address in the host program's
/// memory.
struct ArraySource {
  bool enabled = false;
  GLint size = 4;
  GLenum type = GL_FLOAT;
  GLsizei stride = 0;  // bytes between elements; 0: cannot be read
  const std::byte* pointer = nullptr;
  std::shared_ptr<Buffer> buffer;
  bool normalized = false;  // integers are converted to fractions (normals, colours)
  bool symmetric = false;   // if `normalized`: by GL 4.2's rule, with an exact 0
  GLint location = -1;      // of a shader program's attribute; -1: fixed function
  GLuint binding = 0;       // of a shader program's attribute: its vertex buffer binding
  GLuint divisor = 0;       // instances per element; 0: one element per vertex
};

struct ArrayState {
  ArraySource vertex, normal, color, secondaryColor, fogCoord, texcoord;
  ArraySource radius, axis;                  // of impostors (scene/impostors.h)
  ArraySource corners, end, endColor, caps;  // of impostors whose billboards the program sends
  bool sentBillboards = false;               // the four arrays above and the two flags below apply
  bool ofInstances = false;                  // arrays have an element for each instance, which is an impostor
  bool radiusInPosition = false;
  bool radiusInCorners = false;  // `corners` has minus or plus the radius for each direction of a square
  scene::Shape shape = scene::Shape::triangles;
  float impostorRadius = 1;                 // if no array gives radii
  float impostorCaps = 0;                   // if no array gives `caps`
  std::vector<ArraySource> texcoordsAbove;  // of texture units 1, 2 ... up to the last that is enabled
  std::shared_ptr<Buffer> elements;         // bound to GL_ELEMENT_ARRAY_BUFFER
  // Of shader programs: other enabled arrays, including per-instance ones.
  std::vector<ArraySource> generic;
  // Columns of per-instance matrices. instanceTransform may also be one array of x, y, z of a position, and a
  // scale.
  std::vector<ArraySource> instanceTransform, instanceNormal;
  ArraySource instanceColor;
  bool others = false;  // arrays that only the real OpenGL handles are enabled (edge flags ...)
  PrimitiveRestart restart;
  Reason reason = Reason::traced;  // why these arrays cannot be traced

  /// All per-vertex arrays except `generic`, in a fixed order.
  template <class Each>
  void forEach(Each&& each) const {
    for (const ArraySource* source : {&vertex, &normal, &color, &secondaryColor, &fogCoord, &texcoord,
                                      &radius, &axis, &corners, &end, &endColor, &caps})
      each(*source);
    for (const ArraySource& source : texcoordsAbove) each(source);
  }
};

/// Bytes per component.
size_t sizeOfType(GLenum type);
/// Whether the array's elements can be read as floats.
bool isReadable(const ArraySource& source);
/// Whether the array lies in a buffer that the real OpenGL maps, or that is written without GLuRay seeing it.
bool isForeign(const ArraySource& source);
/// Why a draw cannot be traced, if such a buffer contains its indices or an array; else Reason::traced.
Reason foreignReason(const ArrayState& arrays);
/// The buffer `name`, created if it is not known yet; null for 0.
std::shared_ptr<Buffer> bufferNamed(ShareGroup& group, GLuint name);

/// Reads the pointers and enables back from the real OpenGL.
void readArrays(const RealGl& real, ShareGroup& group, ArrayState& state);

/// Rule that converts signed integers to fractions.
enum class Fractions : uint8_t {
  ofArrays,    // ArraySource::symmetric
  ofCommands,  // that of glNormal3b etc., for glArrayElement and draws in lists
};

/// Reads single elements of an array as floats. The host program's memory must outlive it.
class ArrayReader {
 public:
  ArrayReader(const RealGl& real, const ArraySource& source, Fractions fractions = Fractions::ofArrays);
  bool enabled() const { return source_.enabled; }
  /// Number of elements in the buffer; the largest uint32_t for the program's memory, whose size is unknown.
  uint32_t available() const { return available_; }
  uint32_t divisor() const { return source_.divisor; }
  /// Reads element i, with missing components from (0, 0, 0, 1). `i` must be below available().
  void read(uint32_t i, float out[4]) const;
  const std::byte* data() const { return data_; }
  const std::shared_ptr<const BufferStorage>& storage() const { return storage_; }

 private:
  ArraySource source_;
  std::shared_ptr<const BufferStorage> storage_;
  const std::byte* data_ = nullptr;
  uint32_t available_ = 0;
};

/// The vertex numbers of a draw, in order. Indices beyond the element buffer are left out.
std::vector<uint32_t> vertexNumbers(const RealGl& real, const ArrayState& arrays, const Elements& elements);

/// Copies the vertices of a draw into a capture.
CapturedVertices capture(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements,
                         Fractions fractions = Fractions::ofArrays);

/// Builds the mesh of a surface draw; buffers are read in place if their format allows it.
KnownMesh buildArrayMesh(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements);

/// Builds the mesh of a draw of points or separate lines that the program shows as impostors, or of
/// billboards. Null if billboards are not whole (gl/impostors/sent_billboards.h).
KnownMesh buildImpostorMesh(const RealGl& real, const ArrayState& arrays, GLenum mode,
                            const Elements& elements);

/// Hash that identifies the input of buildArrayMesh() and buildImpostorMesh(): versions of buffers, contents
/// of the host program's memory.
Hash128 contentOf(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements);

/// Slots that the enabled arrays fill.
SlotMask slotsOf(const ArrayState& arrays);

}  // namespace gluray::gl
