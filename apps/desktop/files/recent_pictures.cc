#include "desktop/files/recent_pictures.h"

#include <QCryptographicHash>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QPixmap>
#include <QProxyStyle>
#include <QSet>
#include <QStandardPaths>
#include <vector>

#include "desktop/files/page_picture.h"
#include "felt/formats/drawing_materials.h"

namespace felt::desktop {
namespace {

// More strokes would take too long; the last ones are on top.
constexpr std::size_t kMaxPictured = 5000;
constexpr int kPixelRatio = 2;

QDir picture_folder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) +
              QStringLiteral("/recent"));
}

QString picture_name(const QString& path) {
  const QByteArray hash = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1);
  return QString::fromLatin1(hash.toHex()) + QStringLiteral(".png");
}

/// Makes the folder, in which only the user can read: the drawings may be private. Also closes a
/// folder of earlier versions, and with it the pictures in it. Returns false if that is not
/// possible.
bool make_private(const QDir& folder) {
  return folder.mkpath(QStringLiteral(".")) &&
         QFile::setPermissions(folder.path(),
                               QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
}

/// Draws menus with the icons of one size.
class LargeIcons : public QProxyStyle {
 public:
  [[nodiscard]] int pixelMetric(PixelMetric metric, const QStyleOption* option,
                                const QWidget* widget) const override {
    if (metric == PM_SmallIconSize) return kRecentPicture.width();
    return QProxyStyle::pixelMetric(metric, option, widget);
  }
};

}  // namespace

void write_recent_picture(const QString& path, const Drawing& drawing) {
  const Rgba paper = drawing.page.paper.a > 0 ? drawing.page.paper : Rgba{255, 255, 255};
  const QSize size = kRecentPicture * kPixelRatio;
  const QImage page =
      page_thumbnail(with_newest_strokes(drawing.document, kMaxPictured), drawing.page.area(), size,
                     paper, Grain::solid(with_texts(drawing.materials)), PictureChoice::kAll);
  if (page.isNull()) return;
  QImage picture(size, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  const QPoint corner((size.width() - page.width()) / 2, (size.height() - page.height()) / 2);
  painter.drawImage(corner, page);
  painter.setPen(Qt::gray);
  painter.drawRect(QRect(corner, page.size()).intersected(picture.rect()).adjusted(0, 0, -1, -1));
  painter.end();
  const QDir folder = picture_folder();
  if (make_private(folder)) picture.save(folder.filePath(picture_name(path)), "PNG");
}

QIcon recent_picture(const QString& path) {
  QPixmap picture(picture_folder().filePath(picture_name(path)));
  picture.setDevicePixelRatio(kPixelRatio);
  return picture.isNull() ? QIcon() : QIcon(picture);
}

void keep_recent_pictures(const QStringList& paths) {
  QSet<QString> kept;
  for (const QString& path : paths) kept.insert(picture_name(path));
  QDir folder = picture_folder();
  if (folder.exists()) make_private(folder);
  const QStringList names = folder.entryList({QStringLiteral("*.png")}, QDir::Files);
  for (const QString& name : names) {
    if (!kept.contains(name)) folder.remove(name);
  }
}

void show_large_icons(QMenu& menu) {
  auto* style = new LargeIcons;
  style->setParent(&menu);
  menu.setStyle(style);
}

}  // namespace felt::desktop
