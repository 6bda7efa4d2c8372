// Tests whether the draws of a shader program can be culled, and finds its vertex transform. GL thread,
// context current.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/culled/feedback/position_feedback.h"
#include "gl/culled/shader_slice/position_slice.h"
#include "gl/culled/small/placed_positions.h"
#include "gl/programs/match.h"
#include "gl/real/real.h"

#include <memory>
#include <optional>
#include <string>

namespace gluray::gl {

class ShareGroup;

class CulledProgram {
 public:
  /// Reads the program's source.
  CulledProgram(const RealGl& real, std::shared_ptr<const KnownProgram> known);

  /// The reason why its draws cannot be culled for any values of uniforms; CullReason::culled if there is
  /// none.
  CullReason reason() const { return reason_; }
  /// A more precise reason in words for the user; may be empty.
  const std::string& why() const { return why_; }
  /// Finds the position with the current uniforms. `instances`: its per-instance attributes. Returns nullopt,
  /// and sets why(), if it is not linear. `varyings`: receives the fragment shader's inputs.
  std::optional<LinearPosition> position(const RealGl& real, bool core, const InstanceAttributes& instances,
                                         Varyings* varyings = nullptr);
  /// Alpha of all its fragments with the current uniforms.
  Opacity opacity(const RealGl& real, bool core, Varyings varyings) const;
  /// Transform feedback of its positions.
  PositionFeedback& feedback() { return feedback_; }
  /// Like position() without instance attributes, for many draws: caches interpretations of the shader by the
  /// uniforms that they read. Returns false if not linear.
  bool placedPosition(const RealGl& real, bool core, PlacedPosition& found);
  /// Whether its fragment shader discards fragments.
  bool discards() const { return discards_; }
  /// Whether it interpolates at centroids of covered samples. Mesa (22.3) uses only samples that pass the
  /// depth test, so that centroids depend on earlier draws.
  bool usesCentroids() const { return usesCentroids_; }
  /// Whether its shaders read instance numbers, which change if instances are skipped.
  bool numbersInstances() const { return numbersInstances_; }
  /// Stops culling its draws.
  void refuse(CullReason reason) { reason_ = reason; }
  /// Whether the program has no other owner.
  bool isForgotten() const { return known_.use_count() == 1; }
  const KnownProgram& known() const { return *known_; }

 private:
  CullReason check(const RealGl& real);

  std::shared_ptr<const KnownProgram> known_;
  PositionFeedback feedback_;
  std::optional<PositionSlice> slice_;
  std::optional<AlphaSlice> alpha_;
  std::optional<PlacedPositions> positions_;
  CullReason reason_ = CullReason::culled;
  bool discards_ = false;
  bool usesCentroids_ = false;
  bool numbersInstances_ = false;
  std::string why_;
};

}  // namespace gluray::gl
