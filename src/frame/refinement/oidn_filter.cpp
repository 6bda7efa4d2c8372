#include "frame/refinement/oidn_filter.h"

#ifdef GLURAY_OIDN

#include "render/resolve/feature_pixels.h"

#include <OpenImageDenoise/oidn.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::frame {
namespace {

/// Three floats a pixel.
struct OidnImages {
  std::vector<float> color, albedo, normal;
  OidnImages(const Refinement& r, size_t first, size_t pixels)
      : color(3 * pixels), albedo(3 * pixels), normal(3 * pixels) {
    for (size_t i = 0; i < pixels; ++i) {
      const size_t at = first + i;
      for (size_t c = 0; c < 3; ++c) {
        const float value = r.mean()[4 * at + c];
        color[3 * i + c] = value > 0 ? std::min(value, 1.0f) : 0;
      }
      if (!(r.features.distance[at] > 0)) continue;
      const glm::vec3 reflectance = glm::min(render::unpackReflectance(r.features.reflectance[at]), 1.0f);
      const glm::vec2 n = render::unpackNormal2(r.features.normal[at]);
      const float z = std::sqrt(std::max(1 - glm::dot(n, n), 0.0f));
      std::copy_n(&reflectance.x, 3, &albedo[3 * i]);
      normal[3 * i] = n.x, normal[3 * i + 1] = n.y, normal[3 * i + 2] = z;
    }
  }
};

/// False with a reason if the device has failed.
bool isWell(oidn::DeviceRef& device, std::string& why) {
  const char* message = nullptr;
  if (device && device.getError(message) == oidn::Error::None) return true;
  why = message ? std::string("Open Image Denoise: ") + message : "Open Image Denoise has no device";
  return false;
}

}  // namespace

bool smoothByOidn(const Refinement& refinement, const Settings& settings, const Image& image, size_t first,
                  std::vector<float>& out, std::string& why) {
  const auto width = static_cast<size_t>(image.width), height = static_cast<size_t>(image.height);
  OidnImages in(refinement, first, width * height);
  out.resize(3 * width * height);
  oidn::DeviceRef device = oidn::newDevice(oidn::DeviceType::CPU);
  if (!device) return isWell(device, why);
  if (settings.threads > 0) device.set("numThreads", settings.threads);
  device.set("setAffinity", false);  // the threads are the host's
  device.commit();
  if (!isWell(device, why)) return false;
  oidn::FilterRef filter = device.newFilter("RT");
  const auto give = [&](const char* name, std::vector<float>& pixels) {
    filter.setImage(name, pixels.data(), oidn::Format::Float3, width, height);
  };
  if (!isWell(device, why)) return false;
  give("color", in.color), give("albedo", in.albedo), give("normal", in.normal), give("output", out);
  filter.set("hdr", false);
  filter.set("srgb", true);      // colours are encoded as displays show them
  filter.set("cleanAux", true);  // features have no noise
  filter.commit();
  filter.execute();
  return isWell(device, why);
}

}  // namespace gluray::frame

#else

namespace gluray::frame {

bool smoothByOidn(const Refinement&, const Settings&, const Image&, size_t, std::vector<float>&,
                  std::string& why) {
  why = "GLuRay is built without Open Image Denoise";
  return false;
}

}  // namespace gluray::frame

#endif
