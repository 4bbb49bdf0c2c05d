#include "desktop/files/recent_pictures.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QStandardPaths>
#include <memory>
#include <utility>

#include "desktop/files/testing/studio_fixture.h"
#include "felt/document/edit_builder.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::recent_pictures_test {
namespace {

TEST(RecentPictures, ShowTheInkAndGoWithTheirFiles) {
  StudioFixture fixture;
  const QString one = fixture.at("one.felt"), two = fixture.at("two.felt");
  EXPECT_TRUE(recent_picture(one).isNull());
  write_recent_picture(one, fixture.files->drawing());
  fixture.draw(1, 4);
  write_recent_picture(two, fixture.files->drawing());
  const auto image = [](const QString& path) {
    return recent_picture(path).pixmap(kRecentPicture, 1.0).toImage();
  };
  ASSERT_FALSE(image(one).isNull());
  ASSERT_FALSE(image(two).isNull());
  EXPECT_LE(image(two).width(), kRecentPicture.width());
  EXPECT_NE(image(one), image(two)) << "one is empty";
  keep_recent_pictures({two});
  EXPECT_TRUE(recent_picture(one).isNull());
  EXPECT_FALSE(recent_picture(two).isNull());
  keep_recent_pictures({});
  EXPECT_TRUE(recent_picture(two).isNull());
}

TEST(RecentPictures, OnlyTheUserCanReadThem) {
  StudioFixture fixture;
  fixture.draw(1, 1);
  const QString path = fixture.at("private.felt");
  const QString folder =
      QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/recent");
  const auto others = QFile::ReadGroup | QFile::ExeGroup | QFile::ReadOther | QFile::ExeOther;
  write_recent_picture(path, fixture.files->drawing());
  EXPECT_EQ(QFile::permissions(folder) & others, QFile::Permissions());
  ASSERT_TRUE(QFile::setPermissions(folder, QFile::permissions(folder) | others));  // as it was
  keep_recent_pictures({path});
  EXPECT_EQ(QFile::permissions(folder) & others, QFile::Permissions());
  EXPECT_FALSE(recent_picture(path).isNull());
  ASSERT_TRUE(QFile::setPermissions(folder, QFile::permissions(folder) | others));
  write_recent_picture(path, fixture.files->drawing());
  EXPECT_EQ(QFile::permissions(folder) & others, QFile::Permissions());
}

TEST(RecentPictures, R57_ShowTheStyleOfAMediumInTheDrawing) {
  StudioFixture fixture;
  const QString path = fixture.at("styled.felt");
  Drawing drawing = fixture.files->drawing();
  StrokeData line = testing::straight_stroke({20, 50}, {180, 50}, 8.0, 8.0).data();
  line.medium = "dots";
  EditBuilder edit(drawing.document);
  edit.add(drawing.document.layers()[0].id,
           std::make_shared<const Stroke>(Stroke::create(std::move(line)).value()));
  ASSERT_TRUE(drawing.document.apply(std::move(edit).build("Line")));
  const auto image = [&] {
    write_recent_picture(path, drawing);
    return recent_picture(path).pixmap(kRecentPicture, 1.0).toImage();
  };
  const QImage plain = image();
  drawing.materials = {"kind = \"medium\"\nid = \"dots\"\n[style]\nkind = \"dashes\"\n"};
  EXPECT_NE(image(), plain);
}

TEST(RecentPictures, ASavedDrawingHasOneInTheMenu) {
  StudioFixture fixture;
  fixture.draw(1, 2);
  fixture.save_as("a.felt");
  fixture.files->worker().wait();
  Q_EMIT fixture.files->recent_menu()->aboutToShow();
  const QList<QAction*> actions = fixture.files->recent_menu()->actions();
  ASSERT_FALSE(actions.isEmpty());
  EXPECT_TRUE(actions.front()->text().contains(QStringLiteral("a.felt")));
  EXPECT_FALSE(actions.front()->icon().isNull());
}

}  // namespace
}  // namespace felt::desktop::recent_pictures_test
