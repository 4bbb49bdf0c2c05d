#include "desktop/files/picture_actions.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QBuffer>
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QMimeData>
#include <QPainter>
#include <QPdfWriter>
#include <QStandardPaths>

#include "desktop/files/drawing_file.h"
#include "desktop/files/export_file.h"
#include "desktop/files/picture_file.h"
#include "desktop/files/testing/studio_fixture.h"

namespace felt::desktop::picture_actions_test {
namespace {

QImage red_image(int width, int height) {
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(Qt::red);
  return image;
}

void write_bytes(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

const Layer& lowest(const StudioFixture& fixture) {
  return fixture.document().layers()[0];
}

void drop_picture(StudioFixture& fixture) {
  ASSERT_TRUE(red_image(30, 20).save(fixture.at("a.jpg")));
  fixture.files->take_dropped({fixture.at("a.jpg")});
}

TEST(PictureActions, ADroppedPictureBecomesALayerThatFitsThePage) {
  StudioFixture fixture;
  fixture.studio.set_page({200.0, 100.0, {255, 255, 255, 255}});
  ASSERT_TRUE(red_image(300, 300).save(fixture.at("photo.jpg")));
  fixture.files->take_dropped({fixture.at("photo.jpg")});
  ASSERT_EQ(fixture.document().layers().size(), 2u);
  const Layer& layer = lowest(fixture);
  EXPECT_EQ(layer.name, "photo.jpg");
  ASSERT_TRUE(layer.picture);
  const Rect box = bounds_of(*layer.picture);
  EXPECT_NEAR(box.width(), 80.0, 1e-9);
  EXPECT_NEAR(box.x0, 60.0, 1e-9);
  EXPECT_NEAR(box.y0, 10.0, 1e-9);
  EXPECT_EQ(fixture.studio.session().layer(), layer.id);
  EXPECT_EQ(fixture.studio.session().tool().info().id, "transform");
  fixture.studio.apply(UndoEvent{});
  EXPECT_EQ(fixture.document().layers().size(), 1u);
}

TEST(PictureActions, InkDoesNotGoToThePicture) {
  StudioFixture fixture;
  const LayerId own = fixture.studio.session().layer();
  ASSERT_TRUE(red_image(30, 20).save(fixture.at("a.jpg")));
  ASSERT_TRUE(red_image(20, 30).save(fixture.at("b.jpg")));
  fixture.files->take_dropped({fixture.at("a.jpg"), fixture.at("b.jpg")});
  ASSERT_EQ(fixture.document().layers().size(), 3u);
  EXPECT_EQ(lowest(fixture).opacity, 0.5);
  EXPECT_EQ(fixture.document().layers().back().opacity, 1.0);
  EXPECT_NE(fixture.studio.session().layer(), own) << "the picture can be moved";
  fixture.studio.apply(SelectTool{"pencil"});
  EXPECT_EQ(fixture.studio.session().layer(), own);
  // The user wants to draw on the layer of the picture.
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kUse, lowest(fixture).id});
  fixture.studio.apply(SelectTool{"shape"});
  EXPECT_EQ(fixture.studio.session().layer(), lowest(fixture).id);
}

TEST(PictureActions, AnotherDrawingKeepsItsCurrentLayer) {
  StudioFixture fixture;
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}});
  drop_picture(fixture);
  Document other;  // with layers of the same ids
  Edit edit{"Add layers", {}, {}};
  for (std::uint64_t id = 2; id <= fixture.studio.session().layer().value; ++id) {
    edit.layers.push_back({{id}, std::nullopt, LayerState{"Layer"}, 0, id - 1});
  }
  ASSERT_TRUE(other.apply(edit));
  fixture.studio.open(other, {});
  fixture.studio.apply(SelectTool{"transform"});
  const LayerId top = fixture.studio.session().layer();
  ASSERT_EQ(top, other.layers().back().id);
  fixture.studio.apply(SelectTool{"pencil"});
  EXPECT_EQ(fixture.studio.session().layer(), top);
}

TEST(PictureActions, ALayerThatTheUserChoosesStaysTheCurrentOne) {
  StudioFixture fixture;
  const LayerId own = fixture.studio.session().layer();
  drop_picture(fixture);
  const LayerId picture = fixture.studio.session().layer();
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kUse, own});
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kUse, picture});
  fixture.studio.apply(SelectTool{"pencil"});
  EXPECT_EQ(fixture.studio.session().layer(), picture);
}

TEST(PictureActions, ALayerThatWasLockedMeanwhileIsNotUsed) {
  StudioFixture fixture;
  const LayerId own = fixture.studio.session().layer();
  drop_picture(fixture);
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kLock, own});
  fixture.studio.apply(SelectTool{"pencil"});
  EXPECT_EQ(fixture.studio.session().layer(), lowest(fixture).id);
}

TEST(PictureActions, APictureThatIsOpenedIsImported) {
  for (const char* name : {"photo.jpg", "photo.png", "photo.bmp"}) {
    StudioFixture fixture;
    const QString path = fixture.at(name);
    ASSERT_TRUE(red_image(30, 20).save(path));
    EXPECT_TRUE(fixture.files->open(path)) << name;
    ASSERT_EQ(fixture.document().layers().size(), 2u) << name;
    EXPECT_TRUE(lowest(fixture).picture) << name;
    EXPECT_TRUE(fixture.person->errors.isEmpty()) << name;
  }
}

TEST(PictureActions, ADamagedPictureThatIsOpenedIsNamed) {
  StudioFixture fixture;
  write_bytes(fixture.at("photo.jpg"), "no picture");
  EXPECT_FALSE(fixture.files->open(fixture.at("photo.jpg")));
  EXPECT_EQ(fixture.person->errors.size(), 1);
  EXPECT_EQ(fixture.document().layers().size(), 1u);
}

TEST(PictureFile, AJpegInAnSvgIsRead) {
  StudioFixture fixture;
  ASSERT_TRUE(red_image(30, 20).save(fixture.at("photo.jpg")));
  write_bytes(fixture.at("a.svg"),
              "<svg xmlns='http://www.w3.org/2000/svg' width='50mm' height='50mm' "
              "viewBox='0 0 50 50'><image width='30' height='20' href='photo.jpg'/></svg>");
  const Drawing drawing = read_drawing(fixture.at("a.svg")).value();
  ASSERT_TRUE(drawing.document.layers()[0].picture);
  EXPECT_EQ(drawing.document.layers()[0].picture->data->width_px, 30);
  EXPECT_FALSE(png_of_picture("<svg xmlns='http://www.w3.org/2000/svg'/>", 1 << 20));
  EXPECT_FALSE(png_of_picture("", 1 << 20));
}

TEST(PictureActions, APictureWithTooManyPixelsIsNotConverted) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  ASSERT_TRUE(red_image(30, 20).save(&buffer, "BMP"));
  EXPECT_TRUE(png_of_picture(bytes.toStdString(), 600));
  const Result<std::string> refused = png_of_picture(bytes.toStdString(), 599);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kLimitExceeded);
}

TEST(PictureActions, ALargePhotoNeedsOnlyThePixelsOfItsReducedSize) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  ASSERT_TRUE(red_image(8192, 64).save(&buffer, "JPG"));
  const std::int64_t reduced = 4096 * 32;
  EXPECT_TRUE(png_of_picture(bytes.toStdString(), reduced));
  EXPECT_FALSE(png_of_picture(bytes.toStdString(), reduced - 1));
}

TEST(PictureActions, TheMenuAsksForAFile) {
  StudioFixture fixture;
  ASSERT_TRUE(red_image(10, 20).save(fixture.at("small.png")));
  fixture.person->next = fixture.at("small.png");
  fixture.actions.find(QStringLiteral("file.import_picture"))->trigger();
  ASSERT_TRUE(lowest(fixture).picture);
  EXPECT_EQ(lowest(fixture).picture->data->height_px, 20);
}

TEST(PictureActions, APastedPictureBecomesALayer) {
  StudioFixture fixture;
  auto* data = new QMimeData;
  data->setImageData(red_image(40, 30));
  QGuiApplication::clipboard()->setMimeData(data);
  fixture.actions.find(QStringLiteral("edit.paste"))->trigger();
  ASSERT_TRUE(lowest(fixture).picture);
  EXPECT_EQ(lowest(fixture).picture->data->width_px, 40);
}

TEST(PictureActions, AnSvgIsPaintedAndALargePictureIsMadeSmaller) {
  StudioFixture fixture;
  write_bytes(fixture.at("a.svg"),
              "<svg xmlns='http://www.w3.org/2000/svg' width='20' height='10'>"
              "<rect width='20' height='10' fill='blue'/></svg>");
  const Result<ReadPicture> svg = read_picture(fixture.at("a.svg"));
  ASSERT_TRUE(svg) << svg.error().message;
  EXPECT_EQ(svg->image.width(), kPictureSidePx / 2);
  EXPECT_EQ(svg->image.pixelColor(100, 100), QColor(Qt::blue));
  ASSERT_TRUE(red_image(6000, 3).save(fixture.at("long.png")));
  EXPECT_EQ(read_picture(fixture.at("long.png")).value().image.width(), kPictureSidePx);
}

TEST(PictureActions, BadFilesAreErrorsThatNameTheFileAndTheReason) {
  StudioFixture fixture;
  ASSERT_TRUE(red_image(50, 50).save(fixture.at("good.png")));
  QFile good(fixture.at("good.png"));
  ASSERT_TRUE(good.open(QIODevice::ReadOnly));
  const QByteArray bytes = good.readAll();
  write_bytes(fixture.at("cut.png"), bytes.left(60));
  write_bytes(fixture.at("text.png"), "Dear all,");
  // The head of a PNG file of 40000 x 1 pixels.
  write_bytes(
      fixture.at("huge.png"),
      QByteArray::fromBase64("iVBORw0KGgoAAAANSUhEUgAAnEAAAAABCAIAAAAyAlzT") + bytes.mid(33));
  for (const char* name : {"cut.png", "text.png", "huge.png", "missing.png"}) {
    const Result<ReadPicture> read = read_picture(fixture.at(name));
    ASSERT_FALSE(read) << name;
    EXPECT_EQ(read.error().message.find(fixture.at(name).toStdString() + ": "), 0u);
    fixture.files->take_dropped({fixture.at(name)});
  }
  EXPECT_EQ(fixture.person->errors.size(), 4);
  EXPECT_EQ(fixture.document().layers().size(), 1u);
  const std::string huge = read_picture(fixture.at("huge.png")).error().message;
  EXPECT_NE(huge.find("is 40000 x 1 pixels large; at most 32000 are allowed"), std::string::npos)
      << huge;
}

TEST(PictureActions, APageOfAPdfComesInItsTrueSize) {
  if (QStandardPaths::findExecutable(QStringLiteral("pdftoppm")).isEmpty()) {
    GTEST_SKIP() << "poppler-utils is not installed";
  }
  StudioFixture fixture;
  {
    QPdfWriter writer(fixture.at("two.pdf"));
    writer.setPageSize(QPageSize(QPageSize::A6));
    QPainter painter(&writer);
    painter.fillRect(0, 0, 100, 100, Qt::green);
    writer.newPage();
    painter.fillRect(0, 0, 100, 100, Qt::red);
  }
  EXPECT_EQ(page_count(fixture.at("two.pdf")).value(), 2);
  fixture.person->page = 2;
  fixture.files->take_dropped({fixture.at("two.pdf")});
  EXPECT_EQ(fixture.person->asked, QStringList{QStringLiteral("two.pdf")});
  ASSERT_TRUE(lowest(fixture).picture);
  const Rect box = bounds_of(*lowest(fixture).picture);
  EXPECT_NEAR(box.width(), 105.0, 0.6);
  EXPECT_NEAR(box.height(), 148.0, 0.6);
  fixture.person->page = 0;  // cancelled
  fixture.files->take_dropped({fixture.at("two.pdf")});
  EXPECT_EQ(fixture.document().layers().size(), 2u);
  write_bytes(fixture.at("bad.pdf"), "%PDF-1.4 nonsense");
  EXPECT_FALSE(page_count(fixture.at("bad.pdf")));
  EXPECT_FALSE(read_picture(fixture.at("two.pdf"), 3));
}

TEST(PictureActions, AnExportShowsThePictureOnlyIfAsked) {
  StudioFixture fixture;
  ASSERT_TRUE(red_image(30, 30).save(fixture.at("a.png")));
  fixture.files->take_dropped({fixture.at("a.png")});
  LayerEvent opaque{LayerEvent::Do::kOpacity, lowest(fixture).id};
  opaque.opacity = 1.0;
  fixture.studio.apply(opaque);
  ExportOptions options;
  options.format = FileFormat::kPng;
  options.dpi = 30.0;
  const auto middle = [&] {
    EXPECT_TRUE(export_drawing(fixture.at("out.png"), fixture.files->drawing(), options));
    const QImage image(fixture.at("out.png"));
    return image.pixelColor(image.width() / 2, image.height() / 2);
  };
  EXPECT_NE(middle(), QColor(Qt::red));
  options.pictures = true;
  EXPECT_EQ(middle(), QColor(Qt::red));
}

}  // namespace
}  // namespace felt::desktop::picture_actions_test
