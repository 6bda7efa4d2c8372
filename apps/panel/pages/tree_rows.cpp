#include "pages/tree_rows.h"

#include <QSignalBlocker>
#include <QTreeWidget>

namespace gluray::panel {

void setRows(QTreeWidget& tree, const std::vector<QStringList>& rows) {
  const QSignalBlocker quiet(&tree);
  const bool had = tree.currentItem();
  const QString current = had ? tree.currentItem()->text(0) : QString();
  const bool selected = had && tree.currentItem()->isSelected();
  const int count = static_cast<int>(rows.size());
  while (tree.topLevelItemCount() > count) delete tree.takeTopLevelItem(tree.topLevelItemCount() - 1);
  while (tree.topLevelItemCount() < count) tree.addTopLevelItem(new QTreeWidgetItem);
  QTreeWidgetItem* again = nullptr;
  for (int i = 0; i < count; ++i) {
    QTreeWidgetItem* item = tree.topLevelItem(i);
    const QStringList& texts = rows[static_cast<size_t>(i)];
    for (int column = 0; column < tree.columnCount(); ++column)
      if (const QString text = texts.value(column); item->text(column) != text) item->setText(column, text);
    for (int column = 1; column < tree.columnCount(); ++column)
      if (const int alignment = tree.headerItem()->textAlignment(column))
        item->setTextAlignment(column, Qt::Alignment(alignment));
    if (had && !again && texts.value(0) == current) again = item;
  }
  if (!had || again == tree.currentItem()) return;
  tree.setCurrentItem(again);
  if (again) again->setSelected(selected);
}

}  // namespace gluray::panel
