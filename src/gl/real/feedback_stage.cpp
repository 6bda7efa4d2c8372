#include "gl/real/feedback_stage.h"

#include "gl/real/extensions.h"
#include "gl/real/state_queries.h"

namespace gluray::gl {

bool hasFeedbackObjects(const RealGl& real) {
  if (!isPresent(real.BindTransformFeedback) || !isPresent(real.TransformFeedbackVaryings)) return false;
  const int version = versionOf(real);
  return version >= 40 || (version >= 30 && hasExtension(real, version, "GL_ARB_transform_feedback2"));
}

FeedbackStage::FeedbackStage(const RealGl& real, GLuint program, GLuint feedback)
    : real_(real),
      feedback_(integer(real, GL_TRANSFORM_FEEDBACK_BINDING)),
      buffer_(integer(real, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING)),
      program_(real) {
  real.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
  program_.use(program);
  real.Enable(GL_RASTERIZER_DISCARD);
}

FeedbackStage::~FeedbackStage() {
  real_.Disable(GL_RASTERIZER_DISCARD);
  real_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, static_cast<GLuint>(feedback_));
  real_.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLuint>(buffer_));
}

}  // namespace gluray::gl
