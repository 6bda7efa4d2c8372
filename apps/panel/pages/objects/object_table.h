// The rows of the table of objects, and their order and filter. GUI thread.
#pragma once
#include "model/object_list.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

namespace gluray::panel {

enum class ObjectColumn { number, color, shape, triangles, material, hidden, count };

class ObjectTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;
  static constexpr int kSortRole = Qt::UserRole;

  /// Rows of the same objects stay where they are; otherwise the model is reset. Returns whether it is.
  bool setObjects(const std::vector<DrawnObject>& objects);
  const DrawnObject& object(int row) const { return objects_[static_cast<size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<DrawnObject> objects_;
};

/// Shows the objects in which each word of the search is found.
class ObjectFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void search(const QString& text);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  QStringList words_;
};

}  // namespace gluray::panel
