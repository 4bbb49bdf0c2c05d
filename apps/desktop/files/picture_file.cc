#include "desktop/files/picture_file.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImageReader>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>
#include <utility>

namespace felt::desktop {
namespace {

constexpr int kPdfTimeoutMs = 30'000;
constexpr int kMaxDecodedMb = 1024;
constexpr double kPageShare = 0.8;
constexpr double kMmPerPoint = 25.4 / 72.0;

tl::unexpected<Error> picture_error(const QString& path, const QString& why) {
  return fail(ErrorCode::kInvalidData, (path + QStringLiteral(": ") + why).toStdString());
}

bool is_pdf(const QString& path) {
  return path.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive);
}

/// Runs a program of poppler-utils on a file and returns its output. A separate program reads the
/// file, so that a malicious PDF file cannot harm the drawing.
Result<QByteArray> run_poppler(const QString& program, const QStringList& options,
                               const QString& path) {
  const QString found = QStandardPaths::findExecutable(program);
  if (found.isEmpty()) {
    return fail(ErrorCode::kUnsupported,
                (path + QStringLiteral(": the program %1 is needed to read PDF files; install the "
                                       "package poppler-utils")
                            .arg(program))
                    .toStdString());
  }
  QProcess process;
  // An absolute path, so that a name that begins with "-" is not read as an option.
  QStringList arguments = options;
  arguments << QFileInfo(path).absoluteFilePath();
  process.start(found, arguments);
  if (!process.waitForFinished(kPdfTimeoutMs)) {
    process.kill();
    process.waitForFinished();
    return picture_error(path, QStringLiteral("the PDF file takes too long to read"));
  }
  if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0) {
    const QString why = QString::fromLocal8Bit(process.readAllStandardError()).trimmed();
    return picture_error(
        path, QStringLiteral("the PDF file is damaged or protected") +
                  (why.isEmpty() ? QString() : QStringLiteral(": ") + why.section('\n', 0, 0)));
  }
  return process.readAllStandardOutput();
}

Result<ReadPicture> read_pdf_page(const QString& path, int page) {
  const QString number = QString::number(page);
  const Result<QByteArray> text =
      run_poppler(QStringLiteral("pdfinfo"),
                  {QStringLiteral("-f"), number, QStringLiteral("-l"), number}, path);
  if (!text) return tl::unexpected(text.error());
  const Result<QByteArray> png =
      run_poppler(QStringLiteral("pdftoppm"),
                  {QStringLiteral("-png"), QStringLiteral("-f"), number, QStringLiteral("-l"),
                   number, QStringLiteral("-scale-to"), QString::number(kPictureSidePx / 2)},
                  path);
  if (!png) return tl::unexpected(png.error());
  ReadPicture picture{QImage::fromData(*png, "PNG")};
  if (picture.image.isNull()) return picture_error(path, QStringLiteral("has no such page"));
  static const QRegularExpression kSize(
      QStringLiteral("Page\\s+\\d+ size:\\s+([0-9.]+) x ([0-9.]+) pts"));
  const auto size = kSize.match(QString::fromLatin1(*text));
  QSizeF size_mm(size.captured(1).toDouble() * kMmPerPoint,
                 size.captured(2).toDouble() * kMmPerPoint);
  // The size is that of the page before it is turned.
  const bool is_wide = picture.image.width() > picture.image.height();
  if (is_wide != (size_mm.width() > size_mm.height())) size_mm.transpose();
  picture.size_mm = size_mm;
  return picture;
}

Result<std::string> png_of(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!image.convertToFormat(QImage::Format_RGBA8888).save(&buffer, "PNG")) {
    return fail(ErrorCode::kIo, "the picture cannot be stored as PNG");
  }
  return bytes.toStdString();
}

}  // namespace

bool is_picture_path(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  if (suffix == QLatin1String("pdf")) return true;
  if (suffix.startsWith(QLatin1String("svg"))) return false;  // read as strokes
  return QImageReader::supportedImageFormats().contains(suffix.toLatin1());
}

QString picture_filter() {
  QStringList patterns{QStringLiteral("*.pdf")};
  for (const QByteArray& format : QImageReader::supportedImageFormats()) {
    patterns << QStringLiteral("*.") + QString::fromLatin1(format);
  }
  return patterns.join(QLatin1Char(' '));
}

Result<int> page_count(const QString& path) {
  if (!is_pdf(path)) return 1;
  const Result<QByteArray> text = run_poppler(QStringLiteral("pdfinfo"), {}, path);
  if (!text) return tl::unexpected(text.error());
  static const QRegularExpression kPages(QStringLiteral("(?m)^Pages:\\s+(\\d+)"));
  const int pages = kPages.match(QString::fromLatin1(*text)).captured(1).toInt();
  if (pages > 0) return pages;
  return picture_error(path, QStringLiteral("the PDF file has no pages"));
}

Result<ReadPicture> read_picture(const QString& path, int page) {
  if (is_pdf(path)) return read_pdf_page(path, page);
  QImageReader::setAllocationLimit(kMaxDecodedMb);
  QImageReader reader(path);
  reader.setAutoTransform(true);
  reader.setDecideFormatFromContent(true);
  const QSize size = reader.size();
  const bool is_svg = reader.format().startsWith("svg");
  if (!is_svg && std::max(size.width(), size.height()) > kPictureFileSidePx) {
    return picture_error(path, QStringLiteral("is %1 x %2 pixels large; at most %3 are allowed")
                                   .arg(size.width())
                                   .arg(size.height())
                                   .arg(kPictureFileSidePx));
  }
  const int side = is_svg ? kPictureSidePx / 2 : kPictureSidePx;
  if (!size.isEmpty() && (is_svg || std::max(size.width(), size.height()) > side)) {
    reader.setScaledSize(size.scaled(side, side, Qt::KeepAspectRatio).expandedTo({1, 1}));
  }
  ReadPicture picture{reader.read()};
  if (!picture.image.isNull()) return picture;
  return picture_error(
      path, reader.error() == QImageReader::FileNotFoundError
                ? QStringLiteral("cannot be read")
                : QStringLiteral("is not a picture, or is damaged: ") + reader.errorString());
}

Result<std::string> png_of_picture(std::string_view bytes, std::int64_t max_pixels) {
  QByteArray copy(bytes.data(), static_cast<qsizetype>(bytes.size()));
  QBuffer buffer(&copy);
  buffer.open(QIODevice::ReadOnly);
  QImageReader::setAllocationLimit(kMaxDecodedMb);
  QImageReader reader(&buffer);
  reader.setDecideFormatFromContent(true);
  reader.setAutoTransform(true);
  const QSize size = reader.size();
  const QByteArray format = reader.format();
  const bool is_known = format == "jpeg" || format == "webp" || format == "gif" || format == "bmp";
  const int longest = std::max(size.width(), size.height());
  if (!is_known || longest < 1 || longest > kPictureFileSidePx) {
    return fail(ErrorCode::kUnsupported, "the picture cannot be read");
  }
  const QSize scaled =
      longest > kPictureSidePx
          ? size.scaled(kPictureSidePx, kPictureSidePx, Qt::KeepAspectRatio).expandedTo({1, 1})
          : size;
  // Only JPEG files are decoded at a reduced size.
  const QSize decoded = format == "jpeg" ? scaled : size;
  if (std::int64_t{decoded.width()} * decoded.height() > max_pixels) {
    return fail(ErrorCode::kLimitExceeded, "the picture has too many pixels");
  }
  if (scaled != size) reader.setScaledSize(scaled);
  const QImage image = reader.read();
  if (image.isNull()) return fail(ErrorCode::kInvalidData, "the picture is damaged");
  return png_of(image);
}

Result<AddPicture> add_picture_event(const QString& name, const ReadPicture& picture,
                                     const Page& page) {
  QImage image = picture.image;
  if (std::max(image.width(), image.height()) > kPictureSidePx) {
    image =
        image.scaled(kPictureSidePx, kPictureSidePx, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  }
  if (image.isNull()) return fail(ErrorCode::kInvalidData, "the picture is empty");
  Result<std::string> png = png_of(image);
  if (!png) return tl::unexpected(png.error());
  auto data = make_picture_data(*std::move(png));
  if (!data) return tl::unexpected(data.error());
  const double width = image.width(), height = image.height();
  double scale = kPageShare * std::min(page.width_mm / width, page.height_mm / height);
  const QSizeF true_mm = picture.size_mm;
  if (true_mm.width() > 0.0 && true_mm.width() <= page.width_mm &&
      true_mm.height() <= page.height_mm) {
    scale = true_mm.width() / width;
  }
  return AddPicture{name.toStdString(), *std::move(data),
                    Affine{scale, 0.0, 0.0, scale, 0.5 * (page.width_mm - scale * width),
                           0.5 * (page.height_mm - scale * height)}};
}

}  // namespace felt::desktop
