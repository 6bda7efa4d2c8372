#include "pages/film/film_dialog.h"

#include "qt_text.h"
#include "settings/rows.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <utility>

namespace gluray::panel {
namespace {

constexpr int kMaxFrames = 100000;
constexpr int kUsualFrames = 60;
constexpr double kWidest = 1e9;  // of values
constexpr int kValueDigits = 4;

QDoubleSpinBox* newValueBox(const QString& name, const char* object, QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(object);
  box->setAccessibleName(name);
  return box;
}

bool isNumber(const Row& row) { return row.type == Type::integer || row.type == Type::real; }

}  // namespace

FilmDialog::FilmDialog(Controls& controls, QWidget* parent) : QDialog(parent), controls_(controls) {
  setWindowTitle(tr("Film"));
  fields_ = new QWidget(this);
  auto* form = new QFormLayout(fields_);
  form->setContentsMargins(0, 0, 0, 0);
  makeFields(form);
  makeVaried(form);
  progress_ = new QProgressBar(this);
  progress_->setAccessibleName(tr("Images that are saved"));
  progress_->setRange(0, 1);
  progress_->setValue(0);
  progress_->setFormat(tr("%v of %m"));
  progress_->hide();
  message_ = new QLabel(this);
  message_->setObjectName("film-message");
  message_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  start_ = new QPushButton(tr("&Start"), this);
  start_->setObjectName("film-start");
  start_->setDefault(true);
  close_ = new QPushButton(tr("&Close"), this);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(start_);
  buttons->addWidget(close_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(fields_);
  layout->addWidget(progress_);
  layout->addWidget(message_);
  layout->addStretch(1);
  layout->addLayout(buttons);
  setMinimumWidth(fontMetrics().averageCharWidth() * 64);
  connect(start_, &QPushButton::clicked, this, &FilmDialog::startOrStop);
  connect(close_, &QPushButton::clicked, this, &QDialog::reject);
}

void FilmDialog::makeFields(QFormLayout* form) {
  folder_ = new QLineEdit(QDir::homePath(), fields_);
  folder_->setObjectName("film-folder");
  auto* choose = new QPushButton(tr("C&hoose..."), fields_);
  choose->setAutoDefault(false);
  auto* line = new QHBoxLayout;
  line->addWidget(folder_, 1);
  line->addWidget(choose);
  form->addRow(tr("Fol&der"), line);
  static_cast<QLabel*>(form->labelForField(line))->setBuddy(folder_);
  folder_->setAccessibleName(tr("Folder"));
  connect(choose, &QPushButton::clicked, this, [this] {
    auto* dialog = new QFileDialog(this, tr("Folder of the film"), folder_->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    connect(dialog, &QFileDialog::fileSelected, folder_, &QLineEdit::setText);
    dialog->open();
  });
  name_ = new QLineEdit("film", fields_);
  name_->setObjectName("film-name");
  name_->setToolTip(tr("Images are NAME-0001.png, NAME-0002.png and so on"));
  form->addRow(tr("&Name"), name_);
  frames_ = new QSpinBox(fields_);
  frames_->setObjectName("film-frames");
  frames_->setRange(0, kMaxFrames);
  frames_->setSpecialValueText(tr("until it is stopped"));
  frames_->setValue(kUsualFrames);
  frames_->setToolTip(tr("0: until it is stopped"));
  form->addRow(tr("&Images"), frames_);
}

void FilmDialog::makeVaried(QFormLayout* form) {
  setting_ = new QComboBox(fields_);
  setting_->setObjectName("film-setting");
  setting_->addItem(tr("none"));
  for (const std::string_view group : settingGroups())
    for (const Row* row : rowsOfGroup(group)) {
      if (row->applies != Applies::frame || !isNumber(*row)) continue;
      setting_->addItem(qtText(row->title), qtText(row->name));
      setting_->setItemData(setting_->count() - 1, qtText(row->name), Qt::ToolTipRole);
    }
  setting_->setToolTip(tr("It varies over the film, and is restored at the end"));
  form->addRow(tr("S&etting that changes"), setting_);
  from_ = newValueBox(tr("First value"), "film-from", fields_);
  to_ = newValueBox(tr("Last value"), "film-to", fields_);
  form->addRow(tr("F&irst value"), from_);
  form->addRow(tr("&Last value"), to_);
  connect(setting_, &QComboBox::currentIndexChanged, this, &FilmDialog::showRange);
  showRange();
}

/// The boxes take what the setting takes, and begin with what it is.
void FilmDialog::showRange() {
  const std::string name = setting_->currentData().toString().toStdString();
  const Row* row = setting_->currentIndex() > 0 ? findSetting(name) : nullptr;
  const nlohmann::json value = row ? controls_.value(name).value : nlohmann::json();
  for (QDoubleSpinBox* box : {from_, to_}) {
    box->setEnabled(row);
    if (!row) continue;
    box->setDecimals(row->type == Type::integer ? 0 : kValueDigits);
    box->setRange(row->ranged ? row->least : -kWidest, row->ranged ? row->most : kWidest);
    box->setValue(value.is_number() ? value.get<double>() : 0);
  }
}

QString FilmDialog::check() const {
  if (!controls_.shown()) return tr("No program is chosen.");
  if (!QDir(folder_->text()).exists() || folder_->text().isEmpty())
    return tr("There is no folder %1.").arg(folder_->text());
  if (name_->text().isEmpty() || name_->text().contains('/')) return tr("Type a name without slashes.");
  if (setting_->currentIndex() > 0 && frames_->value() == 0)
    return tr("A varying setting needs a number of images.");
  return {};
}

FilmPlan FilmDialog::plan() const {
  FilmPlan plan;
  plan.folder = folder_->text(), plan.name = name_->text();
  plan.frames = frames_->value();
  if (setting_->currentIndex() == 0) return plan;
  plan.setting = setting_->currentData().toString().toStdString();
  plan.from = from_->value(), plan.to = to_->value();
  const Row* row = findSetting(plan.setting);
  plan.whole = row && row->type == Type::integer;
  return plan;
}

void FilmDialog::startOrStop() {
  if (film_) return film_->stop();
  const QString wrong = check();
  message_->setText(wrong);
  if (wrong.isEmpty()) begin();
}

void FilmDialog::begin() {
  film_ = new Film(controls_, plan(), this);
  progress_->setRange(0, frames_->value());  // 0 to 0: it shows that something is done
  progress_->setValue(0);
  connect(film_, &Film::progressed, this, [this](int saved) {
    progress_->setValue(saved);
    message_->setText(tr("%1 images are saved.").arg(saved));
  });
  connect(film_, &Film::finished, this, &FilmDialog::ended);
  showRunning();
  film_->start();
}

void FilmDialog::showRunning() {
  fields_->setEnabled(!film_);
  progress_->setVisible(film_);
  start_->setText(film_ ? tr("C&ancel") : tr("&Start"));
  start_->setToolTip(film_ ? tr("Saved images stay") : QString());
}

void FilmDialog::ended(const QString& why) {
  if (!film_) return;
  Film* film = std::exchange(film_, nullptr);
  const QString saved = tr("%1 images are saved in %2.").arg(film->saved()).arg(folder_->text());
  message_->setText(why.isEmpty() ? saved : tr("Stopped: %1. %2").arg(why, saved));
  film->deleteLater();
  showRunning();
}

void FilmDialog::done(int result) {
  if (film_) film_->stop();
  QDialog::done(result);
}

}  // namespace gluray::panel
