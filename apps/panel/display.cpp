#include "display.h"

#include "wake/wake.h"

#include <QByteArray>
#include <QtGlobal>
#include <cstdio>
#include <cstring>

namespace gluray::panel {

bool displayIsThere(int argc, char** argv, const char* program, const char* others) {
  for (int i = 1; i < argc; ++i)
    if (!std::strcmp(argv[i], "-platform") || !std::strcmp(argv[i], "-display")) return true;
  if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY"))
    return true;
  const QByteArray display = qgetenv("DISPLAY");
  if (!display.isEmpty() && gluray::canReach(display.toStdString())) return true;
  const char* const why = display.isEmpty() ? "no display: DISPLAY is not set" : "no display can be reached";
  std::fprintf(stderr, "%s: %s%s; use ssh -X, or %s\n", program, why,
               display.isEmpty() ? "" : (" at " + display).constData(), others);
  return false;
}

}  // namespace gluray::panel
