#include "pages/light/light_panel.h"

#include "pages/light/light_list.h"
#include "pages/light/light_sphere.h"

#include <QHBoxLayout>

namespace gluray::panel {

LightPanel::LightPanel(Controls& controls, QWidget* parent)
    : QGroupBox(tr("Key light and all active lights"), parent), sphere_(new LightSphere(controls, this)) {
  auto* layout = new QHBoxLayout(this);
  layout->addWidget(sphere_);
  layout->addWidget(new LightList(controls, this), 1);
  connect(sphere_, &LightSphere::said, this, &LightPanel::said);
}

void LightPanel::update() { sphere_->update(); }

}  // namespace gluray::panel
