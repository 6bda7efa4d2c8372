// For tests: brings settings into view, and keeps the panel's memory out of the user's folder.
#pragma once
#include "pages/settings_page.h"
#include "panel_memory.h"

#include <QTabWidget>
#include <QTemporaryDir>
#include <QToolButton>

namespace gluray::panel {

/// Opens the page of a setting's editor.
inline SettingsPage& openPage(QWidget& editor) {
  SettingsPage* page = nullptr;
  for (QWidget* at = &editor; at; at = at->parentWidget()) {
    if (!page) page = qobject_cast<SettingsPage*>(at);
    if (auto* tabs = qobject_cast<QTabWidget*>(at)) tabs->setCurrentWidget(page);
  }
  return *page;
}

/// Opens the page of a setting's editor and, if it has one, presses its button "More".
inline void reveal(QWidget& editor) {
  auto* more = openPage(editor).findChild<QToolButton*>("more");
  if (more && !more->isChecked()) more->click();
}

/// While it exists, the panel's memory is a file of its own, empty at first.
class OwnMemory {
 public:
  OwnMemory() { QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path()); }

 private:
  QTemporaryDir folder_;
};

}  // namespace gluray::panel
