#include "cluster/program/frame_limit.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

namespace gluray::cluster {
namespace {

constexpr double kNotable = 0.2;  // share of the time from which waiting or unevenness is named

/// Of one rank, in seconds an image.
struct Spent {
  int rank = 0;
  double eye = 0, light = 0, scenes = 0, depths = 0, answers = 0;
  double work() const { return eye + light; }
  double waiting() const { return scenes + depths + answers; }
  double all() const { return work() + waiting(); }
};

/// Ranks that ended early, with less than half of the images, are left out.
std::vector<Spent> spentBy(std::span<const RankFigures> ranks) {
  std::vector<Spent> all;
  uint64_t most = 0;
  for (const RankFigures& r : ranks) most = std::max(most, r.images);
  for (const RankFigures& r : ranks) {
    if (r.images == 0 || r.images < most / 2) continue;
    const double each = 1 / static_cast<double>(r.images);
    all.push_back({r.rank, r.eyeSeconds * each, r.lightSeconds * each, r.scenesSeconds * each,
                   r.depthsSeconds * each, r.answersSeconds * each});
  }
  return all;
}

template <class Of>
double meanOf(const std::vector<Spent>& all, Of of) {
  double sum = 0;
  for (const Spent& one : all) sum += of(one);
  return sum / static_cast<double>(all.size());
}

std::string times(double ratio) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", ratio);
  return text;
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
  return text;
}

/// What the rank does beyond the average: light, or rays from the viewer.
std::string unevenness(const Spent& most, double eye, double light) {
  const bool isLight = most.light - light >= most.eye - eye;
  const double ratio = isLight ? most.light / light : most.eye / eye;
  return "rank " + std::to_string(most.rank) + (isLight ? " lit " : " traced rays from the viewer for ") +
         times(ratio) + " times the average: uneven " + (isLight ? "light" : "rays from the viewer");
}

std::string wait(const Spent& most) {
  const char* what = "scenes of other ranks";
  double seconds = most.scenes;
  for (const auto& [name, other] : {std::pair("depths of other ranks", most.depths),
                                    std::pair("answers of other ranks about light", most.answers)})
    if (other > seconds) what = name, seconds = other;
  return std::string("waiting for ") + what + ": " + percent(seconds / most.all()) + " of the time of rank " +
         std::to_string(most.rank);
}

}  // namespace

std::string limitOf(std::span<const RankFigures> ranks) {
  const std::vector<Spent> all = spentBy(ranks);
  if (all.empty() || meanOf(all, [](const Spent& s) { return s.work(); }) <= 0)
    return "not measured: no image had light across ranks";
  const double eye = meanOf(all, [](const Spent& s) { return s.eye; });
  const double light = meanOf(all, [](const Spent& s) { return s.light; });
  const Spent& hardest = *std::ranges::max_element(all, {}, &Spent::work);
  const Spent& idlest = *std::ranges::max_element(all, {}, &Spent::waiting);
  // Ranks wait for the one that works longest: that it works longer is the cause, their waiting its effect.
  const double beyond = hardest.work() - (eye + light);
  if (all.size() > 1 && beyond > kNotable * hardest.all()) return unevenness(hardest, eye, light);
  if (idlest.waiting() > kNotable * idlest.all()) return wait(idlest);
  const double share = light / (eye + light);
  return share >= 0.5 ? "light: " + percent(share) + " of the ranks' work"
                      : "rays from the viewer: " + percent(1 - share) + " of the ranks' work";
}

}  // namespace gluray::cluster
