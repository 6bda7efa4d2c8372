// Logs, at level trace, the decision for each draw and each batch of a context, with its command. Versions of
// GLuRay with equal decisions write equal lines. GL thread.
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
  /// The program calls this command, of OpenGL or of the window system; the string must stay.
  void command(const char* name) noexcept { command_ = name; }
  /// A draw was counted. `state`: as DrawKinds::record() returns it.
  void draw(Reason reason, DrawPath path, PrimitiveClass primitive, uint64_t triangles, uint32_t state);
  /// What else became of the draw: it was culled, lit ... or not, and why.
  void detail(std::string_view what, std::string_view why = {});
  /// The draws of a batch are presented: `how` is "traced", or why the real OpenGL makes them, or where the
  /// traced image goes in place of the framebuffer.
  void batch(const BatchKey& key, size_t instances, std::string_view how);
  /// A batch of so many instances is lit again (Relighting).
  void relit(size_t instances);
  /// A batch was presented. `known`: its image was shown before.
  void presented(const PresentResult& result, bool known);

 private:
  void write(std::string line) const;
  const char* command_ = "";
  uint64_t draws_ = 0, batches_ = 0;
};

}  // namespace gluray::gl
