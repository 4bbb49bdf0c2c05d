#include "desktop/panels/history_panel.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <random>

#include "desktop/panels/testing/panels_fixture.h"

namespace felt::desktop::history_panel_test {
namespace {

using testing::draw_lines;
using testing::still;

/// Rebuilds the names of the rows only from the model's signals, as a view does.
class Echo : public QObject {
 public:
  explicit Echo(QAbstractItemModel& model) : model_(model) {
    read_all();
    connect(&model, &QAbstractItemModel::modelReset, this, [this] { read_all(); });
    connect(&model, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex&, int first, int last) {
              for (int row = first; row <= last; ++row) {
                rows.insert(rows.begin() + row, text(row));
              }
            });
    connect(&model, &QAbstractItemModel::rowsRemoved, this,
            [this](const QModelIndex&, int first, int last) {
              rows.erase(rows.begin() + first, rows.begin() + last + 1);
            });
    connect(&model, &QAbstractItemModel::dataChanged, this,
            [this](const QModelIndex& first, const QModelIndex& last) {
              for (int row = first.row(); row <= last.row(); ++row) {
                rows[std::size_t(row)] = text(row);
              }
            });
  }
  [[nodiscard]] QString text(int row) const {
    return model_.index(row, 0).data(Qt::AccessibleTextRole).toString();
  }
  std::vector<QString> rows;

 private:
  void read_all() {
    rows.clear();
    for (int row = 0; row < model_.rowCount(); ++row) rows.push_back(text(row));
  }
  QAbstractItemModel& model_;
};

TEST(HistoryModel, TellsViewsEveryRowThatChangesWhateverHappens) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Studio studio(still());
    HistoryModel model(studio);
    Echo echo(model);
    for (int i = 0; i < 60; ++i) {
      switch (random() % 5) {
        case 0:
        case 1:
          studio.apply(UndoEvent{});
          break;
        case 2:
          studio.apply(RedoEvent{});
          break;
        case 3:
          draw_lines(studio, 1);
          break;
        default:
          studio.apply(LayerEvent{});
      }
      ASSERT_EQ(model.rowCount(), int(studio.session().history().step_count()) + 1);
      ASSERT_EQ(model.current_row(), int(studio.session().history().undo_count()));
      ASSERT_EQ(int(echo.rows.size()), model.rowCount());
      for (int row = 0; row < model.rowCount(); ++row) {
        ASSERT_EQ(echo.rows[std::size_t(row)], echo.text(row)) << i << " row " << row;
      }
    }
    studio.open(Document{}, Page{});
    EXPECT_EQ(echo.rows, std::vector<QString>{QStringLiteral("As opened, current")});
  }
}

TEST(HistoryPanel, AClickGoesThereAndBack) {
  Studio studio(still());
  HistoryPanel panel(studio);
  panel.resize(200, 400);
  panel.show();
  draw_lines(studio, 5);
  auto* list = panel.findChild<QListView*>();
  const auto click = [list](int row) {
    const QRect place = list->visualRect(list->model()->index(row, 0));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, place.center());
  };
  for (const int row : {2, 5, 0, 4, 4, 1}) {
    click(row);
    EXPECT_EQ(studio.session().document().stroke_count(), std::size_t(row));
    EXPECT_EQ(list->currentIndex().row(), row);
    EXPECT_EQ(list->model()->rowCount(), 6) << "nothing is forgotten by looking";
  }
  EXPECT_EQ(list->model()->index(1, 0).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("Import, current"));
  EXPECT_EQ(list->model()->index(2, 0).data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("Import, undone"));
  draw_lines(studio, 1);
  EXPECT_EQ(list->model()->rowCount(), 3);
}

TEST(HistoryPanel, KeysAndButtonsDoTheSame) {
  Studio studio(still());
  HistoryPanel panel(studio);
  panel.show();
  draw_lines(studio, 3);
  auto* list = panel.findChild<QListView*>();
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Up);
  QTest::keyClick(list, Qt::Key_Up);
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_EQ(studio.session().document().stroke_count(), 1U);
  QTest::mouseClick(panel.findChild<QToolButton*>(QStringLiteral("redo")), Qt::LeftButton);
  EXPECT_EQ(studio.session().document().stroke_count(), 2U);
  QTest::mouseClick(panel.findChild<QToolButton*>(QStringLiteral("undo")), Qt::LeftButton);
  EXPECT_EQ(studio.session().document().stroke_count(), 1U);
  EXPECT_EQ(testing::nameless(panel), std::vector<std::string>{});
}

TEST(HistoryPanel, ThousandsOfStepsAreNeverReadAgain) {
  Studio studio(still());
  HistoryPanel panel(studio);
  panel.resize(200, 400);
  panel.show();
  auto* list = panel.findChild<QListView*>();
  QSignalSpy resets(list->model(), &QAbstractItemModel::modelReset);
  QSignalSpy inserts(list->model(), &QAbstractItemModel::rowsInserted);
  QSignalSpy changes(list->model(), &QAbstractItemModel::dataChanged);
  constexpr int kSteps = 3000;
  for (int i = 0; i < kSteps; ++i)
    studio.apply(LayerEvent{LayerEvent::Do::kRename, {1}, std::to_string(i)});
  EXPECT_EQ(resets.count(), 0);
  EXPECT_EQ(inserts.count(), kSteps);
  for (const QList<QVariant>& change : changes) {
    const auto first = change[0].value<QModelIndex>(), last = change[1].value<QModelIndex>();
    ASSERT_LE(last.row() - first.row(), 2);
  }
  panel.go_to(10);
  EXPECT_EQ(studio.session().document().layers()[0].name, "9");
}

}  // namespace
}  // namespace felt::desktop::history_panel_test
