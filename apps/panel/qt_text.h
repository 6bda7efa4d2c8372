// Text for Qt. Any thread.
#pragma once
#include <QString>
#include <string_view>

namespace gluray::panel {

inline QString qtText(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace gluray::panel
