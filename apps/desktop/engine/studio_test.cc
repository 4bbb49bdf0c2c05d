#include "desktop/engine/studio.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "desktop/engine/recording_file.h"
#include "felt/io/event_reader.h"
#include "felt/io/event_writer.h"
#include "felt/io/ndjson_writer.h"
#include "felt/session/recorder.h"

namespace felt::desktop {
namespace {

constexpr std::int64_t kMs = 1'000'000;

/// A studio on a virtual clock that keeps all its session receives.
struct Desk {
  std::vector<Event> events;
  std::vector<std::size_t> begins;  // of sessions, in events
  Studio studio;

  explicit Desk(const QString& device = QStringLiteral("tablet")) : studio(options(device)) {}

  StudioOptions options(const QString& device) {
    StudioOptions options;
    options.device = device;
    options.live = false;
    options.on_event = [this](const Event& event) { events.push_back(event); };
    options.on_session = [this](const Document&) { begins.push_back(events.size()); };
    return options;
  }
  void point(Point at, double pressure) {
    studio.point({studio.now_ns(), at, pressure > 0.0, pressure, 0});
  }
  void wait(std::int64_t ms) { studio.advance(ms * kMs); }
  /// A stroke of the tablet, 5 ms an event.
  void draw(Point from, Point to, double pressure = 0.5) {
    point(from, 0.0);
    wait(20);
    for (int i = 0; i <= 40; ++i) {
      const double t = i / 40.0;
      point({std::lerp(from.x, to.x, t), std::lerp(from.y, to.y, t) + 3.0 * std::sin(6.0 * t)},
            pressure * (0.8 + 0.2 * t));
      wait(5);
    }
    point(to, 0.0);
    wait(400);
  }
  [[nodiscard]] std::string drawing() const { return text_of(studio.session().sketch()); }

  static std::string text_of(const Sketch& sketch) {
    std::string text;
    for (const SketchStroke& stroke : sketch)
      append_sketch_line(text, stroke.id, stroke.stroke.data());
    return text;
  }
};

/// The drawing that the events give when they are written, read and told to another session.
std::string as_recorded(std::span<const Event> events, Document start = {}) {
  std::string text;
  for (const Event& event : events) append_event_line(text, event);
  const Result<std::vector<Event>> read = read_events("recording", read_text(text));
  EXPECT_TRUE(read.has_value()) << read.error().message;
  SessionOptions options;
  options.document = std::move(start);
  Session session(make_tools(), std::move(options));
  for (const Event& event : read.value()) {
    const Result<void> done = session.apply(event);
    EXPECT_TRUE(done.has_value()) << done.error().message;
  }
  EXPECT_TRUE(session.finish().has_value());
  return Desk::text_of(session.sketch());
}

void do_something(Desk& desk, std::mt19937& random) {
  const auto any = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  static constexpr const char* kTools[] = {"pencil", "pull", "eraser", "smooth", "lasso", "width"};
  Studio& studio = desk.studio;
  switch (random() % 9) {
    case 0:
      studio.apply(SelectTool{kTools[random() % std::size(kTools)]});
      break;
    case 1:
      studio.apply(UndoEvent{});
      break;
    case 2:
      studio.apply(RedoEvent{});
      break;
    case 3:
      studio.apply(SelectStrokes{});
      break;
    case 4:
      studio.apply(SetOption{"pencil.max_width_mm", any(1.0, 5.0)});
      break;
    case 5:
      studio.use_device(random() % 2 == 0 ? QStringLiteral("tablet")
                                          : QStringLiteral("simulated:touch"));
      break;
    case 6:
      studio.apply(DuplicateEvent{});
      break;
    default:
      desk.draw({any(10, 90), any(10, 90)}, {any(10, 90), any(10, 90)}, any(0.1, 1.0));
  }
}

// What a studio made is what its recording gives: byte for byte, whatever was done.
TEST(Studio, ARecordingAloneGivesTheDrawing) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    Desk desk(seed % 2 == 0 ? QStringLiteral("tablet") : QStringLiteral("simulated:touch"));
    desk.wait(700);
    for (int i = 0; i < 12; ++i) do_something(desk, random);
    desk.point({5, 5}, 0.0);
    desk.wait(1000);
    EXPECT_EQ(as_recorded(desk.events), desk.drawing()) << "seed " << seed;
  }
}

TEST(Studio, EventsAreToldInOrderOfTime) {
  std::mt19937 random(3);
  Desk desk;
  for (int i = 0; i < 20; ++i) do_something(desk, random);
  ASSERT_FALSE(desk.events.empty());
  EXPECT_TRUE(std::holds_alternative<UseDevice>(desk.events.front().what));
  for (std::size_t i = 1; i < desk.events.size(); ++i) {
    ASSERT_GE(desk.events[i].time_ns, desk.events[i - 1].time_ns) << i;
  }
}

// Another drawing keeps tool and options, and its recording says them.
TEST(Studio, OpenKeepsToolAndOptions) {
  Desk desk;
  desk.studio.apply(SelectTool{"eraser"});
  desk.studio.apply(SetOption{"pencil.max_width_mm", 4.5});
  desk.studio.apply(SetOption{"sheet.material", std::string("felt")});
  desk.draw({10, 10}, {60, 20});
  desk.studio.open(Document{}, SheetPage{});
  EXPECT_EQ(desk.studio.session().tool().info().id, "eraser");
  EXPECT_EQ(desk.studio.session().option("pencil.max_width_mm").value(), OptionValue(4.5));
  EXPECT_FALSE(desk.studio.is_modified());
  EXPECT_EQ(desk.studio.session().document().stroke_count(), 0u);
  desk.studio.apply(SelectTool{"pencil"});
  desk.draw({10, 30}, {70, 40});
  EXPECT_TRUE(desk.studio.is_modified());
  ASSERT_EQ(desk.begins.size(), 2u);
  const auto second = std::span<const Event>(desk.events).subspan(desk.begins[1]);
  EXPECT_EQ(as_recorded(second), desk.drawing());
}

TEST(Studio, BorrowingNests) {
  Desk desk;
  const auto tool = [&desk] { return std::string(desk.studio.session().tool().info().id); };
  int changes = 0;
  QObject::connect(&desk.studio, &Studio::tool_changed, [&changes] { ++changes; });
  desk.studio.borrow_tool(QStringLiteral("eraser"));
  EXPECT_EQ(tool(), "eraser");
  EXPECT_TRUE(desk.studio.is_borrowing());
  desk.studio.borrow_tool(QStringLiteral("pull"));
  EXPECT_EQ(tool(), "eraser") << "it counts, no more";
  desk.studio.give_back_tool();
  EXPECT_EQ(tool(), "eraser");
  desk.studio.give_back_tool();
  EXPECT_EQ(tool(), "pencil");
  EXPECT_EQ(changes, 2);
  desk.studio.give_back_tool();
  EXPECT_EQ(tool(), "pencil");
  desk.studio.borrow_tool(QStringLiteral("no such tool"));
  EXPECT_FALSE(desk.studio.is_borrowing());
  EXPECT_EQ(tool(), "pencil");
}

// Devices come and go; the session's time goes on, and ink drawn before stays.
TEST(Studio, TimeGoesOnWhenTheDeviceChanges) {
  Desk desk;
  desk.draw({10, 10}, {60, 20});
  double y = 20.0;
  for (const char* id : {"simulated:touch", "tablet", "simulated:premium"}) {
    ASSERT_TRUE(desk.studio.use_device(QString::fromLatin1(id))) << id;
    desk.wait(700);
    y += 20.0;
    desk.draw({10, y}, {60, y + 8.0});
  }
  for (std::size_t i = 1; i < desk.events.size(); ++i) {
    ASSERT_GE(desk.events[i].time_ns, desk.events[i - 1].time_ns) << i;
  }
  EXPECT_GE(desk.studio.session().document().stroke_count(), 4u);
  EXPECT_EQ(as_recorded(desk.events), desk.drawing());
}

// The loop fills its ring while the window is busy: 16 s of samples wait there.
TEST(Studio, SixteenSecondsWithoutATurnLoseNothing) {
  Desk desk;
  desk.point({10, 10}, 0.5);
  const auto samples = [&desk] {
    std::size_t count = 0;
    for (const Event& event : desk.events) count += std::holds_alternative<PenEvent>(event.what);
    return count;
  };
  desk.wait(50);
  const std::size_t before = samples();
  std::int64_t tick_ns = desk.studio.now_ns();
  for (int i = 0; i < 16'000; ++i) desk.studio.servo().step(tick_ns += kMs);
  desk.studio.turn();
  EXPECT_EQ(samples() - before, 16'000u);
  EXPECT_EQ(desk.studio.servo().for_edit().dropped(), 0u);
}

TEST(Studio, AdvanceIsDeterministic) {
  std::vector<std::string> drawings;
  for (int run = 0; run < 2; ++run) {
    std::mt19937 random(11);
    Desk desk(QStringLiteral("simulated:touch"));
    for (int i = 0; i < 10; ++i) do_something(desk, random);
    std::string text = desk.drawing();
    for (const Event& event : desk.events) append_event_line(text, event);
    drawings.push_back(std::move(text));
  }
  EXPECT_EQ(drawings[0], drawings[1]);
  EXPECT_FALSE(drawings[0].empty());
}

TEST(RecordingFile, WritesEachSessionIntoAFileOfItsOwn) {
  const QTemporaryDir folder;
  StudioOptions options;
  options.live = false;
  const QString path = folder.filePath(QStringLiteral("rec.ndjson"));
  const auto recording = record_into(path, options);
  std::string drawn;
  {
    Studio studio(options);
    studio.point({studio.now_ns(), {10, 10}, true, 0.5, 0});
    studio.advance(50 * kMs);
    studio.open(Document{}, SheetPage{});
    studio.point({studio.now_ns(), {20, 20}, true, 0.5, 0});
    studio.advance(50 * kMs);
    EXPECT_EQ(recording->path(), folder.filePath(QStringLiteral("rec-2.ndjson")));
    EXPECT_EQ(recording->error(), QString());
    recording->flush();
  }
  for (const char* name : {"rec.ndjson", "rec-2.ndjson"}) {
    QFile file(folder.filePath(QString::fromLatin1(name)));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const std::string text = file.readAll().toStdString();
    const auto events = read_events(name, read_text(text));
    ASSERT_TRUE(events.has_value()) << events.error().message;
    EXPECT_GT(events->size(), 40u);
    EXPECT_TRUE(std::holds_alternative<UseDevice>(events->front().what));
  }
  StudioOptions nowhere;
  nowhere.live = false;
  const auto failing = record_into(folder.filePath(QStringLiteral("no/folder/r.ndjson")), nowhere);
  Studio studio(nowhere);
  EXPECT_TRUE(failing->error().contains(QStringLiteral("no/folder/r.ndjson")));
  EXPECT_EQ(record_into(QString(), nowhere), nullptr);
}

TEST(Studio, TheSheetOfADrawingIsPartOfIt) {
  Studio studio({.live = false});
  studio.apply(SetOption{"sheet.material", std::string("felt")});
  EXPECT_FALSE(studio.is_modified());  // nothing is drawn
  studio.point({studio.now_ns(), {30, 40}, true, 0.5});
  studio.advance(100'000'000);
  studio.point({studio.now_ns(), {60, 40}, true, 0.5});
  studio.advance(100'000'000);
  studio.point({studio.now_ns(), {60, 40}, false, 0.0});
  studio.advance(300'000'000);
  studio.apply(SelectTool{"pull"});
  ASSERT_GT(studio.session().document().stroke_count(), 0u);
  studio.set_modified(false);
  studio.apply(SetOption{"sheet.material", std::string("felt")});
  EXPECT_FALSE(studio.is_modified());  // as it was
  studio.apply(SetOption{"sheet.color", std::string("#2040a0")});
  EXPECT_TRUE(studio.is_modified());
}

}  // namespace
}  // namespace felt::desktop
