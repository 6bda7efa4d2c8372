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

  /// Why its draws cannot be culled, whatever its uniforms are; CullReason::culled: they may be.
  CullReason reason() const { return reason_; }
  /// The same in words for the user, more precisely; may be empty.
  const std::string& why() const { return why_; }
  /// With the current values of its uniforms. `instances`: its attributes that have one value for an
  /// instance. Nothing: not linear; sets why(). `varyings`: takes what fragments get.
  std::optional<LinearPosition> position(const RealGl& real, bool core, const InstanceAttributes& instances,
                                         Varyings* varyings = nullptr);
  /// What is known of alpha in all that it draws, with the current values of its uniforms.
  Opacity opacity(const RealGl& real, bool core, Varyings varyings) const;
  /// Where it puts vertices whatever it computes.
  PositionFeedback& feedback() { return feedback_; }
  /// The same as position() without attributes of instances, for many draws: runs of the shader are
  /// remembered by the uniforms that they read. False: not linear.
  bool placedPosition(const RealGl& real, bool core, PlacedPosition& found);
  /// Whether its fragment shader leaves out fragments.
  bool discards() const { return discards_; }
  /// Whether it interpolates at centroids of covered samples. Mesa (22.3) takes only those that pass the
  /// depth test, so that they depend on what was drawn before.
  bool usesCentroids() const { return usesCentroids_; }
  /// Whether its shaders read numbers of instances, which are others where instances are left out.
  bool numbersInstances() const { return numbersInstances_; }
  /// It is not culled from now on.
  void refuse(CullReason reason) { reason_ = reason; }
  /// Whether nothing else knows the program any more.
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
