// Logs, at level trace, the decision for each draw and each batch of a context, with its command. Versions of
// GLuRay that decide alike write identical lines. GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/counts/draw_kinds.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace gluray::gl {

struct BatchKey;
struct PresentResult;

class Decisions {
 public:
  /// Reports that the program calls this command, of OpenGL or of the window system. `name` must stay valid.
  void command(const char* name) noexcept { command_ = name; }
  /// Logs a draw that was counted. `state`: the result of DrawKinds::record().
  void draw(Reason reason, DrawPath path, PrimitiveClass primitive, uint64_t triangles, uint32_t state);
  /// Logs a further decision for the draw, such as whether it was culled or lit, and why.
  void detail(std::string_view what, std::string_view why = {});
  /// Logs that a batch is presented. `how`: "traced", or why the real OpenGL draws it, or the destination of
  /// the traced image other than the framebuffer.
  void batch(const BatchKey& key, size_t instances, std::string_view how);
  /// A batch of so many instances is lit again (Relighting).
  void relit(size_t instances);
  /// Logs the result of presenting a batch. `known`: its image was shown before.
  void presented(const PresentResult& result, bool known);

 private:
  void write(std::string line) const;
  const char* command_ = "";
  uint64_t draws_ = 0, batches_ = 0;
};

}  // namespace gluray::gl
