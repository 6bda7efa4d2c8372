// A draw of vertex arrays by a shader program. GL thread.
#pragma once
#include "gl/commands/fixed_arrays_draw.h"

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
  /// Triangles that the draw shows as traced, and that the real OpenGL would draw: an impostor is as much
  /// work for it as the triangles of its billboard.
  uint64_t shown(const KnownMesh& mesh) const;
  uint64_t sent(const KnownMesh& mesh) const;

  Context& c_;
  const GLenum mode_;
  const Elements& elements_;
  FixedArraysDraw fixed_;      // the same draw
  const bool takesFixed_;      // the program takes its vertices from fixed function's arrays
  const bool sentBillboards_;  // the program's impostors are cut out of billboards that are sent
};

}  // namespace gluray::gl
