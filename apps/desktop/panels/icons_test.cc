#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <set>
#include <string>

#include "desktop/engine/studio.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop::icons_test {
namespace {

/// Returns the number of pixels that are not transparent.
int ink_of(const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += qAlpha(image.pixel(x, y)) > 0 ? 1 : 0;
  }
  return count;
}

TEST(Icons, EveryOneIsDrawnAtEverySize) {
  const QStringList names = icon_names();
  ASSERT_GT(names.size(), 60);
  for (const QString& name : names) {
    SCOPED_TRACE(name.toStdString());
    const QIcon icon = icon_of(name.toStdString());
    ASSERT_FALSE(icon.isNull());
    for (const int px : {16, 24, 48}) {
      const QImage image = icon.pixmap(QSize(px, px), 1.0).toImage();
      ASSERT_EQ(image.size(), QSize(px, px));
      const int ink = ink_of(image);
      EXPECT_GT(ink, px * px / 40) << px;
      EXPECT_LT(ink, px * px * 3 / 4) << px;
      // The outermost pixels are empty, so nothing is cut off.
      const QRect frame = image.rect().adjusted(1, 1, -1, -1);
      for (int i = 0; i < px && px > 16; ++i) {
        for (const QPoint at : {QPoint(i, 0), QPoint(i, px - 1), QPoint(0, i), QPoint(px - 1, i)}) {
          EXPECT_FALSE(frame.contains(at));
          EXPECT_EQ(qAlpha(image.pixel(at)), 0) << at.x() << " " << at.y();
        }
      }
    }
    EXPECT_EQ(icon.pixmap(QSize(24, 24), 2.0).size(), QSize(48, 48)) << "drawn anew for HiDPI";
  }
}

TEST(Icons, EveryToolHasItsOwnAndAnUnknownNameHasNone) {
  EXPECT_TRUE(icon_of("no-such").isNull());
  EXPECT_TRUE(icon_of("../pencil").isNull());
  const Studio studio({.live = false});
  std::set<std::string> seen;
  for (const auto& tool : studio.session().tools()) {
    const QIcon icon = icon_of(tool->info().id);
    ASSERT_FALSE(icon.isNull()) << tool->info().id;
    const QImage image = icon.pixmap(QSize(24, 24), 1.0).toImage();
    const QByteArray bits(reinterpret_cast<const char*>(image.constBits()), image.sizeInBytes());
    EXPECT_TRUE(seen.insert(bits.toStdString()).second) << tool->info().id;
  }
}

TEST(Icons, AreOtherwiseWhereDisabledOrSelected) {
  const QIcon icon = icon_of("pencil");
  const auto look = [&icon](QIcon::Mode mode) {
    return icon.pixmap(QSize(24, 24), 1.0, mode).toImage();
  };
  EXPECT_NE(look(QIcon::Normal), look(QIcon::Disabled));
  EXPECT_NE(look(QIcon::Normal), look(QIcon::Selected));
}

}  // namespace
}  // namespace felt::desktop::icons_test
