#include "felt/timelapse/timelapse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "felt/base/hash.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_materials.h"
#include "felt/material/relief.h"
#include "felt/timelapse/animated_svg.h"
#include "felt/timelapse/session_picture.h"
#include "felt/timelapse/shown_edit.h"
#include "felt/timelapse/testing/drawn_recording.h"

namespace felt::timelapse_test {
namespace {

constexpr Rect kArea{0.0, 0.0, 100.0, 70.0};

PageOptions page_of(int width_px, int height_px) {
  return page_in_frame(kArea, width_px, height_px).value();
}

/// Returns the document as a film shows it: with the gesture in progress.
Document shown_document(const Session& session) {
  Document shown = session.seen();
  const std::optional<Edit> edit = shown_edit(session);
  EXPECT_TRUE(!edit || shown.apply(*edit));
  return shown;
}

/// Plays a recording and compares the picture with that of the whole page every few events.
void expect_equal_to_the_page(const FeltRecording& recording, const PageOptions& page, int every) {
  const TimelapseSource source{recording};
  const auto picture = SessionPicture::create(page, Document()).value();
  Session session =
      session_of(source, [&](const Edit& edit) { ASSERT_TRUE(picture->apply(edit).has_value()); });
  int count = 0, gestures = 0;
  const auto compare = [&](const Event&) -> Result<void> {
    if (count++ % every != 0) return {};
    gestures += shown_edit(session).has_value();
    const Result<const Image*> frame = picture->update(session);
    const Result<Image> whole = render_page(shown_document(session), page, PictureChoice::kMarked);
    if (!frame || !whole) return fail(ErrorCode::kInvalidData, "no picture");
    if (**frame == *whole) return {};
    return fail(ErrorCode::kInvalidData, "differs before event " + std::to_string(count));
  };
  const Result<void> done = play_source(source, session, compare);
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  EXPECT_GT(gestures, 0) << "no frame shows a gesture in progress";
}

TEST(SessionPicture, IsEqualToTheWholePageByteForByte) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_equal_to_the_page(testing::random_recording(seed, 14), page_of(300, 210), 9);
  }
}

TEST(SessionPicture, IsEqualWithGrainOnColouredPaper) {
  PageOptions page = page_of(401, 233);  // odd, and with a margin on the left and on the right
  page.grain = Grain(surface_grain(surface_materials()[1]));
  page.paper = {250, 240, 210, 255};
  for (std::uint64_t seed = 20; seed <= 23; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_equal_to_the_page(testing::random_recording(seed, 8), page, 11);
  }
}

TEST(SessionPicture, PaintsOnlyWhatChanged) {
  testing::DrawnRecording made;
  for (int i = 0; i < 40; ++i) made.line({10.0, 10.0 + i}, {20.0, 10.0 + i}, 20, 0.2);
  const TimelapseSource source{made.take()};
  const auto picture = SessionPicture::create(page_of(1000, 700), Document()).value();
  Session session = session_of(source, [&](const Edit& edit) { (void)picture->apply(edit); });
  int updates = 0;
  const Result<void> done = play_source(source, session, [&](const Event&) -> Result<void> {
    (void)picture->update(session);
    ++updates;
    return {};
  });
  ASSERT_TRUE(done);
  EXPECT_LT(picture->painted_pixels(), std::int64_t{2} * 700'000 + std::int64_t{4000} * updates);
}

std::vector<std::uint64_t> hashes_of(const TimelapseSource& source, const FilmTiming& timing) {
  std::vector<std::uint64_t> hashes;
  const Result<void> done =
      play_timelapse(source, timing, page_of(200, 140), [&](const Image& frame) -> Result<void> {
        Fnv1a hash;
        hash.add(std::as_bytes(std::span(frame.bytes())));
        hashes.push_back(hash.value());
        return {};
      });
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  return hashes;
}

TEST(Timelapse, TheSameRecordingGivesTheSameFrames) {
  const TimelapseSource source{testing::random_recording(5, 20)};
  const FilmTiming timing(measure_recording(source.recording).drawing_ns, {3.0, 24, 0.5});
  const std::vector<std::uint64_t> first = hashes_of(source, timing);
  EXPECT_EQ(std::ssize(first), timing.frames());
  EXPECT_EQ(hashes_of(source, timing), first);
  EXPECT_GT(std::set<std::uint64_t>(first.begin(), first.end()).size(), first.size() / 3)
      << "the film moves";
}

/// A recording defines the media that it uses. Their styles are seen in every kind of film.
TEST(Timelapse, R57_LinesHaveTheStyleOfAMediumInTheRecording) {
  testing::DrawnRecording made;
  made.event(UseMaterial{"kind = \"medium\"\nid = \"dots\"\n[style]\nkind = \"dashes\"\n"});
  made.event(SetOption{"pencil.medium", std::string("dots")});
  made.line({10.0, 20.0}, {90.0, 20.0}, 40, 0.0);
  const TimelapseSource source{made.take()};
  const TimelapseSurvey survey = survey_recording(source).value();
  PageOptions page = page_of(300, 210);
  const Image plain = render_page(survey.end.document, page, PictureChoice::kMarked).value();
  page.grain = Grain::solid(with_texts(survey.end.materials));
  const Image dashed = render_page(survey.end.document, page, PictureChoice::kMarked).value();
  ASSERT_NE(plain, dashed);
  const FilmTiming timing(survey.drawing_ns, {2.0, 24, 0.5});
  std::optional<Image> last;
  ASSERT_TRUE(play_timelapse(source, timing, page_of(300, 210), [&](const Image& frame) {
    last = frame;
    return Result<void>();
  }));
  EXPECT_EQ(*last, dashed);
  const std::string svg = animated_svg(source, timing, {{0.0, 0.0, 100.0, 70.0}}).value();
  EXPECT_GT(std::count(svg.begin(), svg.end(), 'z'), 5) << "a path for each dash";
}

/// With an onion skin, a film shows the key drawing that the window showed.
TEST(Timelapse, ShowsOnlyTheKeyDrawingsThatWereInView) {
  testing::DrawnRecording made;
  made.line({10.0, 10.0}, {90.0, 10.0}, 20);
  made.event(LayerEvent{.what = LayerEvent::Do::kAdd, .layer = {}});
  made.event(UseView{{LayerId{1}}});
  made.line({10.0, 60.0}, {90.0, 60.0}, 20);
  testing::DrawnRecording whole = made;
  whole.event(UseView{});
  const auto last_frame = [](const TimelapseSource& source) {
    std::vector<Image> frames;
    const FilmTiming timing(measure_recording(source.recording).drawing_ns, {2.0, 24, 0.5});
    EXPECT_TRUE(play_timelapse(source, timing, page_of(200, 140), [&](const Image& frame) {
      frames.push_back(frame);
      return Result<void>();
    }));
    return frames.back();
  };
  const TimelapseSource source{made.take()};
  Document seen = survey_recording(source).value().end.document;
  const Image all = render_page(seen, page_of(200, 140), PictureChoice::kMarked).value();
  LayerState hidden = seen.layer(LayerId{1})->state();
  hidden.visible = false;
  ASSERT_TRUE(seen.apply({"", {}, {{LayerId{1}, seen.layer(LayerId{1})->state(), hidden, 0, 0}}}));
  EXPECT_EQ(last_frame(source),
            render_page(seen, page_of(200, 140), PictureChoice::kMarked).value());
  EXPECT_EQ(last_frame(TimelapseSource{whole.take()}), all) << "the view has ended";
}

TEST(Timelapse, EveryStrokeIsSeenByTheEndAndTheLastFrameIsTheDrawing) {
  testing::DrawnRecording made;
  for (int i = 0; i < 10; ++i) {
    made.line({10.0, 5.0 + 6.0 * i}, {90.0, 5.0 + 6.0 * i}, 40);
    made.pause(30.0);
  }
  const TimelapseSource source{made.take()};
  const TimelapseSurvey survey = survey_recording(source).value();
  EXPECT_EQ(survey.end.document.stroke_count(), 10U);
  EXPECT_TRUE(survey.has_moments);
  EXPECT_LT(survey.drawing_ns, 10 * (320 + 250 + 100) * std::int64_t{1'000'000});
  const PageOptions page = page_of(300, 210);
  const Image last = render_page(survey.end.document, page, PictureChoice::kMarked).value();
  const FilmTiming timing(survey.drawing_ns, {2.0, 24, 0.5});
  std::vector<Image> frames;
  ASSERT_TRUE(play_timelapse(source, timing, page, [&](const Image& frame) -> Result<void> {
    frames.push_back(frame);
    return {};
  }));
  ASSERT_EQ(frames.size(), 48U);
  for (std::size_t i = 36; i < 48; ++i) EXPECT_EQ(frames[i], last) << "the hold";
  EXPECT_NE(frames[34], last);
  // Frame by frame, ink only grows here.
  const auto dark = [](const Image& frame) {
    std::int64_t sum = 0;
    for (const std::uint8_t byte : frame.bytes()) sum += 255 - byte;
    return sum;
  };
  for (std::size_t i = 1; i < 36; ++i)
    EXPECT_GE(dark(frames[i]), 0.97 * static_cast<double>(dark(frames[i - 1]))) << i;
  EXPECT_GT(dark(frames[18]), dark(last) / 3);
  EXPECT_LT(dark(frames[18]), 2 * dark(last) / 3);
}

TEST(Timelapse, OneSampleOrNothingGivesAFilmOfTheEnd) {
  testing::DrawnRecording one;
  one.line({50.0, 35.0}, {50.0, 35.0}, 1);
  for (const FeltRecording& recording : {one.take(), FeltRecording{}}) {
    const TimelapseSource source{recording};
    const TimelapseSurvey survey = survey_recording(source).value();
    EXPECT_EQ(survey.has_moments, !recording.samples.empty());
    const FilmTiming timing(survey.drawing_ns, {1.0});
    EXPECT_EQ(hashes_of(source, timing).size(), 24U);
  }
}

TEST(Timelapse, EndsWhenTheSinkFails) {
  const TimelapseSource source{testing::random_recording(5, 20)};
  const FilmTiming timing(measure_recording(source.recording).drawing_ns, {3.0});
  int frames = 0;
  const Result<void> done =
      play_timelapse(source, timing, page_of(200, 140), [&](const Image&) -> Result<void> {
        if (++frames < 20) return {};
        return fail(ErrorCode::kIo, "cancelled");
      });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message, "cancelled");
  EXPECT_EQ(frames, 20);
}

TEST(Timelapse, ARefusedEventIsAnError) {
  testing::DrawnRecording made;
  made.line({10.0, 10.0}, {20.0, 20.0}, 10);
  made.event(SelectTool{"hammer"});
  EXPECT_FALSE(survey_recording({made.take()}));
}

TEST(Timelapse, BeginsWithTheDrawingThatItIsGiven) {
  testing::DrawnRecording first;
  first.line({10.0, 30.0}, {90.0, 30.0}, 40);
  const Drawing start = survey_recording({first.take()}).value().end;
  testing::DrawnRecording second;
  second.line({10.0, 50.0}, {90.0, 50.0}, 40);
  const TimelapseSource source{second.take(), start};
  const TimelapseSurvey survey = survey_recording(source).value();
  EXPECT_EQ(survey.end.document.stroke_count(), 2U);
  EXPECT_LT(survey.ink.y0, 35.0);
  const PageOptions page = page_of(200, 140);
  std::vector<Image> frames;
  ASSERT_TRUE(play_timelapse(source, FilmTiming(survey.drawing_ns, {1.0}), page,
                             [&](const Image& frame) -> Result<void> {
                               frames.push_back(frame);
                               return {};
                             }));
  EXPECT_EQ(frames.front(), render_page(start.document, page, PictureChoice::kMarked).value());
}

TEST(PageInFrame, ShowsTheWholeAreaInTheMiddle) {
  for (const auto& [width, height] : {std::pair{1280, 720}, {300, 999}, {17, 17}, {401, 233}}) {
    const PageOptions page = page_in_frame(kArea, width, height).value();
    EXPECT_LE(page.area->x0, 1e-9);
    EXPECT_GE(page.area->y1, 70.0 - 1e-9);
    EXPECT_NEAR(page.area->x0 + page.area->x1, 100.0, 1e-9);
    const Image image = render_page(Document(), page, PictureChoice::kMarked).value();
    EXPECT_EQ(image.width(), width);
    EXPECT_EQ(image.height(), height);
  }
  EXPECT_TRUE(page_in_frame({5.0, 5.0, 5.0, 5.0}, 100, 100)) << "a point";
  EXPECT_FALSE(page_in_frame(Rect{}, 100, 100));
  EXPECT_FALSE(page_in_frame({0.0, 0.0, std::numeric_limits<double>::infinity(), 1.0}, 100, 100));
  EXPECT_FALSE(page_in_frame(kArea, 0, 100));
}

}  // namespace
}  // namespace felt::timelapse_test
