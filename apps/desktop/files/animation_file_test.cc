#include "desktop/files/animation_file.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QImageReader>
#include <QSpinBox>

#include "desktop/files/animation_dialog.h"
#include "desktop/files/testing/studio_fixture.h"
#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/store/felt_file.h"

namespace felt::desktop::animation_file_test {
namespace {

struct AnimationFixture : StudioFixture {
  AnimationFixture() {
    for (int i = 0; i < 2; ++i) {
      draw(1, 2);
      request.keys.push_back({files->drawing(), {.between = 2}});
    }
  }
  [[nodiscard]] QStringList written() const {
    return QDir(folder.path()).entryList(QDir::Files, QDir::Name);
  }

  AnimationRequest request;
  TimelapseProgress progress;
};

TEST(Animation, NumberedFilesHaveTheKeyDrawingsAndTheDrawingsBetween) {
  AnimationFixture fixture;
  fixture.request.format = AnimationFormat::kPngFiles;
  fixture.request.longer_px = 200;
  ASSERT_TRUE(make_animation(fixture.at("swim.png"), fixture.request, fixture.progress));
  EXPECT_EQ(fixture.written(),
            (QStringList{"swim-001.png", "swim-002.png", "swim-003.png", "swim-004.png"}));
  EXPECT_EQ(QImageReader(fixture.at("swim-001.png")).size().width(), 200);
  EXPECT_EQ(fixture.progress.done, 4);
  EXPECT_EQ(fixture.progress.all, 4);
  fixture.request.format = AnimationFormat::kSvgFiles;
  ASSERT_TRUE(make_animation(fixture.at("swim.svg"), fixture.request, fixture.progress));
  EXPECT_EQ(read_drawing(fixture.at("swim-001.svg")).value().document.stroke_count(),
            fixture.request.keys[0].drawing.document.stroke_count());
}

TEST(Animation, NoFileIsOverwrittenAndNothingStaysOfACancelledFilm) {
  AnimationFixture fixture;
  fixture.request.format = AnimationFormat::kSvgFiles;
  ASSERT_TRUE(write_file(fixture.at("swim-003.svg").toStdString(), "mine"));
  const auto refused = make_animation(fixture.at("swim.svg"), fixture.request, fixture.progress);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("swim-003.svg"), std::string::npos);
  EXPECT_EQ(fixture.written(), QStringList{"swim-003.svg"});
  EXPECT_EQ(read_file(fixture.at("swim-003.svg").toStdString(), 100).value(), "mine");
  fixture.progress.is_cancelled = true;
  EXPECT_FALSE(make_animation(fixture.at("fly.svg"), fixture.request, fixture.progress));
  EXPECT_EQ(fixture.written(), QStringList{"swim-003.svg"});
}

TEST(Animation, AnAnimatedSvgPlaysEveryFrame) {
  AnimationFixture fixture;
  for (FilmKey& key : fixture.request.keys) key.timing.hold = 6;
  ASSERT_TRUE(make_animation(fixture.at("swim.svg"), fixture.request, fixture.progress));
  const std::string svg = read_file(fixture.at("swim.svg").toStdString(), 1 << 26).value();
  EXPECT_NE(svg.find("<animate"), std::string::npos);
  EXPECT_NE(svg.find("dur=\"0.58"), std::string::npos) << "14 frames at 24 a second";
  fixture.request.keys.pop_back();
  const auto refused = make_animation(fixture.at("one.svg"), fixture.request, fixture.progress);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("two key drawings"), std::string::npos);
}

TEST(Animation, AFileIsTheSameWhileLayersAreOutOfViewForTheOnionSkin) {
  AnimationFixture fixture;
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}});
  fixture.draw(1, 2);
  const std::string before = felt_bytes(fixture.files->drawing()).value();
  fixture.studio.apply(UseView{{{1}}});
  ASSERT_FALSE(fixture.studio.session().seen().layer({1})->visible);
  EXPECT_EQ(felt_bytes(fixture.files->drawing()).value(), before);
}

TEST(Animation, TheDialogOffersTheSizeOfPicturesOnly) {
  AnimationDialog dialog(nullptr);
  auto* format = dialog.findChild<QComboBox*>();
  auto* size = dialog.findChild<QSpinBox*>();
  format->setCurrentIndex(0);
  EXPECT_EQ(dialog.request().format, AnimationFormat::kAnimatedSvg);
  EXPECT_FALSE(size->isEnabled());
  format->setCurrentIndex(1);
  size->setValue(640);
  EXPECT_EQ(dialog.request().format, AnimationFormat::kPngFiles);
  EXPECT_EQ(dialog.request().longer_px, 640);
}

}  // namespace
}  // namespace felt::desktop::animation_file_test
