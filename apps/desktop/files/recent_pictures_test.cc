#include "desktop/files/recent_pictures.h"

#include <gtest/gtest.h>

#include <QImage>

#include "desktop/files/testing/studio_fixture.h"

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
