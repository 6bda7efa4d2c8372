// gluray-panel: shows every program that runs under GLuRay, and changes their settings.
#include "control/runtime_directory.h"
#include "main_window.h"
#include "model/controls.h"
#include "model/finish_changes.h"
#include "model/hub_thread.h"
#include "wake/wake.h"

#include <QApplication>
#include <QCommandLineParser>
#include <cstdio>
#include <cstring>

namespace {

/// One line on standard error instead of Qt's abort. False: there is no display that the panel could use.
bool displayIsThere(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (!std::strcmp(argv[i], "-platform") || !std::strcmp(argv[i], "-display")) return true;
  if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY"))
    return true;
  const QByteArray display = qgetenv("DISPLAY");
  if (!display.isEmpty() && gluray::canReach(display.toStdString())) return true;
  const char* const why = display.isEmpty() ? "no display: DISPLAY is not set" : "no display can be reached";
  std::fprintf(stderr, "gluray-panel: %s%s; use ssh -X, or gluray list and gluray set, which need none\n",
               why, display.isEmpty() ? "" : (" at " + display).constData());
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gluray;
  if (!displayIsThere(argc, argv)) return 1;
  QApplication application(argc, argv);
  QApplication::setApplicationName("gluray-panel");
  QApplication::setApplicationVersion(GLURAY_VERSION);
  QCommandLineParser parser;
  parser.setApplicationDescription("Shows every program that runs under GLuRay, and changes their settings.");
  parser.addHelpOption();
  parser.addVersionOption();
  const QCommandLineOption hub("hub", "Connects to the hub of another machine.", "HOST:PORT"),
      key("key", "The key file for --hub.", "FILE");
  parser.addOption(hub);
  parser.addOption(key);
  parser.process(application);
  if (!parser.positionalArguments().empty()) {
    std::fprintf(stderr, "gluray-panel: %s was not expected; see gluray-panel --help\n",
                 qPrintable(parser.positionalArguments()[0]));
    return 2;
  }
  panel::HubThread thread(
      {control::runtimeDirectory(), parser.value(hub).toStdString(), parser.value(key).toStdString()},
      wakeWindow);
  panel::Controls controls([&](nlohmann::json message) { thread.send(std::move(message)); });
  QObject::connect(&thread, &panel::HubThread::connected, &controls, &panel::Controls::connected);
  QObject::connect(&thread, &panel::HubThread::received, &controls, &panel::Controls::receiveMessage);
  QObject::connect(&thread, &panel::HubThread::lost, &controls, &panel::Controls::disconnected);
  panel::MainWindow window(controls);
  window.show();
  thread.start();
  const int code = QApplication::exec();
  panel::finishChanges(controls);  // the connection ends with the thread, and what is left of batches with it
  return code;
}
