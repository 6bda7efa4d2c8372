// A draw of vertex arrays by a shader program. GL thread.
#pragma once
#include "gl/commands/fixed_arrays_draw.h"

#include <optional>

namespace gluray::gl {

class ProgramArraysDraw final : public DrawRequest {
 public:
  ProgramArraysDraw(Context& context, GLenum mode, const Elements& elements);

  Reason classifyState() override;
  KnownMesh mesh() override;
  Reason classifyMesh(const KnownMesh& mesh) override;
  Reason trace(const KnownMesh& mesh) override;
  bool replace(Reason reason) override;
  void meetPasses(PrimitiveClass primitive, Reason reason) override;
  Load load() override;
  Fate make() override;

 private:
  /// Traces the volume that the draw shows. False: the real OpenGL must draw it.
  bool traceVolume();
  /// The draw with its instances as it is traced: as one where each instance is an impostor.
  const Elements& repeated() const { return ofInstances_ && vertices_ ? *vertices_ : elements_; }
  /// Number of triangles that the draw shows if it is traced.
  uint64_t shown(const KnownMesh& mesh) const;
  /// Number of triangles that the real OpenGL would draw: an impostor costs it as much as its billboard's
  /// triangles.
  uint64_t sent(const KnownMesh& mesh) const;

  Context& c_;
  const GLenum mode_;
  const Elements& elements_;
  const GLenum shownMode_;                  // the primitives of vertices_
  const std::optional<Elements> vertices_;  // the draw of shadow.vertices(); nullopt: it is none
  FixedArraysDraw fixed_;                   // the same draw
  const bool ofInstances_;                  // each instance is an impostor
  const bool takesFixed_;                   // the program reads fixed function's vertex arrays
  const bool sentBillboards_;               // the program sends the billboards of its impostors
  const bool impostors_;                    // the program shows impostors
};

}  // namespace gluray::gl
