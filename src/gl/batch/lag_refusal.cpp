#include "gl/batch/lag_refusal.h"

#include <array>
#include <cstddef>

namespace gluray::gl {

std::string_view describe(LagRefusal refusal) {
  constexpr std::array<std::string_view, kLagRefusals> kWords = {
      "shown later",
      "no draw was pending at the swap",
      "the pending draws were not for a plain back buffer",
      "nothing had changed",
      "the real OpenGL drew it, or it was measured",
      "a query, layers or other contexts",
      "frames did not follow each other",
      "the window's content cannot be shown without the program",
      "no thread or no memory"};
  return kWords.at(static_cast<size_t>(refusal));
}

}  // namespace gluray::gl
