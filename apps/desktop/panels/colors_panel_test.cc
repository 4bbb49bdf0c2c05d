#include "desktop/panels/colors_panel.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <random>
#include <set>

#include "desktop/engine/settings.h"
#include "desktop/panels/panel_setting_keys.h"
#include "desktop/panels/testing/panels_fixture.h"
#include "felt/document/visible_strokes.h"
#include "felt/stroke/color_text.h"

namespace felt::desktop::colors_panel_test {
namespace {

using testing::still;

/// A panel without stored colours.
class ColorsPanelTest : public ::testing::Test {
 protected:
  ColorsPanelTest() {
    for (const char* key : {panel_keys::kRecentColors, panel_keys::kOwnColors,
                            panel_keys::kPaletteFiles, panel_keys::kPalette}) {
      Settings::the().set(QString::fromLatin1(key), {});
    }
    panel = std::make_unique<ColorsPanel>(studio);
    panel->resize(260, 420);
    panel->show();
  }
  [[nodiscard]] std::string color() const {
    return std::get<std::string>(studio.session().option("ink.color").value());
  }
  void type(const QString& number) {
    auto* field = panel->findChild<QLineEdit*>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, number);
    QTest::keyClick(field, Qt::Key_Return);
  }
  SwatchView* swatches(int i) { return panel->findChildren<SwatchView*>()[i]; }
  QString write(const char* name, const QByteArray& text) {
    QFile file(folder.filePath(QString::fromLatin1(name)));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }

  QTemporaryDir folder;
  Studio studio{still()};
  std::unique_ptr<ColorsPanel> panel;
};

TEST_F(ColorsPanelTest, ADrawingsPaletteIsOfferedWhileItIsThere) {
  auto* list = panel->findChild<QComboBox*>();
  const int usual = list->count();
  const Palette leaves{"Leaves", 0, {{{10, 90, 20, 255}, "leaf"}}};
  panel->show_drawing_palette(leaves);
  EXPECT_EQ(list->count(), usual + 1);
  EXPECT_EQ(list->currentText(), QStringLiteral("Leaves"));
  EXPECT_EQ(panel->shown_palette(), leaves);
  panel->show_drawing_palette({});
  EXPECT_EQ(list->count(), usual);
  const Palette usual_one = panel->shown_palette();
  panel->show_drawing_palette(usual_one);  // is in the list already
  EXPECT_EQ(list->count(), usual);
  EXPECT_EQ(panel->shown_palette(), usual_one);
}

TEST_F(ColorsPanelTest, TakesANumberInEveryForm) {
  type(QStringLiteral("#1f4e8c"));
  EXPECT_EQ(color(), "#1f4e8c");
  type(QStringLiteral("fa0"));
  EXPECT_EQ(color(), "#ffaa00");
  type(QStringLiteral("#11223380"));
  EXPECT_EQ(color(), "#11223380");
  type(QStringLiteral("#445566"));
  EXPECT_EQ(color(), "#44556680") << "the opacity stays";
  type(QStringLiteral("#4455"));
  EXPECT_EQ(color(), "#44556680") << "half a number is none";
}

TEST_F(ColorsPanelTest, OpacityIsItsOwnField) {
  studio.apply(SetOption{"ink.color", std::string("#204060")});
  auto* opacity = panel->findChild<QSpinBox*>();
  EXPECT_EQ(opacity->value(), 100);
  opacity->setFocus();
  opacity->selectAll();
  QTest::keyClicks(opacity, QStringLiteral("40"));
  QTest::keyClick(opacity, Qt::Key_Return);
  EXPECT_EQ(color(), "#20406066");
  EXPECT_EQ(opacity->value(), 40);
}

TEST_F(ColorsPanelTest, TheFieldGivesEveryShadeByMouseAndKeys) {
  studio.apply(SetOption{"ink.color", std::string("#ff0000")});
  auto* shade = panel->findChild<ShadeField*>();
  auto* strip = panel->findChild<HueStrip*>();
  QTest::mouseClick(shade, Qt::LeftButton, {}, {0, shade->height() - 1});
  EXPECT_EQ(color(), "#000000");
  QTest::mouseClick(shade, Qt::LeftButton, {}, {1, 1});
  EXPECT_EQ(color(), "#ffffff");
  QTest::mouseClick(shade, Qt::LeftButton, {}, {shade->width() - 1, 0});
  EXPECT_EQ(color(), "#ff0000") << "white and black keep the hue they came from";
  strip->setFocus();
  for (int i = 0; i < 34; ++i) QTest::keyClick(strip, Qt::Key_Down);
  const QColor green(QString::fromStdString(color()));
  EXPECT_NEAR(green.hueF(), 0.34, 0.01);
  shade->setFocus();
  for (int i = 0; i < 5; ++i) QTest::keyClick(shade, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_NEAR(QColor(QString::fromStdString(color())).valueF(), 0.5, 0.01);
  QTest::keyClick(shade, Qt::Key_Left);
  EXPECT_NEAR(QColor(QString::fromStdString(color())).hsvSaturationF(), 0.99, 0.01);
}

TEST_F(ColorsPanelTest, ShowsAnyColourThatOthersChooseAndChangesNone) {
  std::mt19937 random(3);
  QSignalSpy changes(&studio, &Studio::option_changed);
  for (int i = 0; i < 300; ++i) {
    const Rgba wanted{std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random()),
                      std::uint8_t(random())};
    studio.apply(SetOption{"ink.color", color_to_text(wanted)});
    EXPECT_EQ(color(), color_to_text(wanted));
    EXPECT_EQ(rgba(panel->findChild<ColorField*>()->color()), (Rgba{wanted.r, wanted.g, wanted.b}));
  }
  EXPECT_EQ(changes.count(), 300);
}

TEST_F(ColorsPanelTest, ASwatchIsChosenByClickAndByKeys) {
  SwatchView* palette = swatches(1);
  ASSERT_GT(palette->colors().size(), 10U);
  const QRect third = palette->visualRect(palette->model()->index(2, 0));
  QTest::mouseClick(palette->viewport(), Qt::LeftButton, {}, third.center());
  EXPECT_EQ(color(), color_to_text(palette->colors()[2].color));
  EXPECT_EQ(palette->marked(), palette->colors()[2].color);
  palette->setFocus();
  QTest::keyClick(palette, Qt::Key_Right);
  QTest::keyClick(palette, Qt::Key_Return);
  EXPECT_EQ(color(), color_to_text(palette->colors()[3].color));
  EXPECT_FALSE(palette->model()->index(3, 0).data(Qt::AccessibleTextRole).toString().isEmpty());
}

TEST_F(ColorsPanelTest, RemembersWhatWasDrawnWith) {
  EXPECT_TRUE(swatches(0)->colors().empty());
  for (const char* one : {"#102030", "#405060", "#102030"}) {
    studio.apply(SetOption{"ink.color", std::string(one)});
    testing::draw_lines(studio, 2);
  }
  studio.apply(SetOption{"ink.color", std::string("#ffffff")});
  const std::vector<NamedColor> wanted = {{{16, 32, 48}, {}}, {{64, 80, 96}, {}}};
  EXPECT_EQ(swatches(0)->colors(), wanted)
      << "newest first, each once, and none that was only seen";
  Studio other(still());
  ColorsPanel again(other);
  EXPECT_EQ(again.findChildren<SwatchView*>()[0]->colors(), wanted) << "kept for the next start";
  for (int i = 0; i < 40; ++i) {
    studio.apply(SetOption{"ink.color", color_to_text({std::uint8_t(i), 0, 0})});
    testing::draw_lines(studio, 1);
  }
  EXPECT_EQ(swatches(0)->colors().size(), 16U);
}

TEST_F(ColorsPanelTest, OpensAPaletteKeepsItAndWritesItAgain) {
  const QByteArray text = "GIMP Palette\nName: Mine\n#\n  1   2   3\tOne\n250 128   0\tTwo\n";
  const QString path = write("mine.gpl", text);
  ASSERT_TRUE(panel->open_palette(path));
  EXPECT_EQ(panel->findChild<QComboBox*>()->currentText(), QStringLiteral("mine"));
  ASSERT_EQ(swatches(1)->colors().size(), 2U);
  EXPECT_EQ(swatches(1)->colors()[1], (NamedColor{{250, 128, 0}, "Two"}));
  const QString copy = folder.filePath(QStringLiteral("copy.gpl"));
  ASSERT_TRUE(panel->export_palette(copy));
  EXPECT_EQ(load_palette(copy).value(), load_palette(path).value());
  ColorsPanel again(studio);
  EXPECT_EQ(again.findChild<QComboBox*>()->currentText(), QStringLiteral("mine"));
  EXPECT_EQ(again.findChildren<SwatchView*>()[1]->colors().size(), 2U);
  ASSERT_TRUE(QFile::remove(path));
  const ColorsPanel without(studio);
  EXPECT_EQ(without.findChild<QComboBox*>()->findText(QStringLiteral("mine")), -1);
}

TEST_F(ColorsPanelTest, SaysWhatIsWrongWithAFile) {
  QSignalSpy refused(&studio, &Studio::refused);
  const QString bad = write("bad.gpl", "GIMP Palette\n1 2\n");
  EXPECT_FALSE(panel->open_palette(bad));
  EXPECT_FALSE(panel->open_palette(folder.filePath(QStringLiteral("none.gpl"))));
  EXPECT_FALSE(panel->export_palette(folder.filePath(QStringLiteral("no/such/folder.gpl"))));
  ASSERT_EQ(refused.count(), 3);
  EXPECT_TRUE(refused[0][0].toString().endsWith(
      QLatin1String("bad.gpl:2: a colour is three numbers from 0 to 255 and a name")));
  EXPECT_TRUE(refused[1][0].toString().contains(QLatin1String("none.gpl: ")));
}

TEST_F(ColorsPanelTest, TakesADroppedPaletteAndNothingElse) {
  const QString path = write("drop.gpl", "GIMP Palette\n9 9 9\n");
  const auto drop = [this](const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    enter.ignore();
    QCoreApplication::sendEvent(panel.get(), &enter);
    QDropEvent event({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    if (enter.isAccepted()) QCoreApplication::sendEvent(panel.get(), &event);
    return enter.isAccepted();
  };
  EXPECT_FALSE(drop(write("drop.txt", "GIMP Palette\n9 9 9\n")));
  EXPECT_TRUE(drop(path));
  EXPECT_EQ(swatches(1)->colors().size(), 1U);
}

TEST_F(ColorsPanelTest, KeepsColoursOfThePersonsOwn) {
  QWidget window;
  Actions actions(&window);
  add_color_actions(actions, *panel);
  studio.apply(SetOption{"ink.color", std::string("#0a0b0c")});
  actions.find(QStringLiteral("edit.palette_keep"))->trigger();
  actions.find(QStringLiteral("edit.palette_keep"))->trigger();
  ASSERT_EQ(swatches(1)->colors().size(), 1U);
  EXPECT_EQ(swatches(1)->colors()[0].color, (Rgba{10, 11, 12}));
  actions.find(QStringLiteral("edit.palette_drop"))->trigger();
  EXPECT_GT(swatches(1)->colors().size(), 1U) << "an empty palette is not offered";
}

TEST_F(ColorsPanelTest, NotesFaintColoursOnThePaper) {
  const auto note = [this] {
    for (const QLabel* label : panel->findChildren<QLabel*>()) {
      if (label->text().contains(QLatin1String(":1"))) return label->text().toStdString();
    }
    return std::string();
  };
  studio.apply(SetOption{"ink.color", std::string("#000000")});
  EXPECT_EQ(note(), "Contrast with the paper: 21.0:1");
  studio.set_page({.paper = {0, 0, 0, 255}});
  EXPECT_EQ(note(), "Low contrast with the paper: 1.0:1");
}

TEST_F(ColorsPanelTest, NamesEveryControl) {
  testing::draw_lines(studio, 1);
  EXPECT_EQ(testing::nameless(*panel), std::vector<std::string>{});
}

TEST(Palettes, OursHaveColoursAndNamesAndCanBeWritten) {
  for (const PaletteSource& source : built_in_palettes()) {
    SCOPED_TRACE(source.title.toStdString());
    EXPECT_GE(source.palette.colors.size(), 8U);
    for (const NamedColor& entry : source.palette.colors) EXPECT_FALSE(entry.name.empty());
    EXPECT_EQ(read_gpl("p", write_gpl(source.palette)).value(), source.palette);
  }
}

TEST(ColorsPanel, ASwatchIsForTheSelectedLinesToo) {
  Studio studio(still());
  ColorsPanel panel(studio);
  testing::draw_lines(studio, 3);
  studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  const std::size_t steps = studio.session().history().undo_count();
  SwatchView* swatches = panel.findChildren<SwatchView*>().back();
  const Rgba wanted{10, 120, 200, 255};
  Q_EMIT swatches->chosen(wanted);
  for (const StrokePtr& stroke : visible_strokes(studio.session().document())) {
    EXPECT_EQ(stroke->color(), wanted);
  }
  EXPECT_EQ(studio.session().history().undo_count(), steps + 1);
  EXPECT_EQ(studio.session().ink_color(), wanted);
}

TEST(ColorsPanel, ADragAnOpacityAndANumberAreForTheSelectedLinesToo) {
  Studio studio(still());
  ColorsPanel panel(studio);
  panel.resize(260, 420);
  panel.show();
  testing::draw_lines(studio, 2);
  studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  const auto steps = [&] { return studio.session().history().undo_count(); };
  const auto colors = [&] {
    std::set<std::string> all;
    for (const StrokePtr& stroke : visible_strokes(studio.session().document())) {
      all.insert(color_to_text(stroke->color()));
    }
    return all;
  };
  const std::size_t first = steps();
  auto* field = panel.findChild<ShadeField*>();
  QTest::mousePress(field, Qt::LeftButton, {}, {20, 20});
  for (int x = 25; x < 100; x += 5) QTest::mouseMove(field, {x, 30});
  EXPECT_EQ(steps(), first) << "not while the mouse is pressed";
  QTest::mouseRelease(field, Qt::LeftButton, {}, {100, 30});
  EXPECT_EQ(steps(), first + 1);
  EXPECT_EQ(colors(), std::set{color_to_text(studio.session().ink_color())});
  panel.findChild<QSpinBox*>()->setValue(50);
  EXPECT_EQ(steps(), first + 2);
  EXPECT_EQ(colors(), std::set{color_to_text(studio.session().ink_color())});
  auto* number = panel.findChild<QLineEdit*>(QStringLiteral("color_number"));
  number->setFocus();
  number->clear();
  QTest::keyClicks(number, QStringLiteral("204060"));
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(steps(), first + 3);
  EXPECT_EQ(colors(), std::set<std::string>{"#2040607f"});
}

}  // namespace
}  // namespace felt::desktop::colors_panel_test
