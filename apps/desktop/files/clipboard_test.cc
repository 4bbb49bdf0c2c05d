#include "desktop/files/clipboard.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QImage>

#include "desktop/files/test_desk.h"
#include "felt/document/visible_strokes.h"

namespace felt::desktop {
namespace {

std::vector<Stroke> strokes_in(const Sketch& sketch) {
  std::vector<Stroke> strokes;
  for (const SketchStroke& s : sketch) strokes.push_back(s.stroke);
  return strokes;
}

TEST(Clipboard, StrokesComeBackExactlyByBothRoutes) {
  TestDesk desk;
  desk.draw(1, 5);
  const Sketch sketch = visible_strokes(desk.document());
  const auto own = strokes_mime(sketch);
  EXPECT_TRUE(own->hasImage());
  EXPECT_EQ(strokes_in(strokes_of(*own).value().sketch), strokes_in(sketch));
  EXPECT_EQ(strokes_in(strokes_of(*svg_mime(sketch)).value().sketch), strokes_in(sketch));
  EXPECT_TRUE(strokes_of(*png_mime(sketch)).value().sketch.empty());
  QMimeData bad;
  bad.setData(QString::fromLatin1(kStrokesMime), "{nonsense}\n");
  EXPECT_FALSE(strokes_of(bad));
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
    const auto pasted = strokes_of(*data);
    ASSERT_TRUE(pasted) << pasted.error().message;
    EXPECT_EQ(pasted->sketch.size(), 1u);
    EXPECT_FALSE(pasted->report.empty());
  }
  EXPECT_TRUE(strokes_of(prose).value().sketch.empty());
  TestDesk desk;
  QSignalSpy taken(desk.files, &FileActions::taken);
  auto* copy = new QMimeData;
  copy->setText(QString::fromUtf8(svg));
  QGuiApplication::clipboard()->setMimeData(copy);
  desk.actions.find(QStringLiteral("edit.paste"))->trigger();
  EXPECT_EQ(desk.document().stroke_count(), 1u);
  ASSERT_EQ(taken.count(), 1);
}

TEST(Clipboard, TheLargestDrawingStillGivesAPicture) {
  StrokeData data;
  data.points = {{0, 0}, {100, 0}, {9e4, 9e4}, {1e5, 1e5}};
  data.widths = {{0.0, 1.0}, {1.0, 1.0}};
  const Sketch sketch{{"s", Stroke::create(data).value()}};
  EXPECT_FALSE(qvariant_cast<QImage>(png_mime(sketch)->imageData()).isNull());
}

TEST(Clipboard, CopyAndPasteIsOneStepBesideTheFirst) {
  TestDesk desk;
  desk.draw(1, 2);
  const Sketch before = visible_strokes(desk.document());
  desk.actions.find(QStringLiteral("edit.copy"))->trigger();
  desk.actions.find(QStringLiteral("edit.paste"))->trigger();
  const Sketch after = visible_strokes(desk.document());
  ASSERT_EQ(after.size(), 4u);
  EXPECT_EQ(after[2].stroke.data().points[0].x, before[0].stroke.data().points[0].x + 5.0);
  desk.actions.find(QStringLiteral("edit.paste"))->trigger();
  EXPECT_EQ(visible_strokes(desk.document())[4].stroke.data().points[0].y,
            before[0].stroke.data().points[0].y + 10.0);
  EXPECT_TRUE(desk.studio.apply(UndoEvent{}));
  EXPECT_TRUE(desk.studio.apply(UndoEvent{}));
  EXPECT_EQ(visible_strokes(desk.document()), before);
}

TEST(Clipboard, CutTakesWhatIsSelectedAndPasteGivesItBack) {
  TestDesk desk;
  desk.draw(1, 2);
  const std::vector<Stroke> before = strokes_in(visible_strokes(desk.document()));
  EXPECT_FALSE(desk.actions.find(QStringLiteral("edit.cut"))->isEnabled());
  desk.studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  EXPECT_TRUE(desk.actions.find(QStringLiteral("edit.cut"))->isEnabled());
  desk.actions.find(QStringLiteral("edit.cut"))->trigger();
  EXPECT_EQ(desk.document().stroke_count(), 0u);
  desk.actions.find(QStringLiteral("edit.paste"))->trigger();
  EXPECT_EQ(strokes_in(visible_strokes(desk.document())), before);
}

}  // namespace
}  // namespace felt::desktop
