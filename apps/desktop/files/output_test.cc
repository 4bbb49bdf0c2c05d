#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QImageReader>
#include <QLabel>
#include <QPainter>
#include <QRadioButton>
#include <QTest>
#include <algorithm>

#include "desktop/files/export_dialog.h"
#include "desktop/files/format_texts.h"
#include "desktop/files/page_dialog.h"
#include "desktop/files/page_picture.h"
#include "desktop/files/printed_page.h"
#include "desktop/files/swell_words.h"
#include "desktop/files/testing/studio_fixture.h"
#include "felt/base/read_file.h"
#include "felt/document/edit_builder.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_grain.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::output_test {
namespace {

TEST(Export, EveryFormatIsWritten) {
  StudioFixture fixture;
  fixture.draw(1, 4);
  const Drawing drawing = fixture.files->drawing();
  ASSERT_TRUE(export_drawing(fixture.at("a.svg"), drawing, {.format = FileFormat::kSvg}));
  EXPECT_EQ(read_drawing(fixture.at("a.svg")).value().document.stroke_count(), 4u);
  ASSERT_TRUE(export_drawing(fixture.at("a.pdf"), drawing, {.format = FileFormat::kPdf}));
  EXPECT_EQ(read_file(fixture.at("a.pdf").toStdString(), 1 << 24).value().substr(0, 8), "%PDF-1.4");
  ASSERT_TRUE(
      export_drawing(fixture.at("a.png"), drawing, {.format = FileFormat::kPng, .dpi = 254.0}));
  EXPECT_EQ(QImageReader(fixture.at("a.png")).size(), QSize(2970, 2100));
  ASSERT_TRUE(export_drawing(
      fixture.at("b.png"), drawing,
      {.format = FileFormat::kPng, .dpi = 254.0, .background = false, .part = ExportPart::kInk}));
  const QImage ink(fixture.at("b.png"));
  EXPECT_LT(ink.width(), 2970);
  EXPECT_EQ(ink.pixelColor(0, 0).alpha(), 0);
  EXPECT_FALSE(export_drawing(fixture.at("no/a.pdf"), drawing, {.format = FileFormat::kPdf}));
}

TEST(Export, ForSwellPaperOnlyBlackIsWrittenAndTheChangesAreCounted) {
  StudioFixture fixture;
  fixture.draw(1, 4);
  const Drawing drawing = fixture.files->drawing();
  ExportOptions options{.format = FileFormat::kSvg, .grain = true};
  options.swell = true;
  SwellReport report;
  ASSERT_TRUE(export_drawing(fixture.at("swell.svg"), drawing, options, &report));
  EXPECT_EQ(report.lines + report.unseen_lines, 4u);
  const std::string text = read_file(fixture.at("swell.svg").toStdString(), 1 << 24).value();
  EXPECT_NE(text.find("width=\"297mm\""), std::string::npos);
  EXPECT_EQ(text.find("<image"), std::string::npos);
  EXPECT_FALSE(swell_words(report).isEmpty());
  EXPECT_TRUE(swell_words({}).isEmpty());
  ExportDialog dialog(drawing, {}, nullptr);
  auto* format = dialog.findChildren<QComboBox*>().front();
  EXPECT_EQ(format->itemData(0).toString(), QStringLiteral("png")) << "most often wanted";
  EXPECT_GE(format->count(), 5);
  for (QCheckBox* box : dialog.findChildren<QCheckBox*>()) {
    if (box->text().remove(QLatin1Char('&')) != QStringLiteral("For swell paper")) continue;
    format->setCurrentIndex(format->findData(QStringLiteral("png")));
    EXPECT_FALSE(box->isEnabled());
    format->setCurrentIndex(format->findData(QStringLiteral("pdf")));
    EXPECT_TRUE(box->isEnabled());
    box->setChecked(true);
    EXPECT_TRUE(dialog.options().swell);
    box->setChecked(false);
    EXPECT_FALSE(dialog.options().swell);
  }
}

TEST(Export, TheSelectionOnlyAndASmallSvg) {
  StudioFixture fixture;
  fixture.draw(1, 4);
  const Drawing drawing = fixture.files->drawing();
  const std::vector<StrokeId>& ids = drawing.document.layers().front().strokes;
  ASSERT_EQ(ids.size(), 4u);
  Selection selection;
  selection.set_whole(ids[1], drawing.document.find(ids[1])->data().points.size());
  const Drawing part = selected_only(drawing, selection);
  ASSERT_EQ(part.document.stroke_count(), 1u);
  EXPECT_EQ(visible_strokes(part.document).front(), drawing.document.find(ids[1]));
  const ExportOptions options{.format = FileFormat::kSvg, .part = ExportPart::kSelection};
  const Rect area = export_area(ink_bounds(part.document), part.page, options);
  EXPECT_LT(area.width(), drawing.page.area().width());
  ASSERT_TRUE(export_drawing(fixture.at("part.svg"), part, options));
  EXPECT_EQ(read_drawing(fixture.at("part.svg")).value().document.stroke_count(), 1u);
  ASSERT_TRUE(export_drawing(fixture.at("all.svg"), drawing, {.format = FileFormat::kSvg}));
  ASSERT_TRUE(export_drawing(fixture.at("small.svg"), drawing,
                             {.format = FileFormat::kSvg, .grain = true, .compact = true}));
  EXPECT_LT(2 * QFileInfo(fixture.at("small.svg")).size(), QFileInfo(fixture.at("all.svg")).size());
}

TEST(Export, FillsGoWithTheSelectionIfItHasAllTheirLines) {
  StudioFixture fixture;
  fixture.draw_filled_squares();
  const Drawing drawing = fixture.files->drawing();
  ASSERT_EQ(drawing.document.fill_count(), 3u);
  const auto fills_with = [&](std::size_t from, std::size_t to) {
    Selection selection;
    for (std::size_t i = from; i <= to; ++i) {
      const StrokeId id = drawing.document.layers().back().strokes.at(i - 1);
      selection.set_whole(id, drawing.document.find(id)->data().points.size());
    }
    return selected_only(drawing, selection).document;
  };
  EXPECT_EQ(fills_with(1, 3).fill_count(), 0u) << "one line of the square is not selected";
  EXPECT_EQ(fills_with(1, 8).fill_count(), 2u) << "a fill without lines is not selected";
  const Document second = fills_with(4, 8);
  ASSERT_EQ(second.fill_count(), 1u);
  EXPECT_EQ(fill_bounds(*second.find_fill(second.layers().front().fills.front())),
            (Rect{60, 10, 90, 40}));
  const Document first = fills_with(1, 4);
  ASSERT_TRUE(export_drawing(fixture.at("a.svg"), Drawing{.document = first},
                             {.format = FileFormat::kSvg, .part = ExportPart::kSelection}));
  EXPECT_EQ(read_drawing(fixture.at("a.svg")).value().document.fill_count(), 1u);
}

TEST(Export, TheDialogOffersTheSelectedLinesIfThereAreAny) {
  StudioFixture fixture;
  fixture.draw(1, 2);
  const Drawing drawing = fixture.files->drawing();
  const auto parts = [](ExportDialog& dialog) { return dialog.findChildren<QComboBox*>()[1]; };
  ExportDialog none(drawing, {}, nullptr);
  EXPECT_EQ(parts(none)->count(), 2);
  ExportDialog some(drawing, select_all(drawing.document), nullptr);
  ASSERT_EQ(parts(some)->count(), 3);
  parts(some)->setCurrentIndex(2);
  EXPECT_EQ(some.options().part, ExportPart::kSelection);
}

TEST(Export, TheDialogSaysWhatComesOut) {
  StudioFixture fixture;
  fixture.draw(1, 4);
  ExportDialog dialog(fixture.files->drawing(), {}, nullptr);
  const auto combos = dialog.findChildren<QComboBox*>();
  const auto shows = [&dialog](const QString& text) {
    for (const QLabel* label : dialog.findChildren<QLabel*>()) {
      if (label->text().contains(text)) return true;
    }
    return false;
  };
  combos[0]->setCurrentIndex(combos[0]->findData(QStringLiteral("png")));
  EXPECT_TRUE(shows(format_kept(FileFormat::kPng)));
  dialog.findChild<QDoubleSpinBox*>()->setValue(254.0);
  EXPECT_TRUE(shows(QStringLiteral("pixels")));
  EXPECT_EQ(dialog.options().format, FileFormat::kPng);
  EXPECT_EQ(dialog.options().dpi, 254.0);
  QComboBox* scale = combos.back();
  EXPECT_EQ(scale->currentIndex(), -1) << "254 is no whole factor";
  scale->setCurrentIndex(1);
  Q_EMIT scale->activated(1);
  EXPECT_EQ(dialog.options().dpi, 192.0);
  dialog.findChild<QDoubleSpinBox*>()->setValue(288.0);
  EXPECT_EQ(scale->currentText(), QStringLiteral("3×"));
  combos[0]->setCurrentIndex(combos[0]->findData(QStringLiteral("pdf")));
  EXPECT_TRUE(shows(format_kept(FileFormat::kPdf)));
  EXPECT_FALSE(shows(QStringLiteral("pixels")));
  // Exports what the screen shows, unless an option is switched off. A picture has the chosen dots
  // per inch.
  const auto boxes = dialog.findChildren<QCheckBox*>();
  const auto grain = std::find_if(boxes.begin(), boxes.end(), [](const QCheckBox* box) {
    return box->text().contains(QStringLiteral("Grain"));
  });
  ASSERT_NE(grain, boxes.end());
  EXPECT_TRUE((*grain)->isChecked());
  EXPECT_TRUE(dialog.findChild<QDoubleSpinBox*>()->isEnabled());
  (*grain)->setChecked(false);
  EXPECT_FALSE(dialog.options().grain);
  EXPECT_FALSE(dialog.findChild<QDoubleSpinBox*>()->isEnabled());
  dialog.findChild<QCheckBox*>()->setChecked(false);
  EXPECT_FALSE(dialog.options().background);
}

TEST(PageSetup, PresetsAndOrientationAgreeWithTheSides) {
  PageDialog dialog({297.0, 210.0, {255, 255, 255, 255}}, nullptr);
  auto* preset = dialog.findChild<QComboBox*>();
  const auto sides = dialog.findChildren<QDoubleSpinBox*>();
  const auto ways = dialog.findChildren<QRadioButton*>();
  EXPECT_EQ(preset->currentText(), QStringLiteral("A4"));
  EXPECT_TRUE(ways[1]->isChecked());
  ways[0]->setChecked(true);
  EXPECT_EQ(dialog.page(), (Page{210.0, 297.0, {255, 255, 255, 255}}));
  preset->setCurrentIndex(0);
  Q_EMIT preset->activated(0);
  EXPECT_EQ(dialog.page(), (Page{148.0, 210.0, {255, 255, 255, 255}}));
  sides[0]->setValue(300.0);
  EXPECT_EQ(preset->currentText(), QStringLiteral("Custom"));
  EXPECT_TRUE(ways[1]->isChecked());
  sides[0]->setValue(420.0);
  sides[1]->setValue(594.0);
  EXPECT_EQ(preset->currentText(), QStringLiteral("A2"));
}

/// The clipboard, recovery, recent files and the preview of an export show this picture.
TEST(PagePicture, ShowsFillsAndTheNewestStrokes) {
  Document document;
  FillLoop loop{{{10, 10}}, {}};
  for (const Point to : {Point{50, 10}, Point{50, 30}, Point{10, 30}, Point{10, 10}}) {
    loop.points.insert(loop.points.end(), {loop.points.back(), to, to});
  }
  EditBuilder builder(document);
  builder.add_fill({1}, std::make_shared<const Fill>(Fill{{loop}, {200, 40, 0, 255}, 0.0}));
  for (const double y : {5.0, 35.0}) {
    Stroke line = testing::straight_stroke({5, y}, {55, y}, 2.0, 2.0);
    builder.add({1}, std::make_shared<const Stroke>(std::move(line)));
  }
  ASSERT_TRUE(document.apply(std::move(builder).build("Fill")));
  const Rect area{0, 0, 60, 40};
  const QImage all = page_picture(document, area, 1.0, {255, 255, 255, 255});
  EXPECT_EQ(all.pixelColor(30, 20), QColor(200, 40, 0));
  EXPECT_NE(all.pixelColor(30, 5), QColor(Qt::white));
  const QImage newest =
      page_thumbnail(with_newest_strokes(document, 1), area, {60, 40}, {255, 255, 255, 255});
  EXPECT_EQ(newest.pixelColor(30, 20), QColor(200, 40, 0));
  EXPECT_EQ(newest.pixelColor(30, 5), QColor(Qt::white)) << "the lower of two lines";
  EXPECT_NE(newest.pixelColor(30, 35), QColor(Qt::white));
}

// The option "Grain of the surface" applies to print and to every format that is a picture.
TEST(Export, GrainIsThatOfTheSurface) {
  StudioFixture fixture;
  fixture.studio.apply(SetOption{"surface.material", std::string("rough-paper")});
  fixture.draw(3, 6);
  fixture.studio.set_page({60.0, 40.0, {255, 255, 255, 255}, "rough-paper"});
  const Drawing drawing = fixture.files->drawing();
  EXPECT_EQ(drawing.page.surface, "rough-paper");
  const auto bytes = [&](FileFormat format, bool grain) {
    const QString path = fixture.at("x");
    EXPECT_TRUE(export_drawing(path, drawing, {.format = format, .dpi = 100.0, .grain = grain}));
    return read_file(path.toStdString(), 1 << 24).value();
  };
  for (const FileFormat format : {FileFormat::kPng, FileFormat::kSvg, FileFormat::kPdf}) {
    EXPECT_NE(bytes(format, true), bytes(format, false));
  }
  EXPECT_EQ(bytes(FileFormat::kInkml, true), bytes(FileFormat::kInkml, false));

  constexpr double kDpi = 300.0;
  const Grain grain = grain_of(drawing).value();
  const QImage ours =
      page_picture(drawing.document, drawing.page.area(), kDpi / 25.4, {255, 255, 255, 255}, grain);
  QImage painted(ours.size(), QImage::Format_RGBA8888_Premultiplied);
  painted.fill(Qt::white);
  QPainter painter(&painted);
  PrintedPage::create(drawing, kDpi, grain).value().paint(painter, kDpi);
  painter.end();
  double sum = 0.0;
  for (int y = 0; y < ours.height(); ++y) {
    for (int x = 0; x < ours.width(); ++x) {
      sum += std::abs(ours.pixelColor(x, y).green() - painted.pixelColor(x, y).green());
    }
  }
  EXPECT_LT(sum / (ours.width() * ours.height()), 1.0);
}

}  // namespace
}  // namespace felt::desktop::output_test
