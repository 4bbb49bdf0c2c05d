#include "desktop/window/reading_speech.h"

#include <gtest/gtest.h>

#include <QTest>

#include "desktop/window/main_window.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::reading_speech_test {
namespace {

class ReadingSpeechTest : public ::testing::Test {
 protected:
  ReadingSpeechTest() {
    window_.show();
    for (const auto& [from, to] :
         {std::pair{Point{40, 50}, Point{160, 50}}, {Point{100, 20}, Point{100, 80}}}) {
      window_.studio().import(QStringLiteral("test"),
                              std::vector{std::make_shared<const Stroke>(
                                  felt::testing::straight_stroke(from, to, 1, 1))});
    }
    window_.studio().apply(SelectTool{"read"});
    speech_ = window_.findChild<ReadingSpeech*>();
    // The alert for screen readers follows this signal; without a display, Qt delivers none.
    QObject::connect(speech_, &ReadingSpeech::spoken, speech_,
                     [this](const QString& words) { spoken_ << words; });
  }

  void touch(Point at) {
    Studio& studio = window_.studio();
    for (int i = 0; i < 30; ++i) {
      studio.point({studio.now_ns(), {at.x, at.y}, true, 0.5});
      studio.advance(4'000'000);
    }
    studio.process();
  }
  QString said(const char* words) {
    const QString wanted = QString::fromLatin1(words);
    static_cast<void>(QTest::qWaitFor([&] { return speech_->words() == wanted; }, 5000));
    return speech_->words();
  }

  MainWindow window_{StudioOptions{.device = QStringLiteral("tablet"), .live = false}};
  ReadingSpeech* speech_ = nullptr;
  QStringList spoken_;
};

TEST_F(ReadingSpeechTest, ScreenReadersHearWhatIsUnderThePen) {
  ASSERT_TRUE(speech_);
  touch({70, 50.5});
  EXPECT_EQ(said("line, black, 120 mm").toStdString(), "line, black, 120 mm");
  touch({100, 50});
  EXPECT_EQ(said("crossing of 2 lines").toStdString(), "crossing of 2 lines");
  touch({160, 50});
  EXPECT_EQ(said("end").toStdString(), "end");
  EXPECT_EQ(window_.canvas().accessibleName().toStdString(), "Drawing area: end");
  EXPECT_GE(spoken_.size(), 3);
  EXPECT_TRUE(spoken_.contains(QStringLiteral("crossing of 2 lines")));
  window_.studio().apply(SelectTool{"pencil"});
  EXPECT_EQ(said(""), QString());
  EXPECT_EQ(window_.canvas().accessibleName().toStdString(), "Drawing area");
}

TEST_F(ReadingSpeechTest, TheNameOfAnotherLayerIsSpoken) {
  LayerEvent event;
  event.what = LayerEvent::Do::kAdd;
  event.name = "Roads";
  window_.studio().apply(event);
  EXPECT_EQ(said("layer Roads").toStdString(), "layer Roads");
}

TEST(ColorWord, NamesTheUsualColours) {
  const auto word = [](int r, int g, int b) {
    return color_word({static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                       static_cast<std::uint8_t>(b), 255})
        .toStdString();
  };
  EXPECT_EQ(word(0, 0, 0), "black");
  EXPECT_EQ(word(31, 41, 44), "black");
  EXPECT_EQ(word(255, 255, 255), "white");
  EXPECT_EQ(word(90, 90, 95), "dark grey");
  EXPECT_EQ(word(170, 170, 170), "grey");
  EXPECT_EQ(word(200, 30, 30), "red");
  EXPECT_EQ(word(120, 70, 30), "brown");
  EXPECT_EQ(word(240, 140, 20), "orange");
  EXPECT_EQ(word(30, 150, 60), "green");
  EXPECT_EQ(word(30, 60, 200), "blue");
}

}  // namespace
}  // namespace felt::desktop::reading_speech_test
