// Asks for a film's folder, names and length, and makes it: images of a program's window, one after the
// other. GUI thread; the window stays usable meanwhile.
#pragma once
#include "model/film.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace gluray::panel {

class FilmDialog : public QDialog {
  Q_OBJECT

 public:
  FilmDialog(Controls& controls, QWidget* parent);

 protected:
  void done(int result) override;

 private:
  void makeFields(QFormLayout* form);
  void makeVaried(QFormLayout* form);
  void showRange();
  /// Empty, or what is wrong with what was typed.
  QString check() const;
  FilmPlan plan() const;
  void startOrStop();
  void begin();
  void showRunning();
  void ended(const QString& why);

  Controls& controls_;
  Film* film_ = nullptr;  // the one that is made
  QWidget* fields_ = nullptr;
  QLineEdit *folder_ = nullptr, *name_ = nullptr;
  QSpinBox* frames_ = nullptr;
  QComboBox* setting_ = nullptr;
  QDoubleSpinBox *from_ = nullptr, *to_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* message_ = nullptr;
  QPushButton *start_ = nullptr, *close_ = nullptr;
};

}  // namespace gluray::panel
