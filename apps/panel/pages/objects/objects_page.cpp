#include "pages/objects/objects_page.h"

#include "pages/objects/object_editor.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

namespace gluray::panel {
namespace {

constexpr int kMaxHeight = 10000;  // pixels: the table gets what the editor does not need

}  // namespace

ObjectsPage::ObjectsPage(Controls& controls, QWidget* parent)
    : QWidget(parent), controls_(controls), list_(controls, this), message_(new QLabel(this)) {
  message_->setObjectName("objects-message");
  message_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  makeTable();
  note_ = makeNote();
  editor_ = new ObjectEditor(controls, this);
  auto* below = new QScrollArea(this);
  below->setWidget(editor_);
  below->setWidgetResizable(true);
  below->setFrameShape(QFrame::NoFrame);
  below->viewport()->setAutoFillBackground(false);
  editor_->setAutoFillBackground(false);
  auto* above = new QWidget(this);  // stays where it is while there is no table
  auto* around = new QVBoxLayout(above);
  around->setContentsMargins(0, 0, 0, 0);
  around->addWidget(table_);
  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->addWidget(above);
  splitter->addWidget(below);
  splitter->setStretchFactor(0, 1);
  splitter->setSizes({kMaxHeight, editor_->sizeHint().height()});
  splitter->setChildrenCollapsible(false);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(message_);
  layout->addWidget(splitter, 1);
  layout->addWidget(note_);
  connect(&list_, &ObjectList::changed, this, &ObjectsPage::takeList);
  connect(&controls_, &Controls::chosenChanged, this, [this] { selected_.clear(), wanted_.reset(), mark(); });
  takeList();
  update();
}

void ObjectsPage::makeTable() {
  filter_.setSourceModel(&rows_);
  filter_.setSortRole(ObjectTable::kSortRole);
  table_ = new QTableView(this);
  table_->setModel(&filter_);
  table_->setAccessibleName(tr("Objects"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setSortingEnabled(true);
  table_->sortByColumn(0, Qt::AscendingOrder);
  table_->setTabKeyNavigation(false);
  table_->setShowGrid(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setMinimumHeight(fontMetrics().height() * 6);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (!marking_) takeSelection();
  });
}

QWidget* ObjectsPage::makeNote() {
  auto* note = new QWidget(this);
  note->setObjectName("objects-note");
  auto* layout = new QHBoxLayout(note);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* text = new QLabel(tr("Materials have an effect only with integrator = path or whitted."), note);
  text->setWordWrap(true);
  auto* button = new QPushButton(tr("&Trace paths"), note);
  button->setToolTip(tr("integrator = path"));
  button->setAccessibleDescription(text->text());
  layout->addWidget(text, 1);
  layout->addWidget(button);
  connect(button, &QPushButton::clicked, this, [this] { controls_.set("integrator", "path"); });
  return note;
}

void ObjectsPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  list_.watch(true);
}

void ObjectsPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  list_.watch(false);
}

QString ObjectsPage::messageNow() const {
  if (!controls_.chosen())
    return controls_.all() ? tr("Choose one program on the left to see its objects.")
                           : tr("No program is chosen.");
  if (!list_.why().isEmpty()) return tr("No objects: %1").arg(list_.why());
  if (!list_.known()) return tr("Asking the program what it draws...");
  const auto shown = static_cast<qlonglong>(list_.objects().size());
  if (shown == 0) return tr("GLuRay traces no objects of this program.");
  if (shown < list_.total()) return tr("The first %1 of %2 objects.").arg(shown).arg(list_.total());
  return shown == 1 ? tr("One object.") : tr("%1 objects.").arg(shown);
}

void ObjectsPage::takeList() {
  const int scrolled = table_->verticalScrollBar()->value();
  marking_ = true;  // a reset clears the selection
  const bool reset = rows_.setObjects(list_.objects());
  marking_ = false;
  table_->setVisible(!list_.objects().empty());
  if (reset) table_->verticalScrollBar()->setValue(scrolled);
  reset ? mark() : edit();
  message_->setText(messageNow());
}

void ObjectsPage::select(uint32_t number) {
  selected_.clear();
  wanted_.reset();
  if (number > 0) selected_ = {number}, wanted_ = number;
  mark();
}

/// Selects the rows of selected_, as far as they are there.
void ObjectsPage::mark() {
  QItemSelection selection;
  const auto isSelected = [&](int row) {
    return row < filter_.rowCount() &&
           selected_.contains(rows_.object(filter_.mapToSource(filter_.index(row, 0)).row()).number);
  };
  for (int row = 0; row < filter_.rowCount() && !selected_.empty(); ++row) {
    const int first = row;
    while (isSelected(row)) ++row;
    if (row > first) selection.select(filter_.index(first, 0), filter_.index(row - 1, 0));
  }
  if (!selection.isEmpty() && wanted_) {
    wanted_.reset();
    const QModelIndex index = selection.indexes().first();
    table_->scrollTo(index);
    table_->selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
  }
  marking_ = true;
  table_->selectionModel()->select(selection,
                                   QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  marking_ = false;
  edit();
}

void ObjectsPage::takeSelection() {
  selected_.clear(), wanted_.reset();
  for (const QModelIndex& index : table_->selectionModel()->selectedRows())
    selected_.insert(rows_.object(filter_.mapToSource(index).row()).number);
  edit();
}

/// The editor shows the selected objects that are there.
void ObjectsPage::edit() {
  std::vector<DrawnObject> objects;
  for (int row = 0; row < rows_.rowCount(); ++row)
    if (selected_.contains(rows_.object(row).number)) objects.push_back(rows_.object(row));
  editor_->show(std::move(objects));
}

int ObjectsPage::filter(const QString& search) {
  filter_.search(search);
  mark();
  return filter_.rowCount();
}

void ObjectsPage::update() {
  const nlohmann::json integrator = controls_.value("integrator").value;
  note_->setVisible(controls_.shown() && (integrator == "local" || integrator == "ao"));
  message_->setText(messageNow());
  editor_->update();
}

}  // namespace gluray::panel
