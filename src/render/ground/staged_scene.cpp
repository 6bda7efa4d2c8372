#include "render/ground/staged_scene.h"

#include "render/bsdf/material_rules.h"
#include "render/ground/ground_surface.h"
#include "scene/secondary_scene.h"

#include <memory>
#include <utility>

namespace gluray::render {

StagedScene::StagedScene(const scene::Snapshot& given) : given_(given) {
  if (given.ground != scene::GroundUse::none) addGround();
  const Settings::Material& material = given.settings.material;
  if (!material.file.empty() || !material.objects.empty()) hidden_ = hiddenByRules(snapshot());
}

void StagedScene::addGround() {
  const std::optional<GroundPlace> place = placeGround(given_);
  own_ = given_;
  if (!place) {
    own_->ground = scene::GroundUse::none;
    return;
  }
  GroundSurface ground = makeGround(given_, *place);
  if (own_->ground == scene::GroundUse::drawn) {
    ground.instance.shading = static_cast<uint32_t>(own_->shadings.size());
    own_->shadings.push_back(std::move(ground.shading));
    own_->instances.push_back(std::move(ground.instance));
    return;
  }
  auto around = given_.secondaryScene ? std::make_shared<scene::SecondaryScene>(*given_.secondaryScene)
                                      : std::make_shared<scene::SecondaryScene>();
  ground.instance.shading = static_cast<uint32_t>(around->shadings.size());
  around->shadings.push_back(std::move(ground.shading));
  around->instances.push_back(std::move(ground.instance));
  around->blended.push_back(0);
  own_->secondaryScene = std::move(around);
}

}  // namespace gluray::render
