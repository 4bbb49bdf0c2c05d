#include "desktop/files/clipboard.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QImage>

#include "desktop/files/clipboard_actions.h"
#include "desktop/files/drawing_file.h"
#include "desktop/files/testing/studio_fixture.h"
#include "felt/io/testing/test_drawings.h"

namespace felt::desktop::clipboard_test {
namespace {

using felt::testing::strokes_in;

TEST(Clipboard, StrokesComeBackExactlyByBothRoutes) {
  StudioFixture fixture;
  fixture.draw(1, 5);
  const Drawing drawing{.document = fixture.document()};
  const auto own = strokes_mime(drawing);
  EXPECT_TRUE(own->hasImage());
  EXPECT_EQ(drawing_of(*own).value().drawing.document, drawing.document);
  EXPECT_EQ(strokes_in(drawing_of(*svg_mime(drawing)).value().drawing.document),
            strokes_in(drawing.document));
  EXPECT_EQ(drawing_of(*png_mime(drawing)).value().drawing.document.stroke_count(), 0u);
  QMimeData bad;
  bad.setData(QString::fromLatin1(kStrokesMime), "{nonsense}\n");
  EXPECT_FALSE(drawing_of(bad));
}

TEST(Clipboard, NamesGoAlongIfTheyAreFree) {
  StudioFixture fixture;
  fixture.draw(1, 2);
  Drawing made = fixture.files->drawing();
  made.names = std::make_shared<const StrokeNames>(StrokeNames{{StrokeId{1}, "cat-1"}});
  ASSERT_TRUE(write_drawing(fixture.at("named.felt"), made));
  fixture.person->unsaved = FileDialogs::Unsaved::kDiscard;
  ASSERT_TRUE(fixture.files->open(fixture.at("named.felt")));
  ImportReport said;
  QObject::connect(fixture.files, &FileActions::taken, &fixture.window,
                   [&said](const QString&, const ImportReport& report) { said = report; });
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  fixture.actions.find(QStringLiteral("edit.copy"))->trigger();
  fixture.actions.find(QStringLiteral("edit.paste"))->trigger();
  EXPECT_EQ(fixture.document().stroke_count(), 4u);
  EXPECT_EQ(used_names(fixture.files->drawing()), (StrokeNames{{StrokeId{1}, "cat-1"}}));
  EXPECT_TRUE(said.empty()) << "a copy in the same drawing has no name of its own";
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  fixture.actions.find(QStringLiteral("edit.cut"))->trigger();
  EXPECT_TRUE(used_names(fixture.files->drawing()).empty());
  fixture.actions.find(QStringLiteral("edit.paste"))->trigger();
  const StrokeNames names = used_names(fixture.files->drawing());
  ASSERT_EQ(names.size(), 1u);
  EXPECT_EQ(names.begin()->second, "cat-1");
  EXPECT_TRUE(said.empty());
  StudioFixture other;
  other.actions.find(QStringLiteral("edit.paste"))->trigger();
  ASSERT_EQ(used_names(other.files->drawing()).size(), 1u) << "another drawing gets it, too";
}

TEST(Clipboard, DrawingsOfOtherProgramsArePastedByTypeAndAsText) {
  const char* svg =
      "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' viewBox='0 0 100 100'>"
      "<path d='M10 10L50 40' stroke='red' fill='none'/><text>no ink</text></svg>";
  QMimeData typed, text, prose;
  typed.setData(QStringLiteral("image/svg+xml"), svg);
  text.setText(QString::fromUtf8(svg));
  prose.setText(QStringLiteral("Dear all,"));
  for (const QMimeData* data : {&typed, &text}) {
    const auto pasted = drawing_of(*data);
    ASSERT_TRUE(pasted) << pasted.error().message;
    EXPECT_EQ(pasted->drawing.document.stroke_count(), 1u);
    EXPECT_FALSE(pasted->report.empty());
  }
  EXPECT_EQ(drawing_of(prose).value().drawing.document.stroke_count(), 0u);
  StudioFixture fixture;
  QSignalSpy taken(fixture.files, &FileActions::taken);
  auto* copy = new QMimeData;
  copy->setText(QString::fromUtf8(svg));
  QGuiApplication::clipboard()->setMimeData(copy);
  fixture.actions.find(QStringLiteral("edit.paste"))->trigger();
  EXPECT_EQ(fixture.document().stroke_count(), 1u);
  ASSERT_EQ(taken.count(), 1);
}

TEST(Clipboard, ACopyHasOnlyTheLayersThatAreInView) {
  StudioFixture fixture;
  fixture.draw(1, 5);
  const LayerId first = fixture.studio.session().layer();
  fixture.studio.apply(LayerEvent{});
  fixture.draw(2, 5);
  const std::size_t all = fixture.document().stroke_count();
  const std::size_t below = fixture.document().layer(first)->strokes.size();
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kNone});
  const auto copied = [&fixture] {
    fixture.actions.find(QStringLiteral("edit.copy"))->trigger();
    return drawing_of(*QGuiApplication::clipboard()->mimeData())
        .value()
        .drawing.document.stroke_count();
  };
  ASSERT_GT(below, 0U);
  EXPECT_EQ(copied(), all);
  fixture.studio.apply(UseView{{first}});
  EXPECT_EQ(copied(), all - below);
}

TEST(Clipboard, TheLargestDrawingStillGivesAPicture) {
  StrokeData data;
  data.points = {{0, 0}, {100, 0}, {9e4, 9e4}, {1e5, 1e5}};
  data.widths = {{0.0, 1.0}, {1.0, 1.0}};
  const Drawing drawing = felt::testing::drawing_of({Stroke::create(data).value()});
  EXPECT_FALSE(qvariant_cast<QImage>(png_mime(drawing)->imageData()).isNull());
}

TEST(Clipboard, CopyAndPasteIsOneStepBesideTheFirst) {
  StudioFixture fixture;
  fixture.draw(1, 2);
  const std::vector<Stroke> before = strokes_in(fixture.document());
  fixture.actions.find(QStringLiteral("edit.copy"))->trigger();
  fixture.actions.find(QStringLiteral("edit.paste"))->trigger();
  const std::vector<Stroke> after = strokes_in(fixture.document());
  ASSERT_EQ(after.size(), 4u);
  EXPECT_EQ(after[2].data().points[0].x, before[0].data().points[0].x + 5.0);
  fixture.actions.find(QStringLiteral("edit.paste"))->trigger();
  EXPECT_EQ(strokes_in(fixture.document())[4].data().points[0].y,
            before[0].data().points[0].y + 10.0);
  EXPECT_TRUE(fixture.studio.apply(UndoEvent{}));
  EXPECT_TRUE(fixture.studio.apply(UndoEvent{}));
  EXPECT_EQ(strokes_in(fixture.document()), before);
}

TEST(Clipboard, CutTakesWhatIsSelectedAndPasteGivesItBack) {
  StudioFixture fixture;
  fixture.draw(1, 2);
  const std::vector<Stroke> before = strokes_in(fixture.document());
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kNone});
  EXPECT_FALSE(fixture.actions.find(QStringLiteral("edit.cut"))->isEnabled());
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  EXPECT_TRUE(fixture.actions.find(QStringLiteral("edit.cut"))->isEnabled());
  fixture.actions.find(QStringLiteral("edit.cut"))->trigger();
  EXPECT_EQ(fixture.document().stroke_count(), 0u);
  fixture.actions.find(QStringLiteral("edit.paste"))->trigger();
  EXPECT_EQ(strokes_in(fixture.document()), before);
}

void trigger(StudioFixture& fixture, const char* action) {
  fixture.actions.find(QString::fromLatin1(action))->trigger();
}

TEST(Clipboard, MediaGoAlongWithTheStrokes) {
  const std::vector<std::string> chalk{write_material(soft_chalk(0.4))};
  StudioFixture fixture;
  fixture.studio.apply(UseMaterial{chalk[0]});
  fixture.draw_with("soft-chalk");
  for (const char* copy : {"edit.copy", "edit.copy_as_svg"}) {
    trigger(fixture, copy);
    StudioFixture other;
    QSignalSpy taken(other.files, &FileActions::taken);
    trigger(other, "edit.paste");
    EXPECT_EQ(other.document().stroke_count(), 1u) << copy;
    EXPECT_EQ(other.texts(), chalk) << copy;
    ASSERT_EQ(taken.count(), 1);
    EXPECT_TRUE(qvariant_cast<felt::ImportReport>(taken.at(0).at(1)).empty()) << copy;
  }
  // A medium that has other figures here stays, and the user is informed.
  StudioFixture other;
  other.studio.apply(UseMaterial{write_material(soft_chalk(0.6))});
  QSignalSpy taken(other.files, &FileActions::taken);
  trigger(fixture, "edit.copy");
  trigger(other, "edit.paste");
  EXPECT_EQ(other.texts(), std::vector<std::string>{write_material(soft_chalk(0.6))});
  ASSERT_EQ(taken.count(), 1);
  EXPECT_FALSE(qvariant_cast<felt::ImportReport>(taken.at(0).at(1)).empty());
}

TEST(Clipboard, TextsOfMaterialsThatNobodyVouchesFor) {
  StudioFixture fixture;
  fixture.draw_with("soft-chalk");  // this medium is unknown
  const Drawing drawing{.document = fixture.document()};
  EXPECT_FALSE(strokes_mime(drawing)->hasFormat(QString::fromLatin1(kMaterialsMime)));
  const auto pasted = [&drawing](const QByteArray& materials) {
    QMimeData data;
    const QString own = QString::fromLatin1(kStrokesMime);
    data.setData(own, strokes_mime(drawing)->data(own));
    if (!materials.isNull()) data.setData(QString::fromLatin1(kMaterialsMime), materials);
    const Result<Imported> read = drawing_of(data);
    EXPECT_TRUE(read);
    EXPECT_EQ(read.value().drawing.document.stroke_count(), 1u);
    return read.value().drawing.materials;
  };
  EXPECT_TRUE(pasted({}).empty()) << "as an older Feltline copies";
  for (const char* bad : {"", "nonsense", "{\"a\":1}", "[1,null,[\"x\"],\"\"]", "\"text\""}) {
    EXPECT_TRUE(pasted(bad).empty()) << bad;
  }
  EXPECT_EQ(pasted("[7,\"hello\",\"hello\"]"), std::vector<std::string>{"hello"});
  EXPECT_TRUE(pasted("[\"" + QByteArray(70'000, 'x') + "\"]").empty());
  EXPECT_TRUE(pasted("[\"a\"" + QByteArray(16 << 20, ' ') + "]").empty());
  QByteArray many = "[\"0\"";
  for (int i = 1; i < 200; ++i) many += ",\"" + QByteArray::number(i) + "\"";
  EXPECT_EQ(pasted(many + "]").size(), 64u);
  // An invalid text of a material, or one out of range, does not affect the strokes.
  Drawing odd = drawing;
  odd.materials = {"hello", "kind = \"medium\"\nid = \"soft-chalk\"\nmu = 1e9"};
  QGuiApplication::clipboard()->setMimeData(strokes_mime(odd).release());
  StudioFixture other;
  trigger(other, "edit.paste");
  EXPECT_EQ(other.document().stroke_count(), 1u);
  EXPECT_EQ(other.studio.materials().find_medium("soft-chalk"), nullptr);
}

TEST(Clipboard, FillsAreCopiedWithAllTheirLines) {
  StudioFixture fixture;
  fixture.draw_filled_squares();
  ASSERT_EQ(fixture.document().fill_count(), 3u);
  const auto copied_fills = [&] {
    trigger(fixture, "edit.copy");
    StudioFixture other;
    trigger(other, "edit.paste");
    return other.document().fill_count();
  };
  EXPECT_EQ(copied_fills(), 1u) << "the second square is selected";
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  EXPECT_EQ(copied_fills(), 2u) << "the fill without lines is not selected";
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kNone});
  EXPECT_EQ(copied_fills(), 3u) << "nothing is selected, so everything is copied";
}

TEST(Clipboard, FillsWithoutLinesArePastedAsFills) {
  StudioFixture fixture;
  fixture.draw_filled_squares();
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  trigger(fixture, "edit.copy");
  // Only the fill without lines remains.
  fixture.studio.apply(DeleteEvent{});
  ASSERT_EQ(fixture.document().stroke_count(), 0u);
  ASSERT_EQ(fixture.document().fill_count(), 1u);
  trigger(fixture, "edit.copy");
  StudioFixture other;
  trigger(other, "edit.paste_in_place");
  ASSERT_EQ(other.document().fill_count(), 1u);
  const auto box_of_last = [&other] {
    const FillId id = other.document().layers().front().fills.back();
    return fill_bounds(*other.document().find_fill(id));
  };
  EXPECT_EQ(box_of_last(), (Rect{10, 10, 40, 40}));
  for (const Layer& layer : other.document().layers()) EXPECT_EQ(layer.picture, nullptr);
  other.files->clipboard().paste_at({100, 50});
  ASSERT_EQ(other.document().fill_count(), 2u);
  EXPECT_EQ(box_of_last(), (Rect{85, 35, 115, 65}));
}

TEST(Clipboard, PastesAtThePointerOrInPlace) {
  StudioFixture fixture;
  fixture.studio.import(QStringLiteral("test"),
                        std::vector{std::make_shared<const Stroke>(
                            felt::testing::straight_stroke({10, 10}, {30, 20}, 1, 1))});
  const auto trigger = [&](const char* name) {
    fixture.actions.find(QString::fromLatin1(name))->trigger();
    return fixture.document().layers().front().strokes.back();
  };
  trigger("edit.copy");
  fixture.files->clipboard().set_pointer([] { return Point{100, 50}; });
  const StrokeId at_pointer = trigger("edit.paste");
  EXPECT_EQ(fixture.document().find(at_pointer)->position(0), (Point{90, 45}));
  EXPECT_TRUE(fixture.studio.session().selection().is_whole(at_pointer));
  EXPECT_EQ(fixture.studio.session().selection().strokes().size(), 1U);
  EXPECT_EQ(fixture.document().find(trigger("edit.paste_in_place"))->position(0), (Point{10, 10}));
  fixture.files->clipboard().set_pointer([] { return std::nullopt; });
  EXPECT_EQ(fixture.document().find(trigger("edit.paste"))->position(0), (Point{15, 15}));
  fixture.files->clipboard().paste_at({20, 15});
  EXPECT_EQ(fixture.document().stroke_count(), 5U);
}

}  // namespace
}  // namespace felt::desktop::clipboard_test
