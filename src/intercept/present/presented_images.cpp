#include "intercept/present/presented_images.h"

#include <exception>

namespace gluray::present {

const frame::ImageCache::CachedImage* PresentedImages::imageOf(const scene::Snapshot& snapshot,
                                                               gl::ImageWish wish,
                                                               std::optional<uint32_t> missColor,
                                                               gl::PresentResult& result, std::string& why) {
  frame::TracedImages::Result got = images.imageOf(
      snapshot, {wish.mayRepeat, missColor, wish.finished, wish.asShown, wish.anew, wish.averages});
  result.cost = got.cost;
  result.passes = got.passes;
  result.noise = got.noise;
  result.repeated = got.repeated;
  if (!got.cached) why = std::move(got.why);
  return got.cached;
}

const Features& PresentedImages::features(const gl::RealGl& real) {
  if (!features_) features_ = readFeatures(real);
  return *features_;
}

WriteBack& PresentedImages::writeBack(const gl::RealGl& real, WriteBack::Colors colors) {
  std::unique_ptr<WriteBack>& one = writeBacks_.at(static_cast<size_t>(colors));
  if (!one) one = std::make_unique<WriteBack>(real, colors);
  return *one;
}

bool PresentedImages::supported(const gl::RealGl& real, std::string& why) noexcept {
  try {
    return writeBack(real, WriteBack::Colors::bytes).ready(why);
  } catch (const std::exception& e) {
    why = e.what();
    return false;
  }
}

gl::SharedNames PresentedImages::takeNames() {
  gl::SharedNames all = samples.takeNames();
  for (const std::unique_ptr<WriteBack>& one : writeBacks_) {
    if (!one) continue;
    const gl::SharedNames names = one->takeNames();
    all.textures.insert(all.textures.end(), names.textures.begin(), names.textures.end());
    all.programs.insert(all.programs.end(), names.programs.begin(), names.programs.end());
  }
  return all;
}

void PresentedImages::forget() noexcept {
  // Do not delete names: they belong to the share group, whose other contexts may still exist, and this
  // context may not be current.
  for (std::unique_ptr<WriteBack>& one : writeBacks_) one.reset();
  samples = {};
  features_.reset();
}

}  // namespace gluray::present
