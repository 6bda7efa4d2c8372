// Finds where the positions of rasterised draws come from: the array, and the matrix to clip space, by a
// shader program or by fixed function. A part of CulledDraws, which large and small draws use. GL thread,
// context current.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/culled/constant_attributes.h"
#include "gl/culled/culled_program.h"
#include "gl/pending/pending_batch.h"
#include "gl/real/elements.h"
#include "gl/shadow/shadow_state.h"

#include <GL/gl.h>

#include <memory>
#include <string>
#include <unordered_map>

namespace gluray::gl {

/// Source of a draw's vertices, and the matrix to clip space.
struct PositionSource {
  const ArrayState* arrays = nullptr;
  const ArraySource* positions = nullptr;  // one of `arrays`
  int components = 4;                      // number of components that are used
  ClipMatrix matrix;                       // without the terms of instance attributes
  LinearPosition position;                 // by a program
  CulledProgram* program = nullptr;        // null: fixed function
};

class PositionSources {
 public:
  PositionSources(ShadowState& shadow, PendingBatch& pending) : shadow_(shadow), pending_(pending) {}

  /// Finds the source of draws with the current state. Returns CullReason::culled, or the reason why the
  /// source is unknown or why hidden triangles affect the image.
  CullReason find(GLenum mode, const Elements& elements, PositionSource& source);
  /// Finds the transform of fixed function. Returns CullReason::culled, or the reason why such draws cannot
  /// be culled. Ignores blending.
  CullReason findFixedFunction(PositionSource& source);
  /// Finds the array of a program's attribute. Returns false if there is none.
  bool findArray(CulledProgram& program, const std::string& attribute, const ArrayState*& arrays,
                 const ArraySource*& positions);
  /// Returns the reason why hidden surfaces of the program affect the image through blending, or
  /// CullReason::culled.
  CullReason blendingOf(CulledProgram& program, const Varyings& varyings, GLenum mode,
                        const Elements& elements);

  /// The current shader program; requires one.
  CulledProgram& programInUse();
  /// Reports that a culled draw of the program (null: fixed function) differs from the complete draw: stops
  /// culling such draws, and logs one line.
  void refuseDifferent(CulledProgram* program);
  /// Forgets programs that the host program has deleted.
  void forgetOld();

 private:
  CullReason findProgram(GLenum mode, const Elements& elements, PositionSource& source);

  ShadowState& shadow_;
  PendingBatch& pending_;
  std::unordered_map<const KnownProgram*, std::unique_ptr<CulledProgram>> programs_;
  ConstantAttributes constants_;
  bool fixedDiffers_ = false;  // a culled draw by fixed function was different
};

}  // namespace gluray::gl
