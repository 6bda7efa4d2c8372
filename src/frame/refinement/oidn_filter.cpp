#include "frame/refinement/oidn_filter.h"

#include "render/resolve/feature_pixels.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace gluray::frame {
namespace {

/// What light is divided by: 0 where a pixel shows no surface.
glm::vec3 divisorOf(const AuxiliaryFeatures& features, size_t at) {
  return features.distance[at] > 0 ? render::unpackReflectance(features.reflectance[at]) : glm::vec3(0);
}

/// Input images, three floats a pixel.
struct OidnImages {
  std::vector<float> light, albedo, normal;
  OidnImages(const Refinement& r, size_t first, size_t pixels)
      : light(3 * pixels, 1), albedo(3 * pixels, 1), normal(3 * pixels) {
    for (size_t i = 0; i < pixels; ++i) {
      const size_t at = first + i;
      const glm::vec3 divisor = divisorOf(r.features, at);
      if (!(divisor.x > 0)) continue;
      for (size_t c = 0; c < 3; ++c) {
        const float value = r.mean()[4 * at + c];
        light[3 * i + c] = value > 0 ? value / divisor[static_cast<int>(c)] : 0;
      }
      const glm::vec2 n = render::unpackNormal2(r.features.normal[at]);
      normal[3 * i] = n.x, normal[3 * i + 1] = n.y;
      normal[3 * i + 2] = std::sqrt(std::max(1 - glm::dot(n, n), 0.0f));
    }
  }
};

struct Release {
  const OidnLibrary& library;
  void operator()(OidnLibrary::Device device) const { library.releaseDevice(device); }
  void operator()(OidnLibrary::Filter filter) const { library.releaseFilter(filter); }
};
template <class Handle>
using Held = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

/// False with a reason if a call has failed.
bool isWell(const OidnLibrary& library, OidnLibrary::Device device, std::string& why) {
  const char* message = nullptr;
  if (library.deviceError(device, &message) == 0) return true;
  why = std::string("Open Image Denoise fails: ") + (message ? message : "it does not say why");
  return false;
}

bool execute(const OidnLibrary& library, OidnLibrary::Device device, OidnImages& in, size_t width,
             size_t height, float* out, std::string& why) {
  const Held<OidnLibrary::Filter> filter(library.newFilter(device, "RT"), Release{library});
  if (!filter) return isWell(library, device, why), false;
  const auto give = [&](const char* name, float* pixels) {
    library.setImage(filter.get(), name, pixels, OidnLibrary::kFloat3, width, height, 0, 0, 0);
  };
  give("color", in.light.data()), give("albedo", in.albedo.data()), give("normal", in.normal.data());
  give("output", out);
  library.setFilterBool(filter.get(), "hdr", true);
  library.setFilterBool(filter.get(), "cleanAux", true);  // auxiliary features have no noise
  library.commitFilter(filter.get());
  library.executeFilter(filter.get());
  return isWell(library, device, why);
}

}  // namespace

bool smoothByOidn(const OidnLibrary& library, const Refinement& refinement, int threads, const Image& image,
                  size_t first, std::vector<float>& out, std::string& why) {
  const auto width = static_cast<size_t>(image.width), height = static_cast<size_t>(image.height);
  OidnImages in(refinement, first, width * height);
  out.resize(3 * width * height);
  why = "Open Image Denoise has no device";
  const Held<OidnLibrary::Device> device(library.newDevice(OidnLibrary::kCpu), Release{library});
  if (!device) return isWell(library, nullptr, why), false;
  if (threads > 0) library.setDeviceInt(device.get(), "numThreads", threads);
  library.setDeviceBool(device.get(), "setAffinity", false);  // the threads are the host's
  library.commitDevice(device.get());
  if (!isWell(library, device.get(), why)) return false;
  if (!execute(library, device.get(), in, width, height, out.data(), why)) return false;
  for (size_t i = 0; i < out.size(); ++i)
    out[i] *= divisorOf(refinement.features, first + i / 3)[static_cast<int>(i % 3)];
  return true;
}

}  // namespace gluray::frame
