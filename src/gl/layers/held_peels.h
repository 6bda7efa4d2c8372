// The draws of peels that are held back, and giving up on them. A part of LayerDraws, GL thread.
#pragma once
#include "gl/layers/layer_parts.h"
#include "gl/layers/peeling.h"

namespace gluray::gl {

class HeldPeels {
 public:
  explicit HeldPeels(const LayerParts& parts) : p_(parts) {}

  /// The state, which PeelDraws and LaterPeels change.
  Peeling& peeling() { return peeling_; }
  /// Whether draws are held back, or more surfaces may join those traced.
  bool pending() const { return peeling_.stage != Peeling::Stage::none; }
  /// Whether draws need not consider peels.
  bool idle() const { return !pending() && !peeling_.emptied; }
  bool holdsDepths() const { return peeling_.stage == Peeling::Stage::depths; }
  /// Whether traced layers wait until the number of the program's peels is known. Meanwhile the program's
  /// clears and draws are held back.
  bool asks() const { return peeling_.stage == Peeling::Stage::peels; }
  /// Whether anything is held back that a flush must draw.
  bool holdsBack() const { return holdsDepths() || asks(); }
  /// Key of the layers that were already traced; null if there are none.
  const BatchKey* tracedKey() const { return peeling_.traced ? &peeling_.tracedKey : nullptr; }

  /// Makes the real OpenGL draw everything that was held back.
  void giveUp();
  /// Counts the held draws, which the real OpenGL has drawn, as rasterised.
  void countHeld();
  /// Ends the peeling, and forgets what was held back.
  void end();
  /// Whether the held depth pass draws only labels.
  bool holdsLabels() const;
  /// Leaves passes like the held one to the real OpenGL for a while, because it had to be rasterised.
  void pause();
  /// Whether the draw may show a label: at most one quad. Points may be impostors.
  static bool isLabel(GLenum mode, const Elements& elements) {
    return mode != GL_POINTS && mode != GL_LINES && trianglesIn(mode, elements) <= 2;
  }

 private:
  static uint64_t trianglesIn(GLenum mode, const Elements& elements);

  LayerParts p_;
  Peeling peeling_;
};

}  // namespace gluray::gl
