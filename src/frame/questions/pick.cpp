#include "frame/questions/pick.h"

#include "settings/rows.h"

#include <cmath>
#include <stdexcept>
#include <variant>

namespace gluray::frame {
namespace {

/// These settings without those that change images, except what rules say of objects.
Settings plainSettings(const Settings& settings) {
  Session plain, built;
  plain.settings = settings;
  for (const Row& row : settingRows())
    if (row.changes == Changes::image && !row.name.starts_with("material."))
      std::visit([&](auto* value) { *value = *std::get<decltype(value)>(row.place(built)); },
                 row.place(plain));
  return plain.settings;
}

/// The snapshot's pixel at `at` alone, with its surfaces opaque.
scene::Snapshot pixelOf(const scene::Snapshot& snapshot, const glm::ivec2& at) {
  scene::Snapshot pixel = snapshot;
  pixel.region = {at.x, at.y, 1, 1};
  pixel.samples = 1;
  pixel.samplePositions = {glm::vec2(0.5f)};
  pixel.layers.reset(), pixel.secondaryScene.reset(), pixel.backdrop.reset();
  pixel.ground = scene::GroundUse::none;
  pixel.wideColors = true;
  pixel.settings = plainSettings(snapshot.settings);
  return pixel;
}

bool contains(const scene::Region& region, const glm::ivec2& at) {
  return at.x >= region.x && at.y >= region.y && at.x < region.x + region.width &&
         at.y < region.y + region.height;
}

}  // namespace

std::optional<Picked> pick(Renderer& renderer, const scene::Snapshot& snapshot, const glm::dvec2& position) {
  const glm::ivec2 at(glm::floor(position));
  if (!contains(snapshot.region, at) || snapshot.instances.empty()) return std::nullopt;
  scene::Snapshot pixel = pixelOf(snapshot, at);
  Picked picked;
  using Mode = scene::LightSampling::Mode;
  for (const Mode mode : {Mode::points, Mode::surfaces}) {
    pixel.lightSampling = {mode};
    Image image;
    scene::TraceCost cost;
    std::string error;
    if (!renderer.render(pixel, image, cost, error)) throw std::runtime_error(error);
    const std::vector<float>& found = image.wideColor;
    if (image.depth.size() != 1 || image.depth[0] == Image::kMiss || found.size() < 4) return std::nullopt;
    picked.instance = static_cast<size_t>(std::lround(found[3])) - 1;
    if (picked.instance >= snapshot.instances.size()) return std::nullopt;
    picked.depth = image.depth[0];
    (mode == Mode::points ? picked.point : picked.normal) = glm::dvec3(found[0], found[1], found[2]);
  }
  return picked;
}

}  // namespace gluray::frame
