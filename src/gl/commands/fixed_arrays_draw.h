// A draw of fixed function's vertex arrays, by fixed function or by a shader program. GL thread.
#pragma once
#include "gl/draws/draw_request.h"
#include "gl/real/elements.h"

#include <GL/gl.h>

namespace gluray::gl {

class Context;

class FixedArraysDraw final : public DrawRequest {
 public:
  FixedArraysDraw(Context& context, GLenum mode, const Elements& elements)
      : c_(context), mode_(mode), elements_(elements) {}

  Reason classifyState() override;
  KnownMesh mesh() override;
  Reason classifyMesh(const KnownMesh& mesh) override;
  Reason trace(const KnownMesh& mesh) override;
  void meetPasses(PrimitiveClass primitive, Reason reason) override;
  Load load() override;
  Fate make() override;

 private:
  /// False without a position array: the draw may then use the current position, and the real OpenGL decides.
  bool hasKnownVertices() const;

  Context& c_;
  const GLenum mode_;
  const Elements& elements_;
};

}  // namespace gluray::gl
