#include "scene/failure.h"

#include <new>
#include <system_error>

namespace gluray::scene {

Loss lossOf(const std::exception& failure) noexcept {
  if (const auto* known = dynamic_cast<const Failure*>(&failure)) return known->loss;
  if (dynamic_cast<const std::bad_alloc*>(&failure)) return Loss::frames;
  const auto* system = dynamic_cast<const std::system_error*>(&failure);
  const bool lacks = system && (system->code() == std::errc::resource_unavailable_try_again ||
                                system->code() == std::errc::not_enough_memory);
  return lacks ? Loss::frames : Loss::tracing;
}

}  // namespace gluray::scene
