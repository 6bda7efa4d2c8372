// Every setting that changes images changes one, and leaves nothing behind when it is set back: not a bit
// of the image, no acceleration structure.
#include "scenes/stage.h"
#include "settings/live/settings_source.h"
#include "settings/values.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gluray::test {
namespace {

using scenes::Gl;
using Values = std::vector<std::pair<std::string, std::string>>;

constexpr int kEverySettingSize = 48;

void tiltedQuad(Gl gl, float z, float tilt, const scenes::Color& color) {
  gl.Color4f(color[0], color[1], color[2], color[3]);
  gl.Begin(GL_QUADS);
  gl.Normal3f(0, 0, 1);
  gl.Vertex3f(-1, -1, z), gl.Vertex3f(1, -1, z + tilt), gl.Vertex3f(1, 1, z + tilt), gl.Vertex3f(-1, 1, z);
  gl.End();
}

/// A wall with a ball, a line and a point before it, under two translucent sheets that are drawn in the wrong
/// order, all turned against the viewer.
DrawnImage nextFrame(TracedContext& context) {
  Gl gl = context.gl();
  scenes::begin(gl, kEverySettingSize, kEverySettingSize);
  scenes::camera(gl, kEverySettingSize, kEverySettingSize);
  scenes::keyLight(gl);
  scenes::light(gl, GL_LIGHT0, GL_AMBIENT, {0.2f, 0.2f, 0.2f, 1});
  gl.Rotatef(20, 1, 1, 0);
  gl.Enable(GL_COLOR_MATERIAL);
  tiltedQuad(gl, -0.8f, 0.1f, {0.8f, 0.7f, 0.6f, 1});
  gl.Color4f(0.9f, 0.5f, 0.3f, 1);
  scenes::sendAt(gl, scenes::sphere(12, 16), -0.3f, 0, -0.2f, 0.5f);
  gl.Disable(GL_LIGHTING);
  gl.LineWidth(3), gl.PointSize(5);
  gl.Begin(GL_LINES), gl.Vertex3f(-0.9f, -0.8f, 0), gl.Vertex3f(0.9f, -0.6f, 0), gl.End();
  gl.Begin(GL_POINTS), gl.Vertex3f(0.6f, 0.7f, 0), gl.End();
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.DepthMask(GL_FALSE);
  tiltedQuad(gl, 0.6f, 0, {0.2f, 0.9f, 0.3f, 0.4f});
  tiltedQuad(gl, 0.3f, 0, {0.9f, 0.2f, 0.3f, 0.5f});
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  DrawnImage image = context.read();
  gl.Finish();  // the frame ends
  return image;
}

std::string written(const std::string& name, const std::string& text) {
  const std::filesystem::path folder = TEST_OUTPUT "/every_setting";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name) << text;
  return (folder / name).string();
}

/// A Radiance image of 2x1 pixels.
std::string sky(const std::string& name, const std::string& pixels) {
  return written(name, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + pixels);
}

struct Change {
  std::string name, value;
  Values base;  // what must be set for the setting to count
};

std::vector<Change> changes() {
  const Values ao{{"ao", "on"}}, shadows{{"shadows", "on"}}, sun{{"lights", "sun"}};
  const Values path{{"integrator", "path"}, {"path.samples", "4"}};
  const auto with = [](Values base, const Values& more) {
    base.insert(base.end(), more.begin(), more.end());
    return base;
  };
  const Values gradient = with(path, {{"environment", "gradient"}}),
               clear = with(path, {{"environment", "sky"}});
  const Values metal = with(path, {{"material", "metal"}}), glass = with(path, {{"material", "glass"}}),
               principled = with(path, {{"material", "principled"}}),
               emissive = with(path, {{"material", "emissive"}});
  const Values tubes{{"lines", "tubes"}}, spheres{{"points", "spheres"}}, lens{{"camera.aperture", "0.3"}},
      plane{{"ground", "plane"}};
  return {
      {"spp", "4", {}},
      {"ao", "on", {}},
      {"ao.samples", "4", ao},
      {"ao.radius", "0.5", ao},
      {"ao.distance", "0.3", ao},
      {"ao.strength", "0.5", ao},
      {"ao.interreflection", "on", ao},
      {"ao.on", "ambient", ao},
      {"shadows", "on", {}},
      {"shadows.samples", "4", shadows},
      {"shadows.size", "20", shadows},
      {"shadows.strength", "0.5", shadows},
      {"lights", "three-point", {}},
      {"lights.attached", "camera", sun},
      {"lights.up", "z", sun},
      {"lights.azimuth", "-60", sun},
      {"lights.elevation", "80", sun},
      {"lights.strength", "0.5", sun},
      {"lights.ratio", "6", sun},
      {"lights.file", written("lights.toml", "[[light]]\nkind = 'distant'\ndirection = [1, 0, -1]\n"), {}},
      {"integrator", "path", {}},
      {"path.samples", "2", path},
      {"path.depth", "1", path},
      {"path.clamp", "0.01", path},
      {"path.lights", "1.5", path},
      {"environment.strength", "1.5", path},
      {"environment", "gradient", path},
      {"environment.color", "1,0,0", path},
      {"environment.horizon", "1,0,0", gradient},
      {"environment.ground", "1,0,0", gradient},
      {"environment.up", "1,0,0", gradient},
      {"environment.rotation", "90", clear},
      {"environment.sun", "-1,0.5,0", clear},
      {"environment.turbidity", "8", clear},
      {"environment.file", sky("one.hdr", "\xFF\x01\x01\x80\x01\x01\xFF\x80"),
       with(path, {{"environment", "image"},
                   {"environment.file", sky("other.hdr", "\x01\xFF\x01\x80\x01\x01\xFF\x80")}})},
      {"material", "matte", path},
      {"material.metal", "Au", metal},
      {"material.roughness", "0.7", metal},
      {"material.ior", "1.1", glass},
      {"material.absorption", "3", glass},
      {"material.metallic", "1", principled},
      {"material.specular", "1", principled},
      {"material.transmission", "1", principled},
      {"material.coat", "1", principled},
      {"material.emission", "2", emissive},
      {"material.file", written("rules.toml", "[[rule]]\nobjects = [0]\nmaterial = 'mirror'\n"), path},
      {"material.objects", "1 mirror,2 mirror,3 mirror", path},
      {"lines", "tubes", {}},
      {"lines.width", "9", tubes},
      {"lines.radius", "0.1", tubes},
      {"points", "spheres", {}},
      {"points.size", "12", spheres},
      {"points.radius", "0.2", spheres},
      {"camera.aperture", "0.3", {}},
      {"camera.focus", "2", lens},
      {"camera.focus-x", "0.02", lens},
      {"camera.focus-y", "0.98", lens},
      {"camera.f-number", "0.05", {}},
      {"camera.film", "1", {{"camera.f-number", "1"}}},
      {"pixel-filter", "gauss", {{"spp", "4"}}},
      {"exposure", "-1", {}},
      {"auto-exposure", "on", {{"lights", "sky"}}},
      {"tone", "filmic", {}},
      {"look", "honest", {}},
      {"transparency", "ordered", {}},
      {"ground", "plane", {}},
      {"ground.color", "1,0,0", plane},
      {"ground.offset", "0.3", plane},
      {"ground.size", "0.2", plane},
      {"background", "color", {}},
      {"background.color", "1,0,0", {{"background", "color"}}},
      {"background.bottom", "1,0,0", {{"background", "gradient"}}},
  };
}

/// Settings of how images are made, of passes, of which these images have one, of ranks, of which there
/// is one, and of rasterised surfaces and of insets, of which there are none.
const std::set<std::string> kElsewhere = {
    "engine",
    "bvh",
    "shading",
    "quirks",
    "fps",
    "noise",
    "refine.passes",
    "refine.seconds",
    "refine.progress",
    "refine.idle",
    "refine.adaptive",
    "refine.offscreen",
    "denoise",
    "preset",
    "quality",
    "gather",
    "depth-first",
    "cull.draws",
    "cull.from",
    "cull.verify",
    "light.rasterised",
    "lights.insets",
};

/// One read is one pass: samples, not the wish for little noise, make the image.
Session plain() {
  Session session;
  session.settings = TracedContext::tracing();
  session.settings.noise = 0;
  return session;
}

Settings set(const Values& values) {
  Session session = plain();
  for (const auto& [name, value] : values) {
    const Row* row = findSetting(name);
    EXPECT_NE(row, nullptr) << name;
    if (row) { EXPECT_EQ(readValue(*row, value, session), "") << name; }
  }
  return session.settings;
}

TEST(EverySetting, IsInTheTable) {
  std::set<std::string> known = kElsewhere;
  for (const Change& change : changes()) known.insert(change.name);
  for (const Row& row : settingRows())
    if (row.applies == Applies::frame) { EXPECT_TRUE(known.count(std::string(row.name))) << row.name; }
}

TEST(EverySetting, ChangesTheImageAndLeavesNothingBehind) {
  SettingsSource source(plain().settings);
  TracedContext context({kEverySettingSize, kEverySettingSize}, {}, nullptr, nullptr, familiesOfTests(),
                        &source);
  const auto shown = [&](const Settings& settings) {
    source.store(settings);
    nextFrame(context);  // what is drawn later in a frame lights the next one
    return nextFrame(context);
  };
  const DrawnImage first = shown(plain().settings);
  const gl::Statistics& counts = context.context().counts.statistics;
  const uint64_t builds = counts.blasBuilds;
  EXPECT_GT(counts.drawsTraced, 0u);
  for (const Change& change : changes()) {
    Values changed = change.base;
    changed.emplace_back(change.name, change.value);
    const DrawnImage before = shown(set(change.base)), after = shown(set(changed));
    EXPECT_FALSE(before.colors == after.colors) << change.name << " changes nothing";
    EXPECT_TRUE(shown(set(change.base)) == before) << change.name << " leaves something behind";
    EXPECT_TRUE(shown(plain().settings) == first) << change.name << " leaves something behind";
  }
  // Lines and points become solids once for each of three widths, and a ground is made for two places.
  EXPECT_LE(counts.blasBuilds, builds + 2 * 3 + 2);
}

TEST(EverySetting, LightSwitchedAHundredTimesLeavesTheImage) {
  SettingsSource source(plain().settings);
  TracedContext context({kEverySettingSize, kEverySettingSize}, {}, nullptr, nullptr, familiesOfTests(),
                        &source);
  const DrawnImage off = nextFrame(context);
  const uint64_t builds = context.context().counts.statistics.blasBuilds;
  const Settings lit = set({{"ao", "on"}, {"shadows", "on"}, {"lights", "three-point"}});
  source.store(lit);
  const DrawnImage on = nextFrame(context);
  EXPECT_FALSE(on.colors == off.colors);
  for (int i = 0; i < 100; ++i) {
    source.store(i % 2 ? lit : plain().settings);
    ASSERT_TRUE(nextFrame(context) == (i % 2 ? on : off)) << i;
  }
  EXPECT_EQ(context.context().counts.statistics.blasBuilds, builds);
}

}  // namespace
}  // namespace gluray::test
