#include "desktop/panels/layers_panel.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "desktop/panels/layer_delegate.h"
#include "desktop/panels/testing/panels_fixture.h"
#include "felt/document/fill.h"
#include "felt/document/testing/small_picture.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::layers_panel_test {
namespace {

using Do = LayerEvent::Do;
using testing::layer_names;
using testing::still;

/// A fixture: three layers, from the top "c*", "b", "Ink", in a visible panel.
struct LayerFixture {
  Studio studio{still()};
  LayersPanel panel{studio};
  QListView* list = panel.findChild<QListView*>();

  LayerFixture() {
    studio.apply(LayerEvent{Do::kAdd, {}, "b"});
    studio.apply(LayerEvent{Do::kAdd, {}, "c"});
    panel.resize(240, 260);
    panel.show();
    panel.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&panel));
  }
  [[nodiscard]] QRect row(int i) const { return list->visualRect(list->model()->index(i, 0)); }
  void click(QPoint at) const { QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at); }
  void press(const char* button) const {
    auto* found = panel.findChild<QToolButton*>(QString::fromLatin1(button));
    QTest::mouseClick(found, Qt::LeftButton);
  }
  [[nodiscard]] QString spoken(int i) const {
    return list->model()->index(i, 0).data(Qt::AccessibleTextRole).toString();
  }
  [[nodiscard]] const Layer* layer(std::uint64_t id) const {
    return studio.session().document().layer({id});
  }
};

TEST(LayersPanel, AClickUsesALayerEyeAndLockAreAtItsEnds) {
  LayerFixture fixture;
  EXPECT_EQ(layer_names(fixture.studio), "c* b Ink");
  fixture.click(fixture.row(2).center());
  EXPECT_EQ(layer_names(fixture.studio), "c b Ink*");
  fixture.click(LayerDelegate::eye_of(fixture.row(1)).center());
  EXPECT_FALSE(fixture.layer(2)->visible);
  EXPECT_EQ(layer_names(fixture.studio), "c b Ink*") << "an eye does not use the layer";
  fixture.click(fixture.row(1).center());
  EXPECT_EQ(layer_names(fixture.studio), "c b Ink*") << "nor can a hidden one be used";
  EXPECT_EQ(fixture.panel.chosen(), LayerId{1}) << "the one that is drawn on stays chosen";
  fixture.click(LayerDelegate::eye_of(fixture.row(1)).center());
  EXPECT_TRUE(fixture.layer(2)->visible);
  fixture.click(LayerDelegate::lock_of(fixture.row(2)).center());
  EXPECT_TRUE(fixture.layer(1)->locked);
  EXPECT_EQ(layer_names(fixture.studio), "c* b Ink") << "the session uses the highest open one";
}

TEST(LayersPanel, SaysItAllToAScreenReader) {
  LayerFixture fixture;
  fixture.studio.apply(LayerEvent{Do::kHide, {2}});
  fixture.studio.apply(LayerEvent{Do::kLock, {1}});
  EXPECT_EQ(fixture.spoken(0), QStringLiteral("c, visible, unlocked, current"));
  EXPECT_EQ(fixture.spoken(1), QStringLiteral("b, hidden, unlocked"));
  EXPECT_EQ(fixture.spoken(2), QStringLiteral("Ink, visible, locked"));
  EXPECT_EQ(testing::nameless(fixture.panel), std::vector<std::string>{});
}

TEST(LayersPanel, ButtonsAddRaiseLowerAndRemove) {
  LayerFixture fixture;
  fixture.press("lower");
  EXPECT_EQ(layer_names(fixture.studio), "b c* Ink");
  fixture.press("lower");
  EXPECT_EQ(layer_names(fixture.studio), "b Ink c*");
  EXPECT_FALSE(fixture.panel.findChild<QToolButton*>(QStringLiteral("lower"))->isEnabled());
  fixture.press("raise");
  EXPECT_EQ(layer_names(fixture.studio), "b c* Ink");
  fixture.press("layer-add");
  EXPECT_EQ(layer_names(fixture.studio), "b Layer 4* c Ink");
  EXPECT_EQ(fixture.panel.chosen(), LayerId{4});
  fixture.press("delete");
  EXPECT_EQ(layer_names(fixture.studio), "b* c Ink");
  fixture.studio.apply(UndoEvent{});
  EXPECT_EQ(fixture.list->model()->rowCount(), 4);
}

TEST(LayersPanel, KeysChooseShowAndUse) {
  LayerFixture fixture;
  fixture.list->setFocus();
  QTest::keyClick(fixture.list, Qt::Key_Down);
  QTest::keyClick(fixture.list, Qt::Key_Down);
  EXPECT_EQ(fixture.panel.chosen(), LayerId{1});
  EXPECT_EQ(layer_names(fixture.studio), "c* b Ink") << "walking through the list uses nothing";
  QTest::keyClick(fixture.list, Qt::Key_Space);
  EXPECT_FALSE(fixture.layer(1)->visible);
  EXPECT_EQ(fixture.panel.chosen(), LayerId{1});
  QTest::keyClick(fixture.list, Qt::Key_Space);
  QTest::keyClick(fixture.list, Qt::Key_Return);
  EXPECT_EQ(layer_names(fixture.studio), "c b Ink*");
}

TEST(LayersPanel, RenamesInPlaceAsOneStep) {
  LayerFixture fixture;
  const std::size_t steps = fixture.studio.session().history().undo_count();
  fixture.panel.rename();
  auto* field = fixture.list->findChild<QLineEdit*>();
  ASSERT_NE(field, nullptr);
  field->selectAll();
  QTest::keyClicks(field, QStringLiteral("Faces"));
  QTest::keyClick(field, Qt::Key_Return);
  QCoreApplication::processEvents();
  EXPECT_EQ(layer_names(fixture.studio), "Faces* b Ink");
  EXPECT_EQ(fixture.studio.session().history().undo_count(), steps + 1);
  EXPECT_FALSE(
      fixture.list->model()->setData(fixture.list->model()->index(0, 0), QStringLiteral("  ")))
      << "a layer has a name";
}

TEST(LayersPanel, ADragOverManyPlacesIsOneStep) {
  std::mt19937 random(5);
  LayerFixture fixture;
  fixture.studio.apply(LayerEvent{Do::kAdd, {}, "d"});
  QAbstractItemModel* model = fixture.list->model();
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const int count = model->rowCount();
    const int from = int(random() % unsigned(count)), before = int(random() % unsigned(count + 1));
    std::vector<QString> wanted;
    for (int row = 0; row < count; ++row) wanted.push_back(model->index(row, 0).data().toString());
    const QString moved = wanted[std::size_t(from)];
    wanted.insert(wanted.begin() + before, moved);
    wanted.erase(wanted.begin() + from + (before <= from ? 1 : 0));
    const std::size_t steps = fixture.studio.session().history().undo_count();
    const bool done = model->moveRow({}, from, {}, before);
    EXPECT_EQ(done, before != from && before != from + 1);
    EXPECT_EQ(fixture.studio.session().history().undo_count(), steps + (done ? 1 : 0));
    for (int row = 0; row < count; ++row) {
      EXPECT_EQ(model->index(row, 0).data().toString(), wanted[std::size_t(row)]);
    }
  }
}

TEST(LayersPanel, IsReadAnewOnlyWhenALayerChanges) {
  LayerFixture fixture;
  QSignalSpy resets(fixture.list->model(), &QAbstractItemModel::modelReset);
  testing::draw_lines(fixture.studio, 20);
  fixture.studio.apply(UndoEvent{});
  EXPECT_EQ(resets.count(), 0);
  fixture.studio.apply(LayerEvent{Do::kHide, {2}});
  EXPECT_EQ(resets.count(), 1);
  fixture.studio.open(Document{}, Page{});
  EXPECT_EQ(fixture.list->model()->rowCount(), 1);
}

TEST(LayerActions, ActOnTheChosenLayerAndFollowIt) {
  LayerFixture fixture;
  QWidget window;
  Actions actions(&window);
  add_layer_actions(actions, fixture.studio, fixture.panel);
  const auto find = [&actions](const char* name) {
    return actions.find(QString::fromLatin1(name));
  };
  EXPECT_FALSE(find("layer.raise")->isEnabled()) << "it is the topmost";
  find("layer.lower")->trigger();
  EXPECT_EQ(layer_names(fixture.studio), "b c* Ink");
  EXPECT_TRUE(find("layer.raise")->isEnabled());
  find("layer.use_below")->trigger();
  EXPECT_EQ(layer_names(fixture.studio), "b c Ink*");
  find("layer.use_below")->trigger();
  EXPECT_EQ(layer_names(fixture.studio), "b c Ink*");
  fixture.studio.apply(LayerEvent{Do::kLock, {3}});
  find("layer.use_above")->trigger();
  EXPECT_EQ(layer_names(fixture.studio), "b* c Ink") << "a locked one is passed over";
  fixture.panel.choose({3});
  EXPECT_TRUE(find("layer.lock")->isChecked());
  find("layer.lock")->trigger();
  EXPECT_FALSE(fixture.layer(3)->locked);
  find("layer.show")->trigger();
  EXPECT_FALSE(fixture.layer(3)->visible);
  fixture.studio.apply(UndoEvent{});
  EXPECT_TRUE(find("layer.show")->isChecked()) << "undo shows in the action";
  find("layer.add")->trigger();
  find("layer.remove")->trigger();
  EXPECT_EQ(fixture.list->model()->rowCount(), 3);
}

TEST(LayersPanel, TheHighlightStaysOnTheLayerThatIsDrawnOn) {
  LayerFixture fixture;
  QSignalSpy said(&fixture.studio, &Studio::refused);
  fixture.click(LayerDelegate::eye_of(fixture.row(1)).center());
  EXPECT_FALSE(fixture.layer(2)->visible);
  EXPECT_EQ(fixture.panel.chosen(), LayerId{3});
  fixture.click(fixture.row(1).center());
  EXPECT_EQ(fixture.panel.chosen(), LayerId{3})
      << "a hidden layer is not the one that the bin takes";
  EXPECT_EQ(said.count(), 1);
  fixture.click(LayerDelegate::eye_of(fixture.row(2)).center());
  said.clear();
  for (const bool locks : {true, false, true}) {
    fixture.click(LayerDelegate::lock_of(fixture.row(0)).center());
    EXPECT_EQ(fixture.layer(3)->locked, locks) << "the second click unlocks it again";
    EXPECT_EQ(fixture.list->model()->rowCount(), 3);
    EXPECT_EQ(fixture.panel.chosen(), LayerId{3});
  }
  EXPECT_EQ(said.count(), 0);
  testing::draw_lines(fixture.studio, 1);
  EXPECT_EQ(fixture.list->model()->rowCount(), 4);
  EXPECT_EQ(fixture.panel.chosen(), LayerId{4});
  ASSERT_EQ(said.count(), 1) << "a layer came by itself";
  EXPECT_TRUE(said.front().front().toString().contains(QStringLiteral("Layer 4")));
  fixture.studio.apply(UndoEvent{});
  EXPECT_EQ(fixture.list->model()->rowCount(), 3) << "one step";
  EXPECT_EQ(said.count(), 1);
}

TEST(LayersPanel, TheSliderSetsTheOpacityOfTheHighlightedLayerAsOneStep) {
  LayerFixture fixture;
  auto* slider = fixture.panel.findChild<QSlider*>(QStringLiteral("opacity"));
  ASSERT_NE(slider, nullptr);
  EXPECT_EQ(slider->value(), 100);
  const std::size_t steps = fixture.studio.session().history().undo_count();
  slider->setSliderDown(true);
  for (const int percent : {90, 60, 30}) {
    slider->setValue(percent);
    EXPECT_EQ(fixture.layer(3)->opacity, percent / 100.0) << "live";
  }
  slider->setSliderDown(false);
  EXPECT_EQ(fixture.studio.session().history().undo_count(), steps + 1);
  EXPECT_EQ(fixture.spoken(0), QStringLiteral("c, visible, unlocked, opacity 30 %, current"));
  slider->setValue(50);
  EXPECT_EQ(fixture.studio.session().history().undo_count(), steps + 2);
  fixture.studio.apply(UndoEvent{});
  EXPECT_EQ(slider->value(), 30);
  fixture.studio.apply(UndoEvent{});
  EXPECT_EQ(slider->value(), 100);
  fixture.panel.choose({1});
  EXPECT_EQ(slider->value(), 100);
}

TEST(LayersPanel, ButtonsDuplicateAndMerge) {
  LayerFixture fixture;
  fixture.press("layer-duplicate");
  EXPECT_EQ(layer_names(fixture.studio), "c copy* c b Ink");
  fixture.press("layer-merge");
  EXPECT_EQ(layer_names(fixture.studio), "c* b Ink");
  fixture.panel.choose({1});
  EXPECT_FALSE(fixture.panel.findChild<QToolButton*>(QStringLiteral("layer-merge"))->isEnabled());
}

TEST(LayersPanel, ThumbnailsShowTheInkAndThePictureOfEachLayer) {
  LayerFixture fixture;
  const Page& page = fixture.studio.page();
  fixture.studio.apply(AddPicture{
      "Photo",
      felt::testing::picture_data(),
      {page.width_mm / 2.0, 0.0, 0.0, page.height_mm, 0.0, 0.0}});  // red left, blue right
  auto* thumbnails = fixture.panel.findChild<LayerThumbnails*>();
  ASSERT_NE(thumbnails, nullptr);
  thumbnails->paint_now();
  const QImage photo = thumbnails->of({4}).toImage();
  ASSERT_FALSE(photo.isNull());
  EXPECT_EQ(photo.pixelColor(2, photo.height() / 2), QColor(Qt::red));
  EXPECT_EQ(photo.pixelColor(photo.width() - 3, photo.height() / 2), QColor(Qt::blue));
  const QImage empty = thumbnails->of({1}).toImage();
  EXPECT_NE(empty.pixelColor(2, empty.height() / 2), QColor(Qt::red));
  EXPECT_TRUE(fixture.spoken(1).contains(QStringLiteral("picture")));
}

/// Returns the lightness of the darkest pixel, 0 to 255, in the columns of a thumbnail.
int darkest_of(const QImage& image, int from, int to) {
  int darkest = 255;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = from; x < to; ++x) {
      darkest = std::min(darkest, image.pixelColor(x, y).lightness());
    }
  }
  return darkest;
}

TEST(LayersPanel, ThinLinesAreSeenInThumbnails) {
  for (const double width_mm : {0.1, 0.3, 0.6, 2.0}) {
    LayerFixture fixture;
    const Page& page = fixture.studio.page();
    std::vector<StrokePtr> lines;
    for (const double y : {0.31, 0.5, 0.7}) {
      lines.push_back(std::make_shared<const Stroke>(felt::testing::straight_stroke(
          {0.0, y * page.height_mm}, {0.5 * page.width_mm, y * page.height_mm}, width_mm,
          width_mm)));
    }
    ASSERT_TRUE(fixture.studio.import(QStringLiteral("test"), lines));
    auto* thumbnails = fixture.panel.findChild<LayerThumbnails*>();
    thumbnails->paint_now();
    const QImage small = thumbnails->of(fixture.studio.session().layer()).toImage();
    EXPECT_LT(darkest_of(small, 2, small.width() / 2 - 2), 170) << width_mm << " mm";
    EXPECT_EQ(darkest_of(small, small.width() / 2 + 2, small.width()), 255) << "paper stays white";
  }
}

TEST(LayersPanel, ThumbnailsShowFillsAndAllOfManyLines) {
  LayerFixture fixture;
  const Page& page = fixture.studio.page();
  const double w = page.width_mm, h = page.height_mm;
  FillLoop loop;
  const Point corners[] = {{0, 0}, {w / 4, 0}, {w / 4, h}, {0, h}, {0, 0}};
  loop.points.push_back(corners[0]);
  for (int i = 0; i < 4; ++i) {
    const Cubic side = straight(corners[i], corners[i + 1]);
    loop.points.insert(loop.points.end(), {side.p[1], side.p[2], side.p[3]});
  }
  const FillPtr red = std::make_shared<const Fill>(Fill{{loop}, {255, 0, 0, 255}, 0.0});
  std::vector<StrokePtr> lines;  // the first ones are on the right, the last ones in the middle
  for (std::size_t i = 0; i < 3 * LayerThumbnails::kMaxShown; ++i) {
    const double x = w * (i < LayerThumbnails::kMaxShown ? 0.9 : 0.6);
    lines.push_back(std::make_shared<const Stroke>(
        felt::testing::straight_stroke({x, 0.2 * h}, {x, 0.8 * h}, 0.5, 0.5)));
  }
  ASSERT_TRUE(fixture.studio.import(QStringLiteral("test"), lines, std::vector{red}));
  auto* thumbnails = fixture.panel.findChild<LayerThumbnails*>();
  thumbnails->paint_now();
  const QImage small = thumbnails->of(fixture.studio.session().layer()).toImage();
  EXPECT_EQ(small.pixelColor(small.width() / 8, small.height() / 2), QColor(Qt::red));
  EXPECT_LT(darkest_of(small, small.width() / 2, 7 * small.width() / 10), 100);
  EXPECT_LT(darkest_of(small, 8 * small.width() / 10, small.width()), 100);
}

TEST(LayersPanel, TheBoxSetsTheBlendModeOfTheHighlightedLayer) {
  LayerFixture fixture;
  auto* box = fixture.panel.findChild<QComboBox*>(QStringLiteral("blend"));
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(box->count(), int(kBlendModeNames.size())) << "a name for each mode";
  EXPECT_EQ(box->currentIndex(), 0);
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Down);
  EXPECT_EQ(fixture.layer(3)->blend, BlendMode::kMultiply);
  EXPECT_EQ(fixture.spoken(0), QStringLiteral("c, visible, unlocked, multiplies, current"));
  fixture.panel.choose({1});
  EXPECT_EQ(box->currentIndex(), 0);
  fixture.panel.choose({3});
  EXPECT_EQ(box->currentIndex(), 1);
  fixture.studio.apply(UndoEvent{});
  EXPECT_EQ(box->currentIndex(), 0);
  EXPECT_EQ(testing::nameless(fixture.panel), std::vector<std::string>{});
}

/// The rows of the list, the topmost first: "(Group 1) c b | Ink"; | ends a group.
std::string rows(const LayerFixture& fixture) {
  std::string text;
  bool was_in = false;
  const QAbstractItemModel& model = *fixture.list->model();
  for (int row = 0; row < model.rowCount(); ++row) {
    const QModelIndex index = model.index(row, 0);
    const bool is_in = index.data(LayersModel::kIndented).toBool();
    const bool is_group = index.data(LayersModel::kIsGroup).toBool();
    if (was_in && !is_in) text += "| ";
    was_in = is_in;
    const std::string name = index.data().toString().toStdString();
    text += is_group ? "(" + name + ") " : name + " ";
  }
  return text + (was_in ? "|" : "");
}

TEST(LayersPanel, GroupsHaveRowsThatShowLockFadeAndCollapse) {
  LayerFixture fixture;
  fixture.panel.group_with_below();  // c and b
  EXPECT_EQ(rows(fixture), "(Group 1) c b | Ink ");
  EXPECT_EQ(fixture.spoken(0), QStringLiteral("Group 1 (group), visible, unlocked, expanded"));
  EXPECT_EQ(fixture.spoken(1),
            QStringLiteral("c, visible, unlocked, in the group Group 1, current"));
  fixture.click(LayerDelegate::eye_of(fixture.row(0)).center());
  EXPECT_FALSE(fixture.layer(2)->visible);
  EXPECT_TRUE(fixture.layer(2)->own_visible);
  EXPECT_EQ(layer_names(fixture.studio), "c b Ink*") << "the only open layer";
  fixture.click(LayerDelegate::eye_of(fixture.row(0)).center());
  EXPECT_TRUE(fixture.layer(2)->visible);
  fixture.click(LayerDelegate::lock_of(fixture.row(0)).center());
  EXPECT_TRUE(fixture.layer(2)->locked);
  fixture.click(LayerDelegate::lock_of(fixture.row(0)).center());
  EXPECT_EQ(fixture.panel.chosen_group(), GroupId{1});
  fixture.panel.set_opacity(0.5, false);
  fixture.panel.set_blend(BlendMode::kMultiply);
  EXPECT_EQ(fixture.layer(2)->group->opacity, 0.5);
  EXPECT_EQ(fixture.layer(2)->group->blend, BlendMode::kMultiply);
  EXPECT_EQ(fixture.layer(2)->opacity, 1.0);
  const std::size_t steps = fixture.studio.session().history().undo_count();
  fixture.click(LayerDelegate::arrow_of(fixture.row(0)).center());
  EXPECT_EQ(rows(fixture), "(Group 1) Ink ");
  fixture.list->setFocus();
  fixture.panel.choose_group({1});
  QTest::keyClick(fixture.list, Qt::Key_Right);
  EXPECT_EQ(rows(fixture), "(Group 1) c b | Ink ");
  QTest::keyClick(fixture.list, Qt::Key_Left);
  EXPECT_EQ(rows(fixture), "(Group 1) Ink ");
  EXPECT_EQ(fixture.studio.session().history().undo_count(), steps) << "it is not a step of undo";
  fixture.studio.apply(LayerEvent{Do::kUse, {2}});
  EXPECT_EQ(fixture.panel.chosen_group(), GroupId{1}) << "stands for its layers";
}

TEST(LayersPanel, LayersAreDraggedIntoGroupsAndOutOfThem) {
  LayerFixture fixture;
  fixture.studio.apply(LayerEvent{Do::kAdd, {}, "d"});
  fixture.panel.choose({3});
  fixture.panel.group_with_below();
  QAbstractItemModel& model = *fixture.list->model();
  ASSERT_EQ(rows(fixture), "d (Group 1) c b | Ink ");
  EXPECT_TRUE(model.moveRow({}, 0, {}, 2)) << "below the row of the group: to its top";
  EXPECT_EQ(rows(fixture), "(Group 1) d c b | Ink ");
  EXPECT_TRUE(model.moveRow({}, 3, {}, 1));
  EXPECT_EQ(rows(fixture), "(Group 1) b d c | Ink ");
  EXPECT_TRUE(model.moveRow({}, 4, {}, 3)) << "between two of its layers";
  EXPECT_EQ(rows(fixture), "(Group 1) b d Ink c |");
  EXPECT_TRUE(model.moveRow({}, 2, {}, 0)) << "above the row of the group: out of it";
  EXPECT_EQ(rows(fixture), "d (Group 1) b Ink c |");
  EXPECT_TRUE(model.moveRow({}, 1, {}, 0)) << "the whole group";
  EXPECT_EQ(rows(fixture), "(Group 1) b Ink c | d ");
  EXPECT_FALSE(model.moveRow({}, 0, {}, 3)) << "into itself";
  EXPECT_TRUE(model.moveRow({}, 1, {}, 5));
  EXPECT_EQ(rows(fixture), "(Group 1) Ink c | d b ");
  EXPECT_TRUE(model.setData(model.index(0, 0), QStringLiteral("Cat")));
  EXPECT_EQ(rows(fixture), "(Cat) Ink c | d b ");
}

TEST(LayerActions, GroupAndUngroup) {
  LayerFixture fixture;
  QWidget window;
  Actions actions(&window);
  add_layer_actions(actions, fixture.studio, fixture.panel);
  const auto find = [&actions](const char* name) {
    return actions.find(QString::fromLatin1(name));
  };
  EXPECT_FALSE(find("layer.ungroup")->isEnabled());
  find("layer.group")->trigger();
  EXPECT_EQ(rows(fixture), "(Group 1) c b | Ink ");
  EXPECT_FALSE(find("layer.group")->isEnabled()) << "it is in a group already";
  EXPECT_FALSE(find("layer.raise")->isEnabled()) << "the highest of its group";
  fixture.panel.choose({2});
  EXPECT_FALSE(find("layer.merge")->isEnabled()) << "the layer below is not in the group";
  find("layer.leave_group")->trigger();
  EXPECT_EQ(rows(fixture), "b (Group 1) c | Ink ");
  find("layer.group")->trigger();
  EXPECT_EQ(rows(fixture), "(Group 1) b c | Ink ") << "joins the group below";
  fixture.panel.choose_group({1});
  EXPECT_TRUE(find("layer.lower")->isEnabled());
  find("layer.lower")->trigger();
  EXPECT_EQ(rows(fixture), "Ink (Group 1) b c |");
  find("layer.show")->trigger();
  EXPECT_FALSE(fixture.layer(2)->visible);
  // The group stays highlighted although the layer Ink became current.
  find("layer.show")->trigger();
  EXPECT_TRUE(fixture.layer(2)->visible);
  find("layer.lock")->trigger();
  find("layer.lock")->trigger();
  EXPECT_FALSE(fixture.layer(2)->locked);
  find("layer.ungroup")->trigger();
  EXPECT_EQ(rows(fixture), "Ink b c ");
}

}  // namespace
}  // namespace felt::desktop::layers_panel_test
