#include "tests/fuzz/session.h"

#include "frame/testing/test_renderer.h"
#include "tests/fuzz/comparison.h"
#include "tests/fuzz/null_gl.h"
#include "tests/support/gl_state.h"
#include "tests/support/traced_context.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <set>
#include <sstream>
#include <string_view>

namespace gluray::fuzz {
namespace {

using test::OsmesaContext;
using test::TracedContext;

/// Two contexts that share their objects.
class Plain {
 public:
  explicit Plain(const Stream&)
      : first_(OsmesaContext::create({kSize, kSize})),
        second_(OsmesaContext::create({kSize, kSize}, first_.get())) {}
  const gl::RealGl& gl() const { return first_->real(); }
  void makeCurrent(uint32_t which) { (which ? second_ : first_)->makeCurrent(); }

 private:
  std::unique_ptr<OsmesaContext> first_, second_;
};

Settings settingsOf(const Stream& stream) {
  Settings s = TracedContext::vertexShading();
  s.threads = 1;
  s.engine = stream.engine;
  return s;
}

class Ours {
 public:
  explicit Ours(const Stream& stream)
      : first_({kSize, kSize}, settingsOf(stream)),
        second_({kSize, kSize}, settingsOf(stream), nullptr, &first_) {}
  ~Ours() { first_.makeCurrent(); }
  const gl::RealGl& gl() const { return first_.gl(); }
  void makeCurrent(uint32_t which) { (which ? second_ : first_).makeCurrent(); }

 private:
  TracedContext first_, second_;
};

Drawn g_drawn;  // draws of the stream played over NullGl

/// Traces each batch and discards the image; sometimes fails.
class Tracer final : public gl::Presenter {
 public:
  gl::PresentResult present(const gl::RealGl&, const scene::SnapshotPtr& snapshot,
                            const gl::PresentTarget& target) noexcept override {
    gl::PresentResult result;
    scene::TraceCost statistics;
    if (target.rasterise) {
      result.outcome = gl::PresentResult::rasterised;
    } else if (++images_ % 500 != 0 &&
               test::testRenderer().render(*snapshot, image_, statistics, result.why)) {
      result.outcome = gl::PresentResult::traced;
      g_drawn.byPrograms += target.programDraws.size();
    }
    return result;
  }
  bool supports(const gl::RealGl&, bool, std::string&) noexcept override { return true; }
  void forget(const gl::RealGl&) noexcept override {}

 private:
  int images_ = 0;
  Image image_;
};

/// A clock that advances by a fixed step at each reading, so that streams are reproducible.
double ticks() {
  static double now = 0;
  return now += 0.001;
}

/// Two GLuRay contexts over an OpenGL that draws nothing.
class Alone {
 public:
  explicit Alone(const Stream& stream) : below_{NullGl(), NullGl(&below_[0])} {
    const auto group = std::make_shared<gl::ShareGroup>();
    gl::ContextInfo info;
    info.doubleBuffered = false;
    info.settings = settingsOf(stream);
    info.families = test::familiesOfTests();
    info.drawableSize = [] { return glm::ivec2(kSize); };
    info.clock = ticks;
    for (auto& context : contexts_) context = gl::Context::create(NullGl::table(), group, info, tracer_);
    contexts_[0]->makeCurrent();
  }
  ~Alone() {
    makeCurrent(0);
    contexts_[0]->loseCurrent();
    for (const auto& context : contexts_) {
      g_drawn.traced += context->counts.statistics.drawsTraced;
      g_drawn.rasterised += context->counts.statistics.drawsRasterised;
    }
  }
  const gl::RealGl& gl() const { return TracedContext::stubs(); }
  void makeCurrent(uint32_t which) {
    if (gl::Context* last = gl::t_thread.context) last->loseCurrent();
    below_[which ? 1 : 0].makeCurrent();
    contexts_[which ? 1 : 0]->makeCurrent();
  }

 private:
  NullGl below_[2];
  Tracer tracer_;
  std::shared_ptr<gl::Context> contexts_[2];
};

bool isOf(Ops ops, const Op* op) { return op >= ops.data() && op < ops.data() + ops.size(); }

/// Components that a call sets of an attribute which may have one to four; 0 for other calls.
int sizeOfAttribute(std::string_view name) {
  if (name.find("TexCoord") == name.npos && name.find("VertexAttrib") == name.npos) return 0;
  const size_t digit = name.find_first_of("1234");
  return digit == name.npos ? 0 : name[digit] - '0';
}

bool makesVertex(const Op* op) {
  const std::string_view name = op->name;
  return isOf(vertexAttributeCalls(), op) && name.substr(0, 6) == "Vertex" &&
         name.substr(0, 12) != "VertexAttrib";
}

/// Coordinates of glVertex*i, *s and P* reach to 2^31.
bool isOfIntegers(std::string_view vertex) { return vertex.find_first_of("isP") != vertex.npos; }

/// Whether the call would crash Mesa here, or OpenGL leaves its result undefined (avoided.md).
bool avoided(const Player& p, const Stream& stream, const Op* op) {
  if (p.executing && (isOf(askCalls(), op) || isOf(bufferCalls(), op))) return true;
  const bool attribute = isOf(vertexAttributeCalls(), op) || isOf(attributeCalls(), op);
  if (attribute && sizeOfAttribute(op->name) != 0 && sizeOfAttribute(op->name) != stream.attributeSize)
    return true;
  if (attribute && std::string_view(op->name).substr(0, 7) == "ColorP3") return true;
  if (makesVertex(op) && stream.tame && isOfIntegers(op->name)) return true;
  if (makesVertex(op) && !p.insideBegin && !p.compiling) return true;
  if (!p.compiling) return false;
  if (p.grown && isOf(drawCalls(), op)) return true;
  if (!p.insideBegin) return isOf(endCalls(), op);
  return !attribute && !isOf(vertexCalls(), op) && !isOf(endCalls(), op);
}

/// Notes that a primitive of a list has vertices of several sizes, or attributes that its first vertex lacks.
class Growth {
 public:
  void look(Player& p, const Op* op) {
    const bool attribute =
        isOf(vertexAttributeCalls(), op) || isOf(attributeCalls(), op) || isOf(vertexCalls(), op);
    if (!p.compiling || !p.insideBegin) return known_.clear(), void(vertices_ = 0);
    if (!attribute) return;
    const bool fresh = known_.insert(op).second;
    p.grown = p.grown || (fresh && vertices_ > 0);
    vertices_ += makesVertex(op);
  }

 private:
  std::set<const Op*> known_;
  int vertices_ = 0;
};

/// Prepares a context: arrays point at memory, the depth test is on.
void prepare(Player& p) {
  p.arraysToMemory();
  p.fillBuffers();
  GLuint made[2];
  p.gl.GenQueries(2, made);
  p.gl.GenVertexArrays(3, p.vertexArrays[p.context].data());
  p.gl.SelectBuffer(static_cast<GLsizei>(p.sink().selection.size()), p.sink().selection.data());
  p.gl.FeedbackBuffer(static_cast<GLsizei>(p.sink().feedback.size()), GL_3D, p.sink().feedback.data());
  p.gl.Enable(GL_DEPTH_TEST);
  p.gl.Viewport(0, 0, kSize, kSize);
  p.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// `whole`: avoids no calls.
template <class Side>
Record playTo(const Stream& stream, bool state, bool whole = false) {
  auto sink = std::make_unique<Sink>();
  Side side(stream);
  Player p(side.gl(), *sink, [&](uint32_t which) { side.makeCurrent(which); });
  p.smallBuffers = stream.smallBuffers;
  p.attributeSize = stream.attributeSize;
  for (uint32_t context : {1u, 0u}) p.switchTo(context), prepare(p);
  Growth growth;
  for (size_t i = 0; i < stream.calls.size(); ++i) {
    const Call& call = stream.calls[i];
    if (!whole && avoided(p, stream, call.op)) continue;
    growth.look(p, call.op);
    if (p.insideBegin && !isOf(endCalls(), call.op)) p.vertexWanted = !makesVertex(call.op);
    p.start(i, call.seed, stream.weird);
    call.op->run(p);
    if (stream.askErrors && !(p.compiling && (p.insideBegin || p.executing)))
      p.answer("GetError", {static_cast<double>(p.gl.GetError())});
  }
  p.start(stream.calls.size(), 0, 0);
  if (p.insideBegin) p.gl.End();
  if (p.compiling) p.gl.EndList();
  p.gl.RenderMode(GL_RENDER);
  p.answer("GetError at the end", {static_cast<double>(p.gl.GetError())});
  Record record;
  if (state) record.state = test::queryState(p.gl);
  if (stream.tame) record.image = test::readImage(p.gl, kSize, kSize);
  p.gl.Finish();
  record.answers = p.answers();
  return record;
}

}  // namespace

Outcome play(const Stream& stream, bool state, bool& ours) {
  ours = false;
  const Record expected = playTo<Plain>(stream, state);
  ours = true;
  const Record got = playTo<Ours>(stream, state);
  Outcome outcome = compareAnswers(expected.answers, got.answers);
  if (outcome.what.empty()) outcome = compareState(expected.state, got.state);
  if (outcome.what.empty() && stream.tame) outcome = compareImages(expected.image, got.image);
  return outcome;
}

Drawn playAlone(const Stream& stream) {
  g_drawn = {};
  playTo<Alone>(stream, false, true);
  return g_drawn;
}

std::string describe(const Stream& stream, bool alone) {
  // Only describes the calls and executes none: they may crash an OpenGL.
  gl::RealGl nobody;
  gl::loadRealGl(
      nobody, [](void*, const char*) -> void* { return nullptr; }, nullptr);
  auto sink = std::make_unique<Sink>();
  Player p(nobody, *sink, [](uint32_t) {});
  p.smallBuffers = stream.smallBuffers;
  p.attributeSize = stream.attributeSize;
  std::string lines;
  p.log = &lines;
  Growth growth;
  for (size_t i = 0; i < stream.calls.size(); ++i) {
    if (!alone && avoided(p, stream, stream.calls[i].op)) continue;
    growth.look(p, stream.calls[i].op);
    lines.append("  ").append(std::to_string(i)).append(": ").append(stream.calls[i].op->name);
    if (p.insideBegin && !isOf(endCalls(), stream.calls[i].op))
      p.vertexWanted = !makesVertex(stream.calls[i].op);
    p.start(i, stream.calls[i].seed, stream.weird);
    stream.calls[i].op->run(p);
    lines += "\n";
  }
  return lines;
}

}  // namespace gluray::fuzz
