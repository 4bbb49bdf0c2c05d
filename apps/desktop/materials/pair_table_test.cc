#include "desktop/materials/pair_table.h"

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QStyleOptionViewItem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace felt::desktop::pair_table_test {
namespace {

struct Reported {
  std::string surface;
  std::optional<double> friction;
};

/// A table for a medium whose friction has many digits. No surface has a separate friction for this
/// medium.
struct ShownTable {
  ShownTable() {
    medium.friction = 0.33333;
    medium.pairs.clear();
    table.show_pairs(medium, Materials::built_in());
    QObject::connect(&table, &PairTable::chosen,
                     [this](const std::string& surface, std::optional<double> friction) {
                       reported.push_back({surface, friction});
                     });
  }
  [[nodiscard]] QModelIndex number(int row) const { return cells->model()->index(row, 1); }
  /// Opens the editor of a row, as a double click does.
  [[nodiscard]] std::unique_ptr<QDoubleSpinBox> open(int row) const {
    QAbstractItemDelegate* delegate = cells->itemDelegateForColumn(1);
    if (!delegate) return nullptr;
    QWidget* made = delegate->createEditor(cells->viewport(), QStyleOptionViewItem(), number(row));
    auto* spin = qobject_cast<QDoubleSpinBox*>(made);
    if (spin) delegate->setEditorData(spin, number(row));
    return std::unique_ptr<QDoubleSpinBox>(spin);
  }
  /// Closes the editor, as Enter or a click elsewhere does.
  void leave(QDoubleSpinBox& spin, int row) const {
    cells->itemDelegateForColumn(1)->setModelData(&spin, cells->model(), number(row));
  }

  Medium medium = *find_medium("chalk");
  std::vector<Reported> reported;
  PairTable table;
  QTableWidget* cells = table.findChild<QTableWidget*>();
};

TEST(PairTable, LookingAtANumberMakesNoPair) {
  ShownTable shown;
  ASSERT_EQ(shown.cells->rowCount(), static_cast<int>(surface_materials().size()));
  for (int row = 0; row < shown.cells->rowCount(); ++row) {
    const std::unique_ptr<QDoubleSpinBox> spin = shown.open(row);
    ASSERT_TRUE(spin);
    EXPECT_NEAR(spin->value(), friction_of(shown.medium, surface_materials()[std::size_t(row)]),
                0.00051);
    shown.leave(*spin, row);
  }
  EXPECT_TRUE(shown.reported.empty());
}

TEST(PairTable, ANumberHasThreeDigits) {
  ShownTable shown;
  const std::unique_ptr<QDoubleSpinBox> spin = shown.open(1);
  ASSERT_TRUE(spin);
  EXPECT_EQ(spin->decimals(), 3);
  EXPECT_EQ(spin->minimum(), 0.0);
  EXPECT_EQ(spin->maximum(), kMaxFriction);
  EXPECT_EQ(spin->singleStep(), 0.01);
  EXPECT_FALSE(spin->accessibleName().isEmpty());
  spin->setValue(0.123);
  shown.leave(*spin, 1);
  ASSERT_EQ(shown.reported.size(), 1u);
  EXPECT_EQ(shown.reported[0].surface, surface_materials()[1].id);
  ASSERT_TRUE(shown.reported[0].friction);
  EXPECT_DOUBLE_EQ(*shown.reported[0].friction, 0.123);
}

}  // namespace
}  // namespace felt::desktop::pair_table_test
