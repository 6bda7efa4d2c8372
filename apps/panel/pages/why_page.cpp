#include "pages/why_page.h"

#include "pages/tree_rows.h"

#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace gluray::panel {
namespace {

using nlohmann::json;

QString shareText(const json& state) {
  const auto traced = state.find("traced");
  if (traced == state.end() || !traced->is_number()) return WhyPage::tr("It draws nothing at the moment.");
  return WhyPage::tr("%1 % of the draws of the last second were traced.")
      .arg(100 * traced->get<double>(), 0, 'f', 1);
}

}  // namespace

WhyPage::WhyPage(QWidget* parent)
    : QWidget(parent),
      share_(new QLabel(this)),
      reasons_(new QTreeWidget(this)),
      warnings_(new QPlainTextEdit(this)) {
  share_->setWordWrap(true);
  reasons_->setHeaderLabels({tr("Left to the real OpenGL because"), tr("Draws")});
  reasons_->headerItem()->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  reasons_->setRootIsDecorated(false);
  reasons_->header()->setStretchLastSection(false);
  reasons_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  reasons_->setAccessibleName(tr("Reasons"));
  warnings_->setReadOnly(true);
  warnings_->setPlaceholderText(tr("No warnings."));
  warnings_->setAccessibleName(tr("Warnings"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(share_);
  layout->addWidget(reasons_, 2);
  layout->addWidget(warnings_, 1);
}

void WhyPage::show(const Program* program) {
  const json state = program ? program->state : json::object();
  share_->setText(program ? shareText(state) : tr("No program."));
  std::vector<QStringList> rows;
  if (const auto reasons = state.find("reasons"); reasons != state.end() && reasons->is_object())
    for (const auto& [reason, draws] : reasons->items())
      if (draws.is_number())
        rows.push_back({QString::fromStdString(reason), QString::number(draws.get<double>(), 'f', 0)});
  setRows(*reasons_, rows);
  QString lines;
  if (const auto warnings = state.find("warnings"); warnings != state.end() && warnings->is_array())
    for (const json& line : *warnings)
      if (line.is_string()) lines += QString::fromStdString(line.get<std::string>()) + "\n";
  if (lines != warnings_->toPlainText()) warnings_->setPlainText(lines);
}

}  // namespace gluray::panel
