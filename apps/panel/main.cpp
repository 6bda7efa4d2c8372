// gluray-panel: shows every program that runs under GLuRay, and changes their settings; and a
// saved scene, for gluray view.
#include "control/runtime_directory.h"
#include "display.h"
#include "main_window.h"
#include "model/controls.h"
#include "model/finish_changes.h"
#include "model/hub_thread.h"
#include "view/run_view.h"
#include "wake/wake.h"

#include <QApplication>
#include <QCommandLineParser>
#include <cstdio>
#include <cstring>

int main(int argc, char** argv) {
  using namespace gluray;
  if (argc > 1 && !std::strcmp(argv[1], panel::kViewWord)) return panel::runView(argc, argv);
  if (!panel::displayIsThere(argc, argv, "gluray-panel", "gluray list and gluray set, which need none"))
    return 1;
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
