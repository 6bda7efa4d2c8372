#include "gl/culled/culled_program.h"

#include "gl/culled/small/current_uniforms.h"
#include "gl/glsl/glsl_tokens.h"
#include "gl/glsl/program_source.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace gluray::gl {
namespace {

/// Words of a shader that prevent culling: values that change if a draw is made in parts, and outputs that
/// affect depth tests.
struct Obstacle {
  std::string_view word;
  CullReason reason;
};
constexpr std::array kObstacles{
    Obstacle{"gl_FragDepth", CullReason::fragmentDepth},
    Obstacle{"gl_FragDepthEXT", CullReason::fragmentDepth},
    Obstacle{"gl_FragStencilRefARB", CullReason::stencil},
    Obstacle{"gl_PrimitiveID", CullReason::primitiveNumbers},
    Obstacle{"gl_BaseVertex", CullReason::primitiveNumbers},
    Obstacle{"gl_BaseVertexARB", CullReason::primitiveNumbers},
    Obstacle{"gl_DrawID", CullReason::primitiveNumbers},
    Obstacle{"gl_DrawIDARB", CullReason::primitiveNumbers},
    Obstacle{"gl_SampleMask", CullReason::multisampleState},
    Obstacle{"gl_SampleMaskIn", CullReason::multisampleState},
    Obstacle{"post_depth_coverage", CullReason::multisampleState},
    Obstacle{"early_fragment_tests", CullReason::fragmentDepth},  // discarded fragments write depth
    Obstacle{"gl_LastFragData", CullReason::blend},
    Obstacle{"gl_LastFragColorARM", CullReason::blend},
    Obstacle{"gl_Layer", CullReason::geometryShader},
    Obstacle{"gl_ViewportIndex", CullReason::geometryShader},
    Obstacle{"gl_ViewportMask", CullReason::geometryShader},
};

CullReason obstacleIn(std::string_view text) {
  GlslTokens tokens(text);
  for (std::string_view word = tokens.nextToken(); !word.empty(); word = tokens.nextToken()) {
    const auto found = std::ranges::find(kObstacles, word, &Obstacle::word);
    if (found != kObstacles.end()) return found->reason;
  }
  return CullReason::culled;
}

bool hasWord(std::string_view text, std::initializer_list<std::string_view> wanted) {
  GlslTokens tokens(text);
  for (std::string_view word = tokens.nextToken(); !word.empty(); word = tokens.nextToken())
    if (std::ranges::find(wanted, word) != wanted.end()) return true;
  return false;
}

/// Sets gl_Color of fragments: the front colour, or front and back colour, clamped.
void passOnColor(const RealGl& real, Varyings& varyings) {
  const auto front = varyings.find("gl_FrontColor"), back = varyings.find("gl_BackColor");
  if (front == varyings.end() || back == varyings.end()) return;
  std::vector<VaryingComponent> color = front->second;
  for (size_t i = 0; i < color.size() && i < back->second.size(); ++i) {
    const VaryingComponent& other = back->second[i];
    const bool same = color[i].value == other.value && color[i].attribute == other.attribute;
    const bool clamped = color[i].value && (*color[i].value < 0 || *color[i].value > 1);
    if (clamped || (!same && isOn(real, GL_VERTEX_PROGRAM_TWO_SIDE))) color[i] = {};
  }
  varyings["gl_Color"] = std::move(color);
}

}  // namespace

CulledProgram::CulledProgram(const RealGl& real, std::shared_ptr<const KnownProgram> known)
    : known_(std::move(known)), feedback_(known_->program) {
  reason_ = check(real);
}

CullReason CulledProgram::check(const RealGl& real) {
  const Program& program = known_->program;
  if (!program.linked) return CullReason::program;
  if (program.geometryShader || program.tessellation) return CullReason::geometryShader;
  if (program.writes) return CullReason::memoryWrites;
  ProgramSource source(real, program);
  if (!source.isWhole(false)) return CullReason::noSource;
  const std::string vertex = source.textOf(GL_VERTEX_SHADER), fragment = source.textOf(GL_FRAGMENT_SHADER);
  for (const std::string* text : {&vertex, &fragment})
    if (const CullReason reason = obstacleIn(*text); reason != CullReason::culled) return reason;
  discards_ = hasWord(fragment, {"discard"});
  for (const std::string* text : {&vertex, &fragment}) {
    usesCentroids_ = usesCentroids_ || hasWord(*text, {"centroid", "interpolateAtCentroid"});
    numbersInstances_ =
        numbersInstances_ || hasWord(*text, {"gl_InstanceID", "gl_InstanceIDARB", "gl_InstanceIDEXT",
                                             "gl_InstanceIndex", "gl_BaseInstance", "gl_BaseInstanceARB"});
  }
  slice_.emplace(vertex), alpha_.emplace(fragment);
  why_ = slice_->why();
  return why_.empty() ? CullReason::culled : CullReason::positions;
}

std::optional<LinearPosition> CulledProgram::position(const RealGl& real, bool core,
                                                      const InstanceAttributes& instances,
                                                      Varyings* varyings) {
  if (reason_ != CullReason::culled) return std::nullopt;
  return slice_->evaluate(CurrentUniforms(real, known_->program, core), why_, instances, varyings);
}

Opacity CulledProgram::opacity(const RealGl& real, bool core, Varyings varyings) const {
  if (!alpha_) return {};
  if (!core) passOnColor(real, varyings);
  return alpha_->opacity(CurrentUniforms(real, known_->program, core), varyings);
}

bool CulledProgram::placedPosition(const RealGl& real, bool core, PlacedPosition& found) {
  if (reason_ != CullReason::culled) return false;
  if (!positions_) positions_.emplace(*slice_);
  return positions_->find(CurrentUniforms(real, known_->program, core), found);
}

}  // namespace gluray::gl
