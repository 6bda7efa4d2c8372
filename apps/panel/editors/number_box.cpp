#include "editors/number_box.h"

#include "qt_text.h"

#include <QLineEdit>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::panel {
namespace {

constexpr int kDigits = 60;  // behind the point: the box rounds to them, so more than any value has
constexpr int kShown = 6;    // significant ones
constexpr double kLargest = 1e30;

}  // namespace

NumberBox::NumberBox(const Row& row, QWidget* parent)
    : QDoubleSpinBox(parent), whole_(row.type == Type::integer) {
  setDecimals(whole_ ? 0 : kDigits);
  setRange(row.ranged ? row.least : -kLargest, row.ranged ? row.most : kLargest);
  setKeyboardTracking(false);  // a number counts when it is complete
  connect(this, &QDoubleSpinBox::editingFinished, this, [this] { lineEdit()->setModified(false); });
  setFocusPolicy(Qt::StrongFocus);
  if (!row.unit.empty()) setSuffix(" " + qtText(row.unit));
  setMinimumWidth(fontMetrics().horizontalAdvance("-0.000000000 scene diagonals"));
  if (!row.leastMeans.empty()) setToolTip(textFromValue(row.least) + ": " + qtText(row.leastMeans));
}

QString NumberBox::textFromValue(double value) const {
  return QString::number(value, 'g', whole_ ? 10 : kShown);
}

double NumberBox::valueFromText(const QString& text) const {
  QString number = text;
  if (!suffix().isEmpty() && number.endsWith(suffix())) number.chop(suffix().size());
  // What the box shows has fewer digits than its value.
  return text == textFromValue(value()) + suffix() ? value() : number.trimmed().toDouble();
}

bool NumberBox::typing() const { return hasFocus() && lineEdit()->isModified(); }

QValidator::State NumberBox::validate(QString& text, int&) const {
  text.replace(',', '.');  // numbers are written as in files
  QString number = text;
  if (!suffix().isEmpty() && number.endsWith(suffix())) number.chop(suffix().size());
  number = number.trimmed();
  bool right = false;
  const double value = number.toDouble(&right);
  if (right)
    return value >= minimum() && value <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
  for (const QChar c : number)
    if (!c.isDigit() && !QString("+-.eE").contains(c)) return QValidator::Invalid;
  return QValidator::Intermediate;
}

void NumberBox::stepBy(int steps) {
  if (whole_) return QDoubleSpinBox::stepBy(steps);
  // A twentieth of the number, rounded to a power of ten times 1, 2 or 5.
  const double size = std::max(std::abs(value()), maximum() < 100 ? (maximum() - minimum()) / 10 : 0.1) / 20;
  const double power = std::pow(10.0, std::floor(std::log10(size)));
  const double unit = size / power >= 5 ? 5 * power : size / power >= 2 ? 2 * power : power;
  setValue(std::clamp((std::round(value() / unit) + steps) * unit, minimum(), maximum()));
}

void NumberBox::wheelEvent(QWheelEvent* event) {
  hasFocus() ? QDoubleSpinBox::wheelEvent(event) : event->ignore();  // the page scrolls
}

}  // namespace gluray::panel
