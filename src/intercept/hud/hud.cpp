#include "intercept/hud/hud.h"

#include "intercept/hud/text_image.h"

#include <GL/gl.h>

#include <cmath>
#include <cstdio>

namespace gluray::intercept {
namespace {

constexpr int kFromCorner = 8;     // pixels
constexpr double kEvery = 0.5;     // seconds between updates of the text
constexpr double kLongestGap = 1;  // seconds without a frame after which counting restarts

/// The value with three significant digits: "875 K".
std::string rounded(double value) {
  const char* unit = "";
  for (const char* larger : {" K", " M", " G"}) {
    if (value < 999.5) break;
    value /= 1000, unit = larger;
  }
  char text[32];
  std::snprintf(text, sizeof text, "%.*f%s",
                value < 9.995 && *unit   ? 2
                : value < 99.95 && *unit ? 1
                                         : 0,
                value, unit);
  return text;
}

std::string rate(const HudFigures& f) {
  char text[48];
  const double frames = static_cast<double>(f.frames);
  std::snprintf(text, sizeof text, "%.1f FPS  %.1f MS", frames / f.seconds, 1000 * f.seconds / frames);
  return text;
}

std::string share(const HudFigures& f) {
  // If a toolkit composes windows, the frames are the toolkit's and the triangles belong to another context.
  if (f.traced == 0 && f.framesPassedThrough > 0) return "BY OPENGL";
  const uint64_t all = f.traced + f.rasterised;
  if (all == 0) return "NOTHING DRAWN";
  // Never shows "100 %" if anything was not traced.
  const double percent = 100 * static_cast<double>(f.traced) / static_cast<double>(all);
  char text[32];
  std::snprintf(text, sizeof text, "%.0f %% TRACED", f.rasterised == 0 ? 100 : std::floor(percent));
  return text;
}

/// How far images are refined.
std::string light(const HudFigures& f) {
  char text[64];
  std::snprintf(text, sizeof text, "LIGHT %s PASSES, NOISE %.4f",
                rounded(static_cast<double>(f.lightPasses)).c_str(), f.lightNoise);
  return text;
}

}  // namespace

HudFigures between(const gl::Statistics& before, const gl::Statistics& now, double seconds) {
  HudFigures f;
  f.seconds = seconds;
  f.frames = now.frames - before.frames,
  f.framesPassedThrough = now.framesPassedThrough - before.framesPassedThrough;
  f.traced = now.trianglesTraced - before.trianglesTraced;
  f.rasterised = now.trianglesRasterised - before.trianglesRasterised;
  f.flushes = now.flushes - before.flushes, f.repeated = now.repeated - before.repeated;
  f.lightPasses = now.lightPasses - before.lightPasses, f.lightNoise = now.lightNoise;
  f.bvhBytes = now.bvhBytes, f.refining = now.blasRefining != 0;
  return f;
}

std::vector<std::string> hudLines(const HudFigures& f) {
  if (f.frames == 0 || f.seconds <= 0) return {"GLURAY"};
  const double triangles = static_cast<double>(f.traced + f.rasterised) / static_cast<double>(f.frames);
  std::vector<std::string> lines{rate(f), rounded(triangles) + " TRIANGLES, " + share(f)};
  if (f.bvhBytes) lines.push_back("BVH " + rounded(static_cast<double>(f.bvhBytes)) + "B");
  if (f.bvhBytes && f.refining) lines.back() += ", IMPROVING";
  if (f.bvhBytes && f.flushes && f.repeated == f.flushes) lines.back() += ", NOTHING CHANGED";
  if (f.lightNoise > 0) lines.push_back(light(f));
  return lines;
}

GLenum Hud::draw(const gl::Statistics& now, double seconds) {
  if (!since_ || seconds - lastSeconds_ > kLongestGap) {
    since_ = now, sinceSeconds_ = seconds;
  } else if (seconds - sinceSeconds_ >= kEvery) {
    lines_ = hudLines(between(*since_, now, seconds - sinceSeconds_));
    ++imageId_;
    since_ = now, sinceSeconds_ = seconds;
  }
  lastSeconds_ = seconds;
  if (lines_.empty()) lines_ = hudLines({}), ++imageId_;
  drawText(lines_, {}, image_);
  image_.x = image_.y = kFromCorner;
  present::PendingErrors pending;
  writeBack_.write(image_, {.imageId = imageId_, .over = GL_BACK}, pending);
  return pending.empty() ? GLenum{GL_NO_ERROR} : pending.front();
}

}  // namespace gluray::intercept
