#include "view/run_view.h"

#include "display.h"
#include "view/view_window.h"

#include <QApplication>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

namespace gluray::panel {
namespace {

constexpr int kWords = 5;  // before the look

/// The words are those that the launcher has checked.
LookOptions lookOf(int argc, char** argv) {
  LookOptions look;
  for (int i = kWords; i + 1 < argc; i += 2) {
    const std::string_view option = argv[i];
    const std::string value = argv[i + 1];
    if (option == "--preset") look.preset = value;
    if (option == "--quality") look.quality = value;
    if (option == "--set")
      look.values.emplace_back(value.substr(0, value.find('=')), value.substr(value.find('=') + 1));
  }
  return look;
}

}  // namespace

int runView(int argc, char** argv) {
  if (argc < kWords) {
    std::fprintf(stderr, "gluray-panel: %s is for gluray view\n", kViewWord);
    return 2;
  }
  if (!displayIsThere(argc, argv, "gluray", "gluray render, which needs none")) return 1;
  std::unique_ptr<EngineView> view;
  try {
    view = std::make_unique<EngineView>(argv[2], argv[4]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "gluray: %s\n", e.what());
    return 1;
  }
  int count = 1;  // none of Qt's own options: a file may have any name
  QApplication application(count, argv);
  QApplication::setApplicationName("gluray-view");
  QApplication::setApplicationVersion(GLURAY_VERSION);
  ViewWindow window(std::move(view), QString::fromLocal8Bit(argv[4]), QString::fromLocal8Bit(argv[3]),
                    lookOf(argc, argv));
  QObject::connect(&window, &ViewWindow::saved, &window, [](const QString& command) {
    std::printf("%s\n", command.toLocal8Bit().constData());
    std::fflush(stdout);
  });
  window.show();
  return QApplication::exec();
}

}  // namespace gluray::panel
