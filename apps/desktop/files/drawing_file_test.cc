#include "desktop/files/drawing_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QTemporaryDir>
#include <cmath>

#include "felt/base/atomic_file.h"
#include "felt/document/testing/random_document.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/format_traits.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/testing/test_drawings.h"

namespace felt::desktop::drawing_file_test {
namespace {

using ::testing::HasSubstr;

Drawing random_drawing(std::uint64_t seed) {
  Drawing drawing;
  felt::testing::RandomEdits edits(seed);
  for (int i = 0; i < 8; ++i) {
    EXPECT_TRUE(drawing.document.apply(edits.next(drawing.document)));
  }
  drawing.page = {200.0, 100.0, {250, 240, 230, 255}};
  return drawing;
}

TEST(DrawingFile, FeltHoldsEverything) {
  const QTemporaryDir folder;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Drawing drawing = random_drawing(seed);
    const QString path = folder.filePath(QStringLiteral("a.felt"));
    ASSERT_TRUE(write_drawing(path, drawing));
    EXPECT_TRUE(read_drawing(path).value() == drawing) << "seed " << seed;
  }
}

/// Returns the visible strokes as lines of JSON have them: the opacity of their layers is in their
/// colours, because the format has no layers.
std::vector<Stroke> faded_strokes(const Document& document) {
  std::vector<Stroke> strokes;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    const double opacity = layer.opacity * (layer.group ? layer.group->opacity : 1.0);
    for (const StrokeId id : layer.strokes) {
      StrokeData data = document.find(id)->data();
      data.color.a = static_cast<std::uint8_t>(std::lround(opacity * data.color.a));
      strokes.push_back(Stroke::create(std::move(data)).value());
    }
  }
  return strokes;
}

TEST(DrawingFile, OtherFormatsHoldTheVisibleStrokes) {
  const QTemporaryDir folder;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Drawing drawing = random_drawing(seed);
    const auto strokes = felt::testing::by_value(visible_strokes(drawing.document));
    for (const char* name : {"a.svg", "a.ndjson"}) {
      const QString path = folder.filePath(QString::fromUtf8(name));
      ASSERT_TRUE(write_drawing(path, drawing));
      const Drawing back = read_drawing(path).value();
      const bool has_layers = traits_of(format_of_path(name).value()).layers;
      EXPECT_EQ(felt::testing::by_value(visible_strokes(back.document)),
                has_layers ? strokes : faded_strokes(drawing.document))
          << name << " seed " << seed;
      EXPECT_TRUE(!has_layers || back.page == drawing.page) << name;
    }
  }
}

TEST(DrawingFile, RawPenSamplesBecomeInk) {
  const QTemporaryDir folder;
  std::string text;
  std::vector<InkSample> samples;
  for (int i = 0; i < 50; ++i) samples.push_back({{1.0 * i, 20.0}, 0.5, 4.0 * i});
  append_raw_line(text, "r1", samples);
  const QString path = folder.filePath(QStringLiteral("raw.ndjson"));
  ASSERT_TRUE(write_file(path.toStdString(), text));
  const Result<Drawing> drawing = read_drawing(path);
  ASSERT_TRUE(drawing) << drawing.error().message;
  ASSERT_EQ(drawing->document.stroke_count(), 1u);
}

TEST(DrawingFile, ErrorsNameFileAndPlace) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("a.ndjson"));
  ASSERT_TRUE(write_file(path.toStdString(), "{\"feltline\":1,\"unit\":\"mm\"}\nnonsense\n"));
  EXPECT_THAT(read_drawing(path).error().message, HasSubstr("a.ndjson: line 2: "));
  const QString other = folder.filePath(QStringLiteral("a.doc"));
  EXPECT_THAT(read_drawing(other).error().message, HasSubstr("a.doc: cannot read"));
  ASSERT_TRUE(write_file(other.toStdString(), "%PDF-1.4"));
  EXPECT_THAT(read_drawing(other).error().message, HasSubstr("not read"));
  EXPECT_FALSE(write_drawing(folder.filePath(QStringLiteral("no/such.felt")), {}));
}

TEST(DrawingFile, APipeIsRefusedAndNotWaitedFor) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("a.felt"));
  ASSERT_EQ(::mkfifo(path.toLocal8Bit().constData(), 0600), 0);
  EXPECT_THAT(read_drawing(path).error().message, HasSubstr("a.felt: not a regular file"));
  EXPECT_FALSE(read_drawing(folder.path() + QStringLiteral("/.felt")));
}

TEST(DrawingFile, SuffixesComeOnce) {
  EXPECT_EQ(with_suffix(QStringLiteral("a"), FileFormat::kFelt), QStringLiteral("a.felt"));
  EXPECT_EQ(with_suffix(QStringLiteral("a.FELT"), FileFormat::kFelt), QStringLiteral("a.FELT"));
  EXPECT_EQ(with_suffix(QStringLiteral("a.svg"), FileFormat::kPdf), QStringLiteral("a.svg.pdf"));
}

}  // namespace
}  // namespace felt::desktop::drawing_file_test
