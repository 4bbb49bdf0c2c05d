#include "desktop/panels/tool_icons.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <utility>

// Resources of a static library are linked only if a function outside every namespace requests
// them by name.
static void need_icons() {
  Q_INIT_RESOURCE(icons);
  Q_INIT_RESOURCE(tool_icons);
}

namespace felt::desktop {
namespace {

// The colours in the SVG files. They are replaced by colours of the palette.
constexpr const char* kInk = "#303438";
constexpr const char* kAccent = "#c8501e";
constexpr const char* kAccentOnDark = "#ff9a5c";

QString path_of(const QString& name) {
  return QStringLiteral(":/feltline/icons/%1.svg").arg(name);
}

/// The two colours of an icon.
struct IconColors {
  QColor ink;
  QColor accent;
};

IconColors colors_of(QIcon::Mode mode) {
  const QPalette palette = QApplication::palette();
  if (mode == QIcon::Disabled) {
    const QColor grey = palette.color(QPalette::Disabled, QPalette::ButtonText);
    return {grey, grey};
  }
  if (mode == QIcon::Selected) {
    const QColor text = palette.color(QPalette::HighlightedText);
    return {text, text};
  }
  return {palette.color(QPalette::ButtonText), accent_on(palette.color(QPalette::Button))};
}

/// Renders the SVG for every requested size and colour. Therefore the icon follows changes of the
/// theme and is never a scaled picture.
class DrawnIcon : public QIconEngine {
 public:
  DrawnIcon(QString name, QByteArray svg) : name_(std::move(name)), svg_(std::move(svg)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const IconColors colors = colors_of(mode);
    QByteArray svg = svg_;
    svg.replace(kInk, colors.ink.name().toLatin1());
    svg.replace(kAccent, colors.accent.name().toLatin1());
    QSvgRenderer renderer(svg);
    renderer.setAspectRatioMode(Qt::KeepAspectRatio);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (mode == QIcon::Disabled) painter->setOpacity(0.8);
    renderer.render(painter, rect);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    const IconColors colors = colors_of(mode);
    const QString key =
        QStringLiteral("felt:%1:%2x%3:%4%5:%6")
            .arg(name_, QString::number(size.width()), QString::number(size.height()),
                 colors.ink.name(), colors.accent.name(), QString::number(int(mode)));
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap)) return pixmap;
    pixmap = QPixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    painter.end();
    QPixmapCache::insert(key, pixmap);
    return pixmap;
  }

  [[nodiscard]] QIconEngine* clone() const override { return new DrawnIcon(name_, svg_); }
  QString iconName() override { return name_; }
  bool isNull() override { return false; }

 private:
  QString name_;
  QByteArray svg_;
};

}  // namespace

QIcon icon_of(std::string_view name) {
  need_icons();
  const QString text = QString::fromUtf8(name.data(), qsizetype(name.size()));
  QFile file(path_of(text));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QIcon(new DrawnIcon(text, file.readAll()));
}

QStringList icon_names() {
  need_icons();
  QStringList names = QDir(QStringLiteral(":/feltline/icons")).entryList(QDir::Files, QDir::Name);
  for (QString& name : names) name.chop(4);
  return names;
}

QColor accent_on(const QColor& background) {
  return background.lightness() < 128 ? QColor(kAccentOnDark) : QColor(kAccent);
}

}  // namespace felt::desktop
