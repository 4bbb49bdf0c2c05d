// Draws an SVG file in several sizes. Usage: make_icons SVG FOLDER SIZE...

#include <QByteArray>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <cstdio>

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const QString folder = QString::fromLocal8Bit(argv[2]);
  QSvgRenderer icon(QString::fromLocal8Bit(argv[1]));
  if (!icon.isValid() || !QDir().mkpath(folder)) {
    std::fprintf(stderr, "make_icons: %s cannot be drawn\n", argv[1]);
    return 1;
  }
  for (int i = 3; i < argc; ++i) {
    const int size = QByteArray(argv[i]).toInt();
    QImage image(size, size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    icon.render(&painter);
    painter.end();
    if (!image.save(QStringLiteral("%1/%2.png").arg(folder).arg(size))) return 1;
  }
  return 0;
}
