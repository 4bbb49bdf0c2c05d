#include "desktop/files/notice_bar.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSet>
#include <QToolButton>
#include <QTreeWidget>

#include "desktop/files/format_texts.h"
#include "felt/formats/format_traits.h"

namespace felt::desktop::notice_bar_test {
namespace {

ImportReport report_of_two() {
  ImportReport report;
  report.add(12, "text 'title'", "is not a stroke and was skipped");
  report.add(20, "text 'name'", "is not a stroke and was skipped");
  report.add(0, "the image", "was left out");
  return report;
}

TEST(NoticeBar, TellsHowMuchAndOnDemandWhere) {
  NoticeBar bar;
  EXPECT_TRUE(bar.isHidden());
  bar.show_report(QStringLiteral("notes.xopp"), report_of_two());
  EXPECT_FALSE(bar.isHidden());
  EXPECT_TRUE(bar.accessibleName().contains(QStringLiteral("notes.xopp")));
  EXPECT_TRUE(bar.accessibleName().contains(QStringLiteral("changed: 3.")));
  auto* list = bar.findChild<QTreeWidget*>();
  EXPECT_TRUE(list->isHidden());
  bar.findChild<QToolButton*>()->click();
  EXPECT_FALSE(list->isHidden());
  ASSERT_EQ(list->topLevelItemCount(), 2);
  EXPECT_EQ(list->topLevelItem(0)->text(0), QStringLiteral("12"));
  EXPECT_EQ(list->topLevelItem(0)->text(1), QStringLiteral("text 'title'"));
  EXPECT_EQ(list->topLevelItem(0)->text(3), QStringLiteral("2"));
  EXPECT_EQ(list->topLevelItem(1)->text(0), QString());
}

TEST(NoticeBar, AWrittenFileHasAButtonForItsFolder) {
  NoticeBar bar;
  auto* folder = bar.findChild<QPushButton*>();
  bar.show_written(QStringLiteral("/some/where/a.svg"));
  EXPECT_FALSE(bar.isHidden());
  EXPECT_FALSE(folder->isHidden());
  EXPECT_TRUE(bar.accessibleName().contains(QStringLiteral("a.svg")));
  EXPECT_EQ(folder->toolTip(), QStringLiteral("/some/where"));
  bar.show_words(QStringLiteral("something else"));
  EXPECT_TRUE(folder->isHidden());
}

TEST(NoticeBar, AFileWithoutNoticesAndTheCrossPutItAway) {
  NoticeBar bar;
  bar.show_report(QStringLiteral("a"), report_of_two());
  bar.show_report(QStringLiteral("b"), ImportReport());
  EXPECT_TRUE(bar.isHidden());
  bar.show_report(QStringLiteral("a"), report_of_two());
  bar.findChildren<QToolButton*>().back()->click();
  EXPECT_TRUE(bar.isHidden());
}

TEST(NoticeBar, AnExportSaysWhatItLeftOut) {
  NoticeBar bar;
  const auto text = [&bar] {
    QString all;
    for (const QLabel* label : bar.findChildren<QLabel*>()) all += label->text();
    return all;
  };
  bar.show_written(QStringLiteral("a.xopp"));
  EXPECT_FALSE(text().contains(QStringLiteral("Left out")));
  bar.show_written(QStringLiteral("a.xopp"), {.fills = 3});
  EXPECT_TRUE(text().contains(QStringLiteral("a.xopp")));
  EXPECT_TRUE(text().contains(QStringLiteral("no fills: 3.")));
  bar.show_written(QStringLiteral("a.pdf"), {.pictures = 2});
  EXPECT_TRUE(text().contains(QStringLiteral("no pictures to draw over: 2.")));
  bar.show_written(QStringLiteral("a.xopp"), {.fills = 3, .pictures = 2});
  EXPECT_TRUE(text().contains(QStringLiteral("no fills: 3.")));
  EXPECT_TRUE(text().contains(QStringLiteral("no pictures to draw over: 2.")));
  bar.show_written(QStringLiteral("a.svg"), {.timings = 4, .body_edits = 5});
  EXPECT_TRUE(text().contains(QStringLiteral("no timings of key drawings: 4.")));
  EXPECT_TRUE(text().contains(QStringLiteral("no edits of the body: 5.")));
}

TEST(NoticeBar, NamesEveryKindOfLossOnceWithItsNumber) {
  constexpr std::size_t LostObjects::*kKinds[] = {
      &LostObjects::fills,         &LostObjects::pictures,   &LostObjects::blends,
      &LostObjects::groups,        &LostObjects::timings,    &LostObjects::body_edits,
      &LostObjects::guides,        &LostObjects::symmetries, &LostObjects::opacities,
      &LostObjects::layers,        &LostObjects::locks,      &LostObjects::hidden_strokes,
      &LostObjects::shown_strokes, &LostObjects::sharp_ends, &LostObjects::media,
      &LostObjects::materials,     &LostObjects::names};
  static_assert(std::size(kKinds) * sizeof(std::size_t) == sizeof(LostObjects));
  NoticeBar bar;
  for (const auto& kind : kKinds) {
    LostObjects lost;
    lost.*kind = 437;
    bar.show_written(QStringLiteral("a.xopp"), lost);
    QString all;
    for (const QLabel* label : bar.findChildren<QLabel*>()) all += label->text();
    EXPECT_EQ(all.count(QStringLiteral("437")), 1) << (&kind - kKinds) << all.toStdString();
  }
}

TEST(FormatTexts, TranslatorsSeeEveryWordOfTheTable) {
  QSet<QString> words;
  for (const char* word : format_words()) words.insert(QString::fromUtf8(word));
  for (const FormatTraits& row : format_table()) {
    EXPECT_TRUE(words.contains(QString::fromStdString(std::string(row.title))))
        << "add to format_texts.cc: " << row.title;
    EXPECT_TRUE(words.contains(QString::fromStdString(std::string(row.kept))))
        << "add to format_texts.cc: " << row.kept;
  }
}

TEST(FormatTexts, DialogsShowEveryFormatThatIsReadAndAllTogetherFirst) {
  const QStringList filters = open_filters().split(QStringLiteral(";;"));
  EXPECT_TRUE(filters.front().startsWith(QStringLiteral("All drawings (*.felt *.svg *.svgz")));
  EXPECT_EQ(filters.back(), QStringLiteral("All files (*)"));
  qsizetype reads = 0;
  for (const FormatTraits& row : format_table()) reads += row.reads ? 1 : 0;
  EXPECT_EQ(filters.size(), reads + 2);
  EXPECT_EQ(save_filter(FileFormat::kPng), QStringLiteral("PNG picture (*.png)"));
}

TEST(NoticeBar, AReportGoesWithItsDrawing) {
  NoticeBar bar;
  bar.show_report(QStringLiteral("notes.xopp"), report_of_two());
  bar.forget_report();
  EXPECT_TRUE(bar.isHidden());
  bar.show_words(QStringLiteral("something else"));
  bar.forget_report();
  EXPECT_FALSE(bar.isHidden());
}

}  // namespace
}  // namespace felt::desktop::notice_bar_test
