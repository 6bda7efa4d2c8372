#include "saved/layers/picture_layers.h"

#include "saved/layers/cryptomatte.h"
#include "saved/shot/linear_color.h"
#include "settings/samples.h"

#include <algorithm>
#include <set>

namespace gluray::saved {
namespace {

constexpr size_t kStripPixels = size_t{1} << 19;   // traced together
constexpr size_t kStripSamples = size_t{1} << 24;  // whose surfaces are kept together

bool hasLens(const std::vector<Shot::Placed>& batches) {
  return std::any_of(batches.begin(), batches.end(),
                     [](const Shot::Placed& batch) { return hasOpenLens(batch.snapshot.settings); });
}

std::vector<float> idsOf(const std::vector<std::string>& names) {
  std::vector<float> ids;
  for (const std::string& name : names) ids.push_back(cryptoId(name));
  return ids;
}

std::vector<std::string> eachOnce(const std::vector<std::string>& names) {
  const std::set<std::string> all(names.begin(), names.end());
  return {all.begin(), all.end()};
}

SampleTracer::Wanted wantedOf(const std::vector<Layer>& layers) {
  const auto has = [&](Layer layer) {
    return std::find(layers.begin(), layers.end(), layer) != layers.end();
  };
  return {has(Layer::depth) || has(Layer::position), has(Layer::normal), has(Layer::albedo)};
}

}  // namespace

/// Rows of pixels, and what their samples have shown so far.
class PictureLayers::Strip {
 public:
  Strip(const PictureLayers& of, const scene::Region& region) : of_(of), region_(region) {
    const size_t pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
    shown_.assign(pixels, false);
    depth_.assign(pixels, kNoDepth);
    position_.assign(pixels, glm::vec3(0)), normal_.assign(pixels, glm::vec3(0));
    albedo_.assign(of.has(Layer::albedo) ? pixels : 0, glm::vec4(0));
  }
  size_t pixels() const { return shown_.size(); }
  const scene::Region& region() const { return region_; }

  /// Samples nearer to the pixels' centres come first.
  void add(const SurfaceSamples& samples, float weight) {
    const bool named = of_.has(Layer::object) || of_.has(Layer::material);
    if (named) surfaces_.insert(surfaces_.end(), samples.surface.begin(), samples.surface.end());
    weights_.push_back(weight), all_ += weight;
    for (size_t i = 0; i < pixels(); ++i) {
      if (samples.surface[i] == SurfaceSamples::kNone) continue;
      if (!albedo_.empty()) albedo_[i] += weight * glm::vec4(samples.albedo[i], 1);
      if (shown_[i]) continue;
      shown_[i] = true;
      if (!samples.depth.empty()) depth_[i] = samples.depth[i], position_[i] = samples.position[i];
      if (!samples.normal.empty()) normal_[i] = samples.normal[i];
    }
  }

  void write(size_t pixel, float* to) {
    for (const Layer layer : of_.layers_) {
      switch (layer) {
        case Layer::albedo: {
          const glm::vec4 light = lightOf(glm::max(albedo_[pixel] / all_, glm::vec4(0)));
          to = std::copy_n(&light.x, 3, to);
          break;
        }
        case Layer::normal: to = std::copy_n(&normal_[pixel].x, 3, to); break;
        case Layer::position: to = std::copy_n(&position_[pixel].x, 3, to); break;
        case Layer::depth: *to++ = depth_[pixel]; break;
        case Layer::object: to = writeRanks(pixel, of_.objects_, to); break;
        case Layer::material: to = writeRanks(pixel, of_.materials_, to); break;
      }
    }
  }

 private:
  float* writeRanks(size_t pixel, const std::vector<float>& ids, float* to) {
    ranks_.clear();
    for (size_t sample = 0; sample < weights_.size(); ++sample) {
      const uint32_t surface = surfaces_[sample * pixels() + pixel];
      ranks_.add(surface < ids.size() ? ids[surface] : 0, weights_[sample]);
    }
    ranks_.write(kRanks, to);
    return to + size_t{2} * kRanks;
  }

  const PictureLayers& of_;
  scene::Region region_;
  std::vector<bool> shown_;
  std::vector<float> depth_;
  std::vector<glm::vec3> position_, normal_;
  std::vector<glm::vec4> albedo_;   // sums; alpha: of what surfaces cover
  std::vector<uint32_t> surfaces_;  // all pixels of the first sample, then those of the second ...
  std::vector<float> weights_;      // of the samples
  float all_ = 0;                   // the sum of weights
  CoverageRanks ranks_;
};

PictureLayers::PictureLayers(const Shot& shot, frame::Renderer& renderer, const std::vector<Layer>& wanted)
    : shot_(shot),
      layers_(wanted),
      names_(surfaceNames(shot.placed())),
      samples_(pixelSamples(shot.placed())),
      tracer_(shot, renderer, wantedOf(wanted)) {
  if (wanted.empty()) return;
  if (!names_.numbered) leaveOut(Layer::object, "the program's objects are not known");
  for (const Layer layer : {Layer::object, Layer::material})
    if (hasLens(shot.placed())) leaveOut(layer, "samples through an open lens have no names");
  objects_ = idsOf(names_.objects), materials_ = idsOf(names_.materials);
  const auto& batches = shot.placed();
  if (std::any_of(batches.begin(), batches.end(), [](const auto& batch) { return batch.snapshot.layers; }))
    notes_.emplace_back("layers have opaque surfaces alone: translucent ones are left out there");
}

bool PictureLayers::has(Layer layer) const {
  return std::find(layers_.begin(), layers_.end(), layer) != layers_.end();
}

void PictureLayers::leaveOut(Layer layer, const std::string& why) {
  if (std::erase(layers_, layer) > 0)
    notes_.push_back("the layer " + std::string(nameOf(layer)) + " is left out: " + why);
}

size_t PictureLayers::channels() const {
  size_t count = 0;
  for (const Layer layer : layers_) count += channelsOf(layer).size();
  return count;
}

std::vector<std::pair<std::string, std::string>> PictureLayers::texts() const {
  std::vector<std::pair<std::string, std::string>> texts;
  if (has(Layer::object)) texts = cryptoTexts("CryptoObject", eachOnce(names_.objects));
  if (has(Layer::material))
    for (auto& text : cryptoTexts("CryptoMaterial", eachOnce(names_.materials)))
      texts.push_back(std::move(text));
  return texts;
}

void PictureLayers::write(int number, float* to, size_t stride) {
  if (layers_.empty()) return;
  const scene::Region band = shot_.regionOf(number);
  const size_t most = std::min(kStripPixels, kStripSamples / samples_.positions.size()),
               rows = std::max<size_t>(most / static_cast<size_t>(band.width) / 4 * 4, 4);
  SurfaceSamples samples;
  for (int done = 0; done < band.height; done += static_cast<int>(rows)) {
    const int count = std::min(static_cast<int>(rows), band.height - done);
    Strip strip(*this, {band.x, band.y + band.height - done - count, band.width, count});
    for (size_t sample = 0; sample < samples_.positions.size(); ++sample) {
      tracer_.trace(strip.region(), samples_.positions[sample], samples);
      strip.add(samples, samples_.weights[sample]);
    }
    for (int y = count - 1; y >= 0; --y)
      for (int x = 0; x < band.width; ++x, to += stride)
        strip.write(static_cast<size_t>(y) * static_cast<size_t>(band.width) + static_cast<size_t>(x), to);
  }
}

}  // namespace gluray::saved
