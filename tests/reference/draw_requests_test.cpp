// What Draws asks a draw, in which order, and what becomes of it: for each answer, which of its acts follow.
#include "gl/draws/draws.h"
#include "scene/failure.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <new>
#include <string>
#include <utility>
#include <vector>

namespace gluray::test {
namespace {

using gl::Fate, gl::Reason;

/// Answers as it is told, and writes down what it was asked.
class ScriptedDraw final : public gl::DrawRequest {
 public:
  Reason state = Reason::traced, surface = Reason::traced, join = Reason::traced;
  bool replaced = false, culled = false;
  enum class Thrown { nothing, untraceable, memory } thrown = Thrown::nothing;
  std::string asked;
  Reason met = Reason::traced;

  Reason classifyState() override { return asked += "state ", state; }
  gl::KnownMesh mesh() override {
    asked += "mesh ";
    if (thrown == Thrown::untraceable) throw scene::Untraceable("a mesh that rays cannot meet");
    if (thrown == Thrown::memory) throw std::bad_alloc();
    return {};
  }
  Reason classifyMesh(const gl::KnownMesh&) override { return asked += "surface ", surface; }
  Reason trace(const gl::KnownMesh&) override { return asked += "trace ", join; }
  bool replace(Reason) override { return asked += "replace ", replaced; }
  void meetPasses(gl::PrimitiveClass, Reason reason) override { asked += "passes ", met = reason; }
  Load load() override {
    asked += "load ";
    return {gl::DrawPath::arrays, gl::PrimitiveClass::surfaces, 7};
  }
  Fate make() override { return asked += "make", culled ? Fate::culled : Fate::rasterised; }
};

struct Expected {
  const char* name;
  ScriptedDraw draw;
  std::string asked;
  Fate fate;
  Reason counted = Reason::traced;  // the reason for which it is rasterised; traced: it is not
};

std::vector<Expected> expectedDraws() {
  const std::string rasterised = "replace load passes make";
  std::vector<Expected> all;
  const auto add = [&](const char* name, std::string asked, Fate fate, Reason counted) -> ScriptedDraw& {
    all.push_back({name, {}, std::move(asked), fate, counted});
    return all.back().draw;
  };
  add("traced", "state mesh surface trace ", Fate::traced, Reason::traced);
  add("state", "state " + rasterised, Fate::rasterised, Reason::points).state = Reason::points;
  add("surface", "state mesh surface " + rasterised, Fate::rasterised, Reason::flat).surface = Reason::flat;
  add("join", "state mesh surface trace " + rasterised, Fate::rasterised, Reason::programPass).join =
      Reason::programPass;
  ScriptedDraw& culled = add("culled", "state " + rasterised, Fate::culled, Reason::program);
  culled.state = Reason::program, culled.culled = true;
  ScriptedDraw& replaced = add("replaced", "state replace ", Fate::replaced, Reason::traced);
  replaced.state = Reason::programPass, replaced.replaced = true;
  add("untraceable", "state mesh " + rasterised, Fate::rasterised, Reason::untraceable).thrown =
      ScriptedDraw::Thrown::untraceable;
  add("memory", "state mesh " + rasterised, Fate::rasterised, Reason::shortage).thrown =
      ScriptedDraw::Thrown::memory;
  return all;
}

TEST(DrawRequests, AreAskedInOrderAndActedUponOnce) {
  for (Expected& row : expectedDraws()) {
    SCOPED_TRACE(row.name);
    const TracedContext context;
    const gl::Statistics& counts = context.context().counts.statistics;
    EXPECT_EQ(gl::t_thread.context->draws.submit(row.draw), row.fate);
    EXPECT_EQ(row.draw.asked, row.asked);
    EXPECT_EQ(row.draw.met, row.fate == Fate::replaced ? Reason::traced : row.counted);
    const bool rasterised = row.counted != Reason::traced;
    EXPECT_EQ(counts.drawsRasterised, rasterised ? 1u : 0u);
    EXPECT_EQ(counts.trianglesRasterised, rasterised ? 7u : 0u);
    if (rasterised) { EXPECT_EQ(counts.rasterisedBecause[static_cast<size_t>(row.counted)], 1u); }
  }
}

TEST(DrawRequests, ThatCannotBeTracedCostThemselvesAlone) {
  const TracedContext context;
  ScriptedDraw failing, next;
  failing.thrown = ScriptedDraw::Thrown::untraceable;
  EXPECT_EQ(gl::t_thread.context->draws.submit(failing), Fate::rasterised);
  EXPECT_FALSE(context.context().failsafe.aside());
  EXPECT_EQ(gl::t_thread.context->draws.submit(next), Fate::traced);
}

}  // namespace
}  // namespace gluray::test
