#include "render/lights/make_environment.h"

#include "base/log.h"
#include "base/never_destroyed.h"
#include "render/lights/dome.h"
#include "render/lights/preetham.h"
#include "render/lights/sky_files.h"
#include "render/lights/sky_image.h"
#include "render/lights/studio.h"

#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>

namespace gluray::render {
namespace {

/// The last image that was read or computed.
class LastSky {
 public:
  /// `make` is called where `key` differs from the last one's. Null: it failed and there is no earlier one.
  template <class Make>
  std::shared_ptr<const SkyImage> get(const std::string& key, const Make& make) {
    const std::lock_guard lock(mutex_);
    if (key == key_) return sky_;
    key_ = key;  // also of one that fails: it is tried again when the file changes
    try {
      sky_ = std::make_shared<const SkyImage>(make());
    } catch (const std::exception& e) {
      log::once(log::Level::warning, "environment " + key,
                std::string("environment: ") + e.what() +
                    (sky_ ? "; the previous environment stays" : "; a constant environment is used"));
    }
    return sky_;
  }

 private:
  std::mutex mutex_;
  std::string key_;
  std::shared_ptr<const SkyImage> sky_;
};

LastSky& lastSky() {
  static NeverDestroyed<LastSky> last;
  return *last;
}

std::string text(const glm::vec3& v) {
  return std::to_string(v.x) + ',' + std::to_string(v.y) + ',' + std::to_string(v.z);
}

std::shared_ptr<const SkyImage> skyOf(const Settings& settings) {
  const auto& e = settings.environment;
  if (e.kind == EnvironmentKind::sky) {
    const std::string key = "sky " + text(e.sun) + ' ' + text(e.ground) + ' ' + std::to_string(e.turbidity);
    return lastSky().get(key, [&] { return preethamSky(e.sun, e.turbidity, e.ground); });
  }
  if (e.kind == EnvironmentKind::studio) return lastSky().get("studio", studio);
  std::error_code ignored;
  const auto time = std::filesystem::last_write_time(e.file, ignored).time_since_epoch().count();
  return lastSky().get("image " + e.file + ' ' + std::to_string(time), [&] {
    if (e.file.empty()) throw std::runtime_error("environment = image needs environment.file");
    try {
      return readSkyPixels(e.file);
    } catch (const std::bad_alloc&) {
      throw std::runtime_error(e.file + ": no memory for the image");
    } catch (const std::exception& why) { throw std::runtime_error(e.file + ": " + why.what()); }
  });
}

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

/// A rotation about y.
glm::mat3 aboutUp(float degrees) {
  const double angle = glm::radians(double{degrees}), c = std::cos(angle), s = std::sin(angle);
  return glm::mat3(glm::transpose(glm::dmat3(c, 0, s, 0, 1, 0, -s, 0, c)));
}

}  // namespace

glm::mat3 skyFromEye(const Settings& settings, const glm::dmat4& eyeFromWorld) {
  const auto& e = settings.environment;
  if (e.kind == EnvironmentKind::studio) return aboutUp(e.rotation);
  const glm::dmat3 linear(eyeFromWorld);
  const glm::dvec3 worldUp = unitOr(glm::dvec3(e.up), {0, 1, 0});
  // Azimuth 0 is along the world's x, or z where that is up.
  const glm::dvec3 worldFront = std::abs(worldUp.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 up = unitOr(linear * worldUp, {0, 1, 0}), front = linear * worldFront;
  const glm::dvec3 x =
      unitOr(front - glm::dot(front, up) * up, unitOr(glm::cross(up, {0.3, 0.5, 0.8}), {1, 0, 0}));
  const glm::dvec3 z = glm::cross(x, up);
  const double angle = glm::radians(double{e.rotation}), c = std::cos(angle), s = std::sin(angle);
  return glm::mat3(glm::transpose(glm::dmat3(c * x + s * z, up, c * z - s * x)));
}

std::shared_ptr<const Environment> makeEnvironment(const Settings& settings, const glm::dmat4& eyeFromWorld) {
  const auto& e = settings.environment;
  const glm::mat3 turn = skyFromEye(settings, eyeFromWorld);
  if (e.kind != EnvironmentKind::constant && e.kind != EnvironmentKind::gradient)
    if (auto image = skyOf(settings)) return std::make_shared<TurnedSky>(std::move(image), turn, e.strength);
  if (e.kind != EnvironmentKind::gradient) return std::make_shared<Dome>(e.strength * e.color);
  const glm::vec3 up = glm::transpose(turn)[1];
  return std::make_shared<Dome>(e.strength * e.ground, e.strength * e.horizon, e.strength * e.color, up);
}

}  // namespace gluray::render
