#include "pages/objects/object_table.h"

#include <QLocale>
#include <algorithm>

namespace gluray::panel {
namespace {

/// "12 345".
QString grouped(int64_t number) {
  return QLocale(QLocale::English).toString(static_cast<qlonglong>(number)).replace(',', ' ');
}

QString columnText(const DrawnObject& object, ObjectColumn column) {
  switch (column) {
    case ObjectColumn::number: return QString::number(object.number);
    case ObjectColumn::color: return object.color.isValid() ? object.color.name() : ObjectTable::tr("varies");
    case ObjectColumn::shape: return object.shape;
    case ObjectColumn::triangles: return grouped(object.triangles);
    case ObjectColumn::material: return object.material;
    case ObjectColumn::hidden: return object.hidden.join(", ");
    default: return {};
  }
}

QVariant sortKey(const DrawnObject& object, ObjectColumn column) {
  if (column == ObjectColumn::number) return object.number;
  if (column == ObjectColumn::triangles) return static_cast<qlonglong>(object.triangles);
  return columnText(object, column);
}

bool isNumeric(ObjectColumn column) {
  return column == ObjectColumn::number || column == ObjectColumn::triangles;
}

}  // namespace

bool ObjectTable::setObjects(const std::vector<DrawnObject>& objects) {
  const bool same =
      std::equal(objects.begin(), objects.end(), objects_.begin(), objects_.end(),
                 [](const DrawnObject& a, const DrawnObject& b) { return a.number == b.number; });
  if (!same) {
    beginResetModel();
    objects_ = objects;
    endResetModel();
    return true;
  }
  int first = -1, last = -1;  // rows that change
  for (size_t i = 0; i < objects.size(); ++i) {
    if (objects[i] == objects_[i]) continue;
    objects_[i] = objects[i];
    last = static_cast<int>(i);
    if (first < 0) first = last;
  }
  if (first >= 0) emit dataChanged(index(first, 0), index(last, columnCount() - 1));
  return false;
}

int ObjectTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(objects_.size());
}

int ObjectTable::columnCount(const QModelIndex&) const { return static_cast<int>(ObjectColumn::count); }

QVariant ObjectTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const DrawnObject& one = object(index.row());
  const auto column = static_cast<ObjectColumn>(index.column());
  if (role == Qt::DisplayRole) return columnText(one, column);
  if (role == kSortRole) return sortKey(one, column);
  if (role == Qt::DecorationRole && column == ObjectColumn::color && one.color.isValid()) return one.color;
  if (role == Qt::TextAlignmentRole && isNumeric(column)) return int(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant ObjectTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const auto column = static_cast<ObjectColumn>(section);
  if (role == Qt::TextAlignmentRole)
    return int((isNumeric(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case ObjectColumn::number: return tr("Object");
    case ObjectColumn::color: return tr("Colour");
    case ObjectColumn::shape: return tr("Shape");
    case ObjectColumn::triangles: return tr("Triangles");
    case ObjectColumn::material: return tr("Material");
    case ObjectColumn::hidden: return tr("Hidden from");
    default: return {};
  }
}

void ObjectFilter::search(const QString& text) {
  words_ = text.split(' ', Qt::SkipEmptyParts);
  invalidateFilter();
}

bool ObjectFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  QString text;
  for (int column = 0; column < sourceModel()->columnCount(); ++column)
    text += sourceModel()->index(row, column, parent).data().toString() + " ";
  return std::all_of(words_.begin(), words_.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace gluray::panel
