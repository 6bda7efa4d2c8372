#include "editors/number_editor.h"

#include "control/messages/value.h"
#include "editors/number_box.h"
#include "qt_text.h"
#include "settings/values.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

namespace gluray::panel {
namespace {

constexpr double kMaxSliderRange = 1e7;  // ranges beyond it have no slider
constexpr double kLinearUpTo = 1e3;      // ratio of the range's ends
constexpr double kBelowUsual = 1e-2;     // times the usual value: where a logarithmic range from 0 begins

bool slides(const Row& row) {
  return row.ranged && row.most <= kMaxSliderRange && row.least >= -kMaxSliderRange;
}

double builtIn(const Row& row) {
  const nlohmann::json value = control::valueOf(row, printValue(row, Session{}));
  return value.is_number() ? value.get<double>() : 0;
}

/// Three digits are enough for what the hand can do.
double rounded(double value) {
  if (value == 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2);
  return std::round(value / unit) * unit;
}

}  // namespace

Scale::Scale(double least, double most, double usual) : first_(0), least_(least), most_(most) {
  if (least < 0 || most <= 0) return;
  const double first = least > 0 ? least : usual > 0 ? usual * kBelowUsual : most / kLinearUpTo;
  if (most / first > kLinearUpTo) first_ = first;
}

int Scale::positionOf(double value) const {
  if (value <= least_) return 0;
  double share;
  if (first_ > 0)  // position 0 is the least value, which may be 0
    share = value < first_
                ? 0
                : (1 + (kSteps - 1) * std::log(value / first_) / std::log(most_ / first_)) / kSteps;
  else
    share = (value - least_) / (most_ - least_);
  return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * kSteps));
}

double Scale::valueAt(int position) const {
  if (position <= 0) return least_;
  if (position >= kSteps) return most_;
  if (first_ > 0) return rounded(first_ * std::pow(most_ / first_, (position - 1.0) / (kSteps - 1)));
  return rounded(least_ + (most_ - least_) * position / kSteps);
}

NumberEditor::NumberEditor(const Row& row, QWidget* parent)
    : Editor(parent),
      whole_(row.type == Type::integer),
      scale_(row.least, row.most, builtIn(row)),
      box_(new NumberBox(row, this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  if (slides(row)) {
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setRange(0, Scale::kSteps);
    slider_->setPageStep(Scale::kSteps / 20);
    slider_->setFocusPolicy(Qt::StrongFocus);
    slider_->setMinimumWidth(80);
    slider_->setAccessibleName(qtText(row.title));
    layout->addWidget(slider_, 1);
    connect(slider_, &QSlider::valueChanged, this, [this](int position) { slid(position); });
    connect(slider_, &QSlider::sliderReleased, this, [this] { send(box_->value(), false); });
  }
  layout->addWidget(box_);
  setFocusProxy(box_);
  connect(box_, &QDoubleSpinBox::valueChanged, this, [this](double value) { typed(value); });
}

bool NumberEditor::busy() const { return box_->typing() || (slider_ && slider_->isSliderDown()); }

void NumberEditor::show(const nlohmann::json& value) {
  const QSignalBlocker quietBox(box_), quietSlider(slider_);
  const double number = value.is_number() ? value.get<double>() : 0;
  box_->setValue(number);
  if (slider_) slider_->setValue(scale_.positionOf(number));
}

void NumberEditor::typed(double value) {
  if (slider_) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(scale_.positionOf(value));
  }
  send(value, false);
}

void NumberEditor::slid(int position) {
  const QSignalBlocker quiet(box_);
  box_->setValue(scale_.valueAt(position));
  send(box_->value(), slider_->isSliderDown());
}

void NumberEditor::send(double value, bool more) {
  if (whole_)
    emit changed(std::llround(value), more);
  else
    emit changed(value, more);
}

}  // namespace gluray::panel
