#include "desktop/materials/pair_table.h"

#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "desktop/feel/material_words.h"
#include "felt/material/material_fields.h"

namespace felt::desktop {
namespace {

constexpr int kSurface = 0, kFriction = 1;
constexpr int kRowRoomPx = 5;
constexpr int kPairIdRole = Qt::UserRole, kOwnRole = Qt::UserRole + 1;

bool has_own(const Medium& medium, const std::string& surface) {
  return std::any_of(medium.pairs.begin(), medium.pairs.end(),
                     [&](const PairFriction& pair) { return pair.surface == surface; });
}

/// Three decimals are finer than a hand can distinguish.
constexpr int kDecimals = 3;
double rounded(double friction) {
  return std::round(1000.0 * friction) / 1000.0;
}

/// Edits a number with the decimals that the table shows. If the user leaves the field without
/// changing the number, the friction of the pair is not set.
class FrictionDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                        const QModelIndex&) const override {
    auto* spin = new QDoubleSpinBox(parent);
    spin->setFrame(false);
    spin->setDecimals(kDecimals);
    spin->setRange(0.0, kMaxFriction);
    spin->setSingleStep(0.01);
    spin->setAccessibleName(PairTable::tr("Friction"));
    return spin;
  }
  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    auto* spin = qobject_cast<QDoubleSpinBox*>(editor);
    spin->setValue(index.data(Qt::EditRole).toDouble());
    // Stores the rounded value, because the value in the table may have more decimals.
    spin->setProperty(kBegunWith, spin->value());
  }
  void setModelData(QWidget* editor, QAbstractItemModel* model,
                    const QModelIndex& index) const override {
    auto* spin = qobject_cast<QDoubleSpinBox*>(editor);
    spin->interpretText();
    if (spin->value() == spin->property(kBegunWith).toDouble()) return;
    model->setData(index, spin->value(), Qt::EditRole);
  }

 private:
  static constexpr auto kBegunWith = "begun_with";
};

}  // namespace

PairTable::PairTable(QWidget* parent)
    : QWidget(parent), table_(new QTableWidget(0, 2, this)), rule_(new QToolButton(this)) {
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins({});
  auto* heading = new QLabel(tr("Friction on each surface"), this);
  heading->setBuddy(table_);
  lines->addWidget(heading);
  lines->addWidget(table_);
  lines->addWidget(rule_, 0, Qt::AlignLeft);
  table_->setAccessibleName(heading->text());
  table_->setAccessibleDescription(tr("Bold numbers are specific to this medium and surface"));
  table_->setToolTip(tr("Double-click a number, or press F2, to set the friction on that surface"));
  table_->setHorizontalHeaderLabels({tr("Surface"), tr("Friction")});
  table_->horizontalHeader()->setSectionResizeMode(kSurface, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(kFriction, QHeaderView::ResizeToContents);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowRoomPx);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  table_->setShowGrid(false);
  table_->setItemDelegateForColumn(kFriction, new FrictionDelegate(table_));
  rule_->setText(tr("Use the default"));
  rule_->setToolTip(tr("Uses the friction of the medium times that of the surface"));
  rule_->setFocusPolicy(Qt::StrongFocus);
  connect(table_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (item->column() != kFriction) return;
    const double typed = std::clamp(item->data(Qt::EditRole).toDouble(), 0.0, kMaxFriction);
    Q_EMIT chosen(surface_of(item->row()), rounded(typed));
  });
  connect(table_, &QTableWidget::itemSelectionChanged, this, &PairTable::report_button);
  connect(rule_, &QToolButton::clicked, this, [this] {
    if (table_->currentRow() >= 0) Q_EMIT chosen(surface_of(table_->currentRow()), std::nullopt);
  });
}

std::string PairTable::surface_of(int row) const {
  return table_->item(row, kSurface)->data(kPairIdRole).toString().toStdString();
}

void PairTable::report_button() {
  const QTableWidgetItem* item = table_->item(table_->currentRow(), kFriction);
  rule_->setEnabled(item && item->data(kOwnRole).toBool());
}

void PairTable::show_pairs(const Medium& medium, const Materials& known) {
  const QSignalBlocker quiet(table_);
  table_->setRowCount(static_cast<int>(known.surfaces().size()));
  int row = 0;
  for (const SurfaceMaterial& surface : known.surfaces()) {
    for (const int column : {kSurface, kFriction}) {
      if (!table_->item(row, column)) table_->setItem(row, column, new QTableWidgetItem);
    }
    QTableWidgetItem* name = table_->item(row, kSurface);
    name->setText(material_label(surface));
    name->setData(kPairIdRole, QString::fromStdString(surface.id));
    name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    QTableWidgetItem* number = table_->item(row, kFriction);
    const bool is_own = has_own(medium, surface.id);
    number->setData(Qt::EditRole, rounded(friction_of(medium, surface)));
    number->setData(kOwnRole, is_own);
    number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    QFont font = table_->font();
    font.setBold(is_own);
    number->setFont(font);
    ++row;
  }
  // The table shows all rows without scrolling, because the panel around it scrolls.
  int height = table_->horizontalHeader()->sizeHint().height() + 2 * table_->frameWidth();
  for (int i = 0; i < row; ++i) height += table_->rowHeight(i);
  table_->setFixedHeight(height);
  table_->viewport()->update();
  report_button();
}

}  // namespace felt::desktop
