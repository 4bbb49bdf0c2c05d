#include "desktop/engine/studio.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "desktop/engine/kept_options.h"
#include "desktop/engine/recording_file.h"
#include "desktop/engine/settings.h"
#include "desktop/engine/testing/kept_events.h"
#include "desktop/engine/testing/slate.h"
#include "felt/base/constants.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/events/event_reader.h"
#include "felt/io/events/event_writer.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/session/recorder.h"

namespace felt::desktop::studio_test {
namespace {

/// A studio on a virtual clock that keeps everything that its session receives.
struct Fixture {
  std::vector<Event> events;
  std::vector<std::size_t> begins;  // index of the first event of each session
  Studio studio;

  explicit Fixture(const QString& device = QStringLiteral("tablet")) : studio(options(device)) {}

  StudioOptions options(const QString& device) {
    StudioOptions options;
    options.device = device;
    options.live = false;
    options.connect_early = [this](Studio& created) {
      keep_events(events)(created);
      QObject::connect(&created, &Studio::session_began, &created,
                       [this] { begins.push_back(events.size()); });
    };
    return options;
  }
  void point(Point at, double pressure) {
    studio.point({studio.now_ns(), at, pressure > 0.0, pressure, 0});
  }
  void wait(std::int64_t ms) { studio.advance(ms * kMs); }
  /// Draws a stroke with the tablet, one event every 5 ms.
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
  [[nodiscard]] std::string drawing() const { return text_of(studio.session().document()); }

  static std::string text_of(const Document& document) {
    std::string text;
    append_sketch_lines(text, document);
    return text;
  }
};

/// Returns the drawing that results if the events are written, read and applied to another
/// session.
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
  return Fixture::text_of(session.document());
}

void do_something(Fixture& fixture, std::mt19937& random) {
  const auto any = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  static constexpr const char* kTools[] = {"pencil", "pull", "eraser", "smooth", "lasso", "width"};
  Studio& studio = fixture.studio;
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
      fixture.draw({any(10, 90), any(10, 90)}, {any(10, 90), any(10, 90)}, any(0.1, 1.0));
  }
}

// Replaying a studio's recording gives its drawing, byte for byte.
TEST(Studio, ARecordingAloneGivesTheDrawing) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    Fixture fixture(seed % 2 == 0 ? QStringLiteral("tablet") : QStringLiteral("simulated:touch"));
    fixture.wait(700);
    for (int i = 0; i < 12; ++i) do_something(fixture, random);
    fixture.point({5, 5}, 0.0);
    fixture.wait(1000);
    EXPECT_EQ(as_recorded(fixture.events), fixture.drawing()) << "seed " << seed;
  }
}

TEST(Studio, EventsAreToldInOrderOfTime) {
  std::mt19937 random(3);
  Fixture fixture;
  for (int i = 0; i < 20; ++i) do_something(fixture, random);
  ASSERT_FALSE(fixture.events.empty());
  EXPECT_TRUE(std::holds_alternative<UseDevice>(fixture.events.front().what));
  for (std::size_t i = 1; i < fixture.events.size(); ++i) {
    ASSERT_GE(fixture.events[i].time_ns, fixture.events[i - 1].time_ns) << i;
  }
}

// Opening another drawing keeps tool and options, and the recording contains them.
TEST(Studio, OpenKeepsToolAndOptions) {
  Fixture fixture;
  fixture.studio.apply(SelectTool{"eraser"});
  fixture.studio.apply(SetOption{"pencil.max_width_mm", 4.5});
  fixture.studio.apply(SetOption{"surface.material", std::string("felt")});
  fixture.draw({10, 10}, {60, 20});
  fixture.studio.open(Document{}, Page{});
  EXPECT_EQ(fixture.studio.session().tool().info().id, "eraser");
  EXPECT_EQ(fixture.studio.session().option("pencil.max_width_mm").value(), OptionValue(4.5));
  EXPECT_FALSE(fixture.studio.is_modified());
  EXPECT_EQ(fixture.studio.session().document().stroke_count(), 0u);
  fixture.studio.apply(SelectTool{"pencil"});
  fixture.draw({10, 30}, {70, 40});
  EXPECT_TRUE(fixture.studio.is_modified());
  ASSERT_EQ(fixture.begins.size(), 2u);
  const auto second = std::span<const Event>(fixture.events).subspan(fixture.begins[1]);
  EXPECT_EQ(as_recorded(second), fixture.drawing());
}

TEST(Studio, BorrowingNests) {
  Fixture fixture;
  const auto tool = [&fixture] { return std::string(fixture.studio.session().tool().info().id); };
  int changes = 0;
  QObject::connect(&fixture.studio, &Studio::tool_changed, [&changes] { ++changes; });
  fixture.studio.borrow_tool(QStringLiteral("eraser"));
  EXPECT_EQ(tool(), "eraser");
  EXPECT_TRUE(fixture.studio.is_borrowing());
  fixture.studio.borrow_tool(QStringLiteral("pull"));
  EXPECT_EQ(tool(), "eraser") << "it counts, no more";
  fixture.studio.give_back_tool();
  EXPECT_EQ(tool(), "eraser");
  fixture.studio.give_back_tool();
  EXPECT_EQ(tool(), "pencil");
  EXPECT_EQ(changes, 2);
  fixture.studio.give_back_tool();
  EXPECT_EQ(tool(), "pencil");
  fixture.studio.borrow_tool(QStringLiteral("no such tool"));
  EXPECT_FALSE(fixture.studio.is_borrowing());
  EXPECT_EQ(tool(), "pencil");
}

// The session's time continues when the device changes, and earlier ink stays.
TEST(Studio, TimeGoesOnWhenTheDeviceChanges) {
  Fixture fixture;
  fixture.draw({10, 10}, {60, 20});
  double y = 20.0;
  for (const char* id : {"simulated:touch", "tablet", "simulated:premium"}) {
    ASSERT_TRUE(fixture.studio.use_device(QString::fromLatin1(id))) << id;
    fixture.wait(700);
    y += 20.0;
    fixture.draw({10, y}, {60, y + 8.0});
  }
  for (std::size_t i = 1; i < fixture.events.size(); ++i) {
    ASSERT_GE(fixture.events[i].time_ns, fixture.events[i - 1].time_ns) << i;
  }
  EXPECT_GE(fixture.studio.session().document().stroke_count(), 4u);
  EXPECT_EQ(as_recorded(fixture.events), fixture.drawing());
}

// Between two publications, force models extrapolate by the age of the data that the tool used.
TEST(Studio, R30_TheLoopOfADeviceThatComesLaterKnowsTheSessionsTime) {
  Fixture fixture;
  fixture.wait(10'000);
  ASSERT_TRUE(fixture.studio.use_device(QStringLiteral("simulated:touch")));
  std::int64_t last_ns = 0;
  QObject::connect(&fixture.studio, &Studio::sampled,
                   [&](const PenSample& sample) { last_ns = sample.time_ns; });
  fixture.wait(50);
  Servo& servo = fixture.studio.loop().servo();
  EXPECT_GE(servo.session_offset_ns(), 10'000 * kMs);
  EXPECT_EQ(servo.latest().sample.time_ns + servo.session_offset_ns(), last_ns);
}

TEST(Studio, R30_TheLastSamplesOfALoopAreNotAheadOfTime) {
  StudioOptions options;
  options.device = QStringLiteral("simulated:touch");
  std::int64_t last_ns = 0;  // written to until the studio is destroyed
  Studio studio(std::move(options));
  QTest::qWait(100);
  std::this_thread::sleep_for(std::chrono::milliseconds(30));  // samples wait in the queue
  QObject::connect(&studio, &Studio::sampled, &studio,
                   [&](const PenSample& sample) { last_ns = sample.time_ns; });
  ASSERT_TRUE(studio.use_device(QStringLiteral("tablet")));
  EXPECT_LE(last_ns, studio.now_ns());
}

TEST(Studio, R14_TheSessionAndItsRecordingKnowTheForceLimit) {
  Fixture fixture(QStringLiteral("simulated:touch"));
  const Capabilities touch = fixture.studio.session().device();
  fixture.studio.loop().set_force_limit(0.3);
  EXPECT_EQ(fixture.studio.session().device(), with_force_limit(touch, 0.3));
  const auto* reported = std::get_if<UseDevice>(&fixture.events.back().what);
  ASSERT_NE(reported, nullptr);
  EXPECT_EQ(reported->capabilities.advised_force_n, 0.3);
  ASSERT_TRUE(fixture.studio.use_device(QStringLiteral("simulated:touch")));
  EXPECT_EQ(fixture.studio.session().device().advised_force_n, 0.3) << "kept for the next device";
  fixture.studio.loop().set_force_limit(3.0);
  EXPECT_EQ(fixture.studio.session().device(), touch);
}

/// Returns the distance from the place of a press to the beginning of the ink, after a motion of
/// 50 mm in 30 ms.
double hook_mm(const QString& device) {
  Fixture fixture(device);
  fixture.studio.apply(SetOption{"pencil.snap", std::string("off")});
  const Point from{40, 60}, press{90, 60};
  fixture.point(from, 0.0);
  fixture.wait(800);
  for (int ms = 1; ms <= 30; ++ms) {
    fixture.point({std::lerp(from.x, press.x, ms / 30.0), press.y}, 0.0);
    fixture.wait(1);
  }
  for (int ms = 0; ms <= 400; ++ms) {
    fixture.point({press.x, press.y + 0.1 * ms}, 0.5);
    fixture.wait(1);
  }
  fixture.point({press.x, press.y + 40.0}, 0.0);
  fixture.wait(2000);
  const std::vector<StrokePtr> ink = visible_strokes(fixture.studio.session().document());
  EXPECT_EQ(ink.size(), 1u);
  return ink.empty() ? 1e9 : distance(ink.front()->position(0.0), press);
}

TEST(Studio, R18_ALineOfASimulatedStylusBeginsAtThePress) {
  for (const PenDeviceInfo& device : pen_devices()) {
    if (!device.id.startsWith(QLatin1String("simulated:"))) continue;
    EXPECT_LT(hook_mm(device.id), 1.5) << device.id.toStdString();
  }
}

// The touch of a choice in a ring is not for the tool, even if the hand already touches again while
// the stylus is still on the surface.
TEST(Studio, ATouchRightAfterAChoiceInARingIsOneLine) {
  for (const PenDeviceInfo& device : pen_devices()) {
    const bool is_simulated = device.id.startsWith(QLatin1String("simulated:"));
    if (!is_simulated && device.id != QLatin1String("tablet")) continue;
    SCOPED_TRACE(device.id.toStdString());
    for (const int pause_ms : {0, 5, 60}) {
      Fixture fixture(device.id);
      fixture.studio.apply(SetOption{"pencil.snap", std::string("off")});
      const Point well{60, 40};
      fixture.point({60, 60}, 0.0);
      fixture.wait(800);
      fixture.studio.apply(UseRing{true, {60, 60}, well, {80, 60}});
      fixture.point(well, 0.5);
      fixture.wait(500);
      fixture.studio.apply(UseRing{});
      fixture.point(well, 0.0);
      if (pause_ms > 0) fixture.wait(pause_ms);
      for (int ms = 0; ms <= 400; ++ms) {
        fixture.point({well.x + 0.1 * ms, well.y}, 0.5);
        fixture.wait(1);
      }
      fixture.point({well.x + 40.0, well.y}, 0.0);
      fixture.wait(2000);
      const std::vector<StrokePtr> ink = visible_strokes(fixture.studio.session().document());
      ASSERT_EQ(ink.size(), 1u) << pause_ms;
      EXPECT_LT(distance(ink.front()->position(0.0), well), 1.5) << pause_ms;
    }
  }
}

TEST(Studio, TwoPressesShortlyOneAfterTheOtherAreTwoLines) {
  for (const PenDeviceInfo& device : pen_devices()) {
    if (!device.id.startsWith(QLatin1String("simulated:"))) continue;
    SCOPED_TRACE(device.id.toStdString());
    Fixture fixture(device.id);
    fixture.studio.apply(SetOption{"pencil.snap", std::string("off")});
    fixture.point({40, 60}, 0.0);
    fixture.wait(800);
    for (const double y : {60.0, 90.0}) {
      for (int ms = 0; ms <= 300; ++ms) {
        fixture.point({40.0 + 0.1 * ms, y}, 0.5);
        fixture.wait(1);
      }
      fixture.point({70.0, y}, 0.0);
      fixture.wait(20);
    }
    fixture.wait(2000);
    EXPECT_EQ(visible_strokes(fixture.studio.session().document()).size(), 2u);
  }
}

// While the window is busy, the loop fills its queue, which has space for samples of 16 s.
TEST(Studio, SixteenSecondsWithoutATurnLoseNothing) {
  Fixture fixture;
  fixture.point({10, 10}, 0.5);
  const auto samples = [&fixture] {
    std::size_t count = 0;
    for (const Event& event : fixture.events) count += std::holds_alternative<PenEvent>(event.what);
    return count;
  };
  fixture.wait(50);
  const std::size_t before = samples();
  std::int64_t tick_ns = fixture.studio.now_ns();
  for (int i = 0; i < 16'000; ++i) fixture.studio.loop().servo().step(tick_ns += kMs);
  fixture.studio.process();
  EXPECT_EQ(samples() - before, 16'000u);
  EXPECT_EQ(fixture.studio.loop().servo().for_edit().dropped(), 0u);
}

TEST(Studio, AdvanceIsDeterministic) {
  std::vector<std::string> drawings;
  for (int run = 0; run < 2; ++run) {
    std::mt19937 random(11);
    Fixture fixture(QStringLiteral("simulated:touch"));
    for (int i = 0; i < 10; ++i) do_something(fixture, random);
    std::string text = fixture.drawing();
    for (const Event& event : fixture.events) append_event_line(text, event);
    drawings.push_back(std::move(text));
  }
  EXPECT_EQ(drawings[0], drawings[1]);
  EXPECT_FALSE(drawings[0].empty());
}

/// A pen with a call that does not return until the test allows it.
struct HangingPen final : DriverDevice {
  struct Call {
    std::atomic<bool> hangs{false}, is_in{false};
    std::atomic<int> stops{0};
  };
  explicit HangingPen(Call& its_call) : call(its_call) {
    about.capabilities.max_force_n = about.capabilities.continuous_force_n = 3.0;
    about.capabilities.max_stiffness_n_per_m = 400.0;
    about.capabilities.max_damping_n_s_per_m = 4.0;
  }
  static std::unique_ptr<PenDevice> open(Call& call) {
    PenDeviceInfo info;
    info.id = QStringLiteral("hanging:1");
    info.label = QStringLiteral("The hanging one");
    return std::make_unique<PenDevice>(
        info, std::make_unique<OpenDevice>(std::make_unique<HangingPen>(call), PlaneCalibration(),
                                           DeviceSetup()));
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return about; }
  [[nodiscard]] DeviceStatus status() noexcept override { return {}; }
  [[nodiscard]] std::string_view name() const noexcept override { return "hanging"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return about.capabilities;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    while (call.hangs) {
      call.is_in = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return PenSample{now_ns, {10.0, 10.0, 5.0}, {}, {}, 0};
  }
  tl::expected<void, DeviceFault> write(const Force&) noexcept override { return {}; }
  void stop() noexcept override { ++call.stops; }

  Call& call;
  DeviceDescriptor about;
};

TEST(Studio, ADeviceThatHangsIsGivenUpAndTheDrawingGoesOn) {
  static HangingPen::Call call;  // the abandoned call may return at any time
  StudioOptions options;
  options.device = QStringLiteral("tablet");
  options.live = true;
  Studio studio(options);
  QStringList refused;
  QObject::connect(&studio, &Studio::refused, [&](const QString& why) { refused << why; });
  EXPECT_NE(studio.loop().use_device(HangingPen::open(call)), nullptr);
  call.hangs = true;
  while (!call.is_in) std::this_thread::sleep_for(std::chrono::milliseconds(1));

  studio.loop().set_force_limit(1.0);  // ends the loop
  EXPECT_EQ(studio.loop().device().info().id, QStringLiteral("tablet"));
  EXPECT_TRUE(HapticLoop::is_unresponsive(QStringLiteral("hanging:1")));
  ASSERT_EQ(refused.size(), 1);
  EXPECT_TRUE(refused.front().contains(QStringLiteral("The hanging one")));
  ASSERT_NE(studio.loop().thread(), nullptr);
  EXPECT_TRUE(studio.loop().thread()->is_running());
  EXPECT_EQ(call.stops, 0);
  call.hangs = false;
  while (call.stops == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));

  // The result is the same when another device replaces it: no device is returned.
  EXPECT_NE(studio.loop().use_device(HangingPen::open(call)), nullptr);
  call.is_in = false;
  call.hangs = true;
  while (!call.is_in) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  auto mouse = open_pen_device(QStringLiteral("tablet"));
  ASSERT_TRUE(mouse);
  EXPECT_EQ(studio.loop().use_device(*std::move(mouse)), nullptr);
  EXPECT_EQ(refused.size(), 2);
  call.hangs = false;
  while (call.stops == 1) std::this_thread::sleep_for(std::chrono::milliseconds(1));
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
    studio.open(Document{}, Page{});
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

TEST(Studio, TheSurfaceOfADrawingIsPartOfIt) {
  Studio studio({.live = false});
  studio.apply(SetOption{"surface.material", std::string("felt")});
  EXPECT_FALSE(studio.is_modified());  // nothing was drawn
  studio.point({studio.now_ns(), {30, 40}, true, 0.5});
  studio.advance(100'000'000);
  studio.point({studio.now_ns(), {60, 40}, true, 0.5});
  studio.advance(100'000'000);
  studio.point({studio.now_ns(), {60, 40}, false, 0.0});
  studio.advance(300'000'000);
  studio.apply(SelectTool{"pull"});
  ASSERT_GT(studio.session().document().stroke_count(), 0u);
  studio.set_modified(false);
  studio.apply(SetOption{"surface.material", std::string("felt")});
  EXPECT_FALSE(studio.is_modified());  // the saved state again
  studio.apply(SetOption{"ink.color", std::string("#2040a0")});
  EXPECT_TRUE(studio.is_modified());
}

// A page names its surface. If it names none, the surface that the user chose stays.
TEST(Studio, ThePageKnowsItsSurface) {
  Studio studio({.live = false});
  const auto surface_id = [&studio] { return studio.session().surface().id; };
  std::vector<QString> reported, refused;
  QObject::connect(&studio, &Studio::option_changed,
                   [&reported](const QString& id) { reported.push_back(id); });
  QObject::connect(&studio, &Studio::refused,
                   [&refused](const QString& w) { refused.push_back(w); });
  EXPECT_EQ(studio.page().surface, "");
  studio.apply(SetOption{"surface.material", std::string("felt")});
  EXPECT_EQ(studio.page().surface, "felt");

  Page page;
  studio.open(Document{}, page);  // as a file that was written before surfaces existed
  EXPECT_EQ(surface_id(), "felt");
  EXPECT_EQ(studio.page().surface, "");

  reported.clear();
  page.surface = "glass";
  studio.open(Document{}, page);
  EXPECT_EQ(surface_id(), "glass");
  EXPECT_EQ(reported, std::vector<QString>{QStringLiteral("surface.material")});
  EXPECT_FALSE(studio.is_modified());
  EXPECT_TRUE(refused.empty());

  page.surface = "moon dust";
  studio.open(Document{}, page);
  EXPECT_EQ(surface_id(), "glass");
  EXPECT_EQ(studio.page().surface, "moon dust");  // saved unchanged
  EXPECT_FALSE(studio.is_modified());
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_TRUE(refused[0].contains(QStringLiteral("moon dust")));

  page.surface = "wood";
  studio.set_page(page);
  EXPECT_EQ(surface_id(), "wood");
  EXPECT_TRUE(studio.is_modified());
}

// A user-defined material applies immediately, by an event if it changed, and survives open().
TEST(Studio, KnowsAPersonsOwnMaterials) {
  Materials known = Materials::built_in();
  known.put(slate(0.5));
  std::vector<Event> events;
  Studio studio({.live = false, .connect_early = keep_events(events), .materials = known});
  const auto reported = [&events] {
    return std::count_if(events.begin(), events.end(), [](const Event& event) {
      return std::holds_alternative<UseMaterial>(event.what);
    });
  };
  EXPECT_EQ(reported(), 0) << "nobody uses it yet";
  ASSERT_TRUE(studio.apply(SetOption{"surface.material", std::string("slate")}));
  EXPECT_EQ(studio.session().surface(), slate(0.5));
  EXPECT_EQ(reported(), 1) << "a recording has what it needs";
  known.put(slate(0.7));
  studio.set_user_materials(known);
  studio.set_user_materials(known);
  EXPECT_EQ(studio.session().surface().friction, 0.7);
  EXPECT_EQ(reported(), 2);
  studio.open(Document{}, Page{});
  EXPECT_EQ(studio.session().surface(), slate(0.7));
}

TEST(Studio, ADrawingBringsItsMaterialsAlongAndTakesThemAwayAgain) {
  Studio studio({.live = false});
  std::vector<QString> refused;
  QObject::connect(&studio, &Studio::refused,
                   [&refused](const QString& why) { refused.push_back(why); });
  Page page;
  page.surface = "slate";
  const std::vector<std::string> texts{write_material(slate(0.5)), "kind = \"surface\"\n"};
  studio.open(Document{}, page, texts);
  EXPECT_EQ(studio.session().surface(), slate(0.5));
  EXPECT_NE(studio.materials().find_surface("slate"), nullptr);
  EXPECT_EQ(refused.size(), 1u) << "the one that cannot be read";
  EXPECT_FALSE(studio.is_modified());
  page.surface = "paper";
  studio.open(Document{}, page);
  EXPECT_EQ(studio.materials().find_surface("slate"), nullptr);
}

TEST(Studio, UndoingEverythingIsNoChange) {
  Fixture fixture;
  fixture.draw({20, 20}, {60, 60});
  EXPECT_TRUE(fixture.studio.is_modified());
  fixture.studio.apply(UndoEvent{});
  EXPECT_FALSE(fixture.studio.is_modified());
  fixture.studio.apply(RedoEvent{});
  EXPECT_TRUE(fixture.studio.is_modified());
  fixture.studio.set_modified(false);  // saved
  fixture.studio.apply(UndoEvent{});
  EXPECT_TRUE(fixture.studio.is_modified()) << "the file has more";
  fixture.studio.apply(RedoEvent{});
  EXPECT_FALSE(fixture.studio.is_modified());
  Page page = fixture.studio.page();
  page.width_mm += 10;
  fixture.studio.set_page(page);
  fixture.studio.apply(UndoEvent{});
  fixture.studio.apply(RedoEvent{});
  EXPECT_TRUE(fixture.studio.is_modified()) << "the page is no step of the history";
}

TEST(Studio, BeginsWithASmoothThinLineInTheColourOfItsMedium) {
  const Studio studio({.live = false});
  const auto option = [&studio](const char* id) { return studio.session().option(id).value(); };
  const Medium* medium = find_medium(std::get<std::string>(option("pencil.medium")));
  ASSERT_TRUE(medium);
  EXPECT_EQ(medium->look.grain, 0.0);
  const double thin = std::get<double>(option("pencil.min_width_mm"));
  const double broad = std::get<double>(option("pencil.max_width_mm"));
  const double share = std::get<double>(option("pencil.mouse_pressure"));
  const double mouse_mm = thin + (broad - thin) * share;
  EXPECT_GE(mouse_mm, 0.3);
  EXPECT_LE(mouse_mm, 1.5);
  const Rgba color = studio.session().ink_color();
  EXPECT_EQ(std::uint32_t{color.r} << 16U | std::uint32_t{color.g} << 8U | color.b,
            medium->color_rgb);
}

/// The simulated hand presses so hard that the width equals that of the tablet's pressure, for any
/// force limit of the device and any stiffness of the surface.
TEST(Studio, R18_APressureDrawsTheSameWidthOnEveryDeviceAndSurface) {
  const auto width_mm = [](const char* device, const char* surface, double pressure) {
    Fixture fixture(QString::fromLatin1(device));
    fixture.studio.apply(SetOption{"surface.material", std::string(surface)});
    fixture.wait(1500);  // time until forces are on
    fixture.draw({40, 40}, {90, 50}, pressure);
    const auto strokes = visible_strokes(fixture.studio.session().document());
    if (strokes.size() != 1) return 0.0;
    return strokes[0]->width_mm(0.5 * strokes[0]->segment_count());
  };
  const Fixture fixture;
  const auto option = [&fixture](const char* id) {
    return std::get<double>(fixture.studio.session().option(id).value());
  };
  const double range_mm = option("pencil.max_width_mm") - option("pencil.min_width_mm");
  for (const double pressure : {0.3, 0.6, 0.9}) {
    const double tablet_mm = width_mm("tablet", "paper", pressure);
    for (const char* device : {"simulated:touch", "simulated:premium"}) {
      for (const char* surface : {"felt", "paper", "glass"}) {
        EXPECT_NEAR(width_mm(device, surface, pressure), tablet_mm, 0.12 * range_mm)
            << device << ", " << surface << ", " << pressure;
      }
    }
  }
}

TEST(Studio, WithoutMotorsTheLoopSleepsUntilTheNextEvent) {
  std::atomic<int> samples{0};
  StudioOptions options;
  options.rest_ns = 30 * kMs;
  Studio studio(std::move(options));
  QObject::connect(&studio, &Studio::sampled, &studio, [&samples] { ++samples; });
  ASSERT_TRUE(studio.loop().thread());
  const auto until = [](const std::function<bool()>& done) {
    for (int i = 0; i < 2000 && !done(); ++i) QTest::qWait(5);
    return done();
  };
  ASSERT_TRUE(until([&] { return studio.loop().thread()->is_paused(); }));
  QTest::qWait(50);  // waits for pending ticks
  const int before = samples;
  QTest::qWait(300);
  EXPECT_EQ(samples, before) << "no tick, no turn";
  EXPECT_FALSE(studio.loop().device_status().fault);
  for (const bool down : {false, true, true}) {
    studio.point({studio.now_ns(), {40, 40}, down, 0.5, 0});
    QTest::qWait(20);
  }
  ASSERT_TRUE(until([&] { return samples > before && in_contact(studio.pen().sample); }));
  QTest::qWait(200);
  EXPECT_FALSE(studio.loop().thread()->is_paused()) << "a line is being drawn";
  studio.point({studio.now_ns(), {45, 40}, false, 0.0, 0});
  ASSERT_TRUE(until([&] { return studio.loop().thread()->is_paused(); }));
  EXPECT_EQ(studio.session().document().stroke_count(), 1U);
  ASSERT_TRUE(studio.use_device(QStringLiteral("simulated:touch")));
  QTest::qWait(200);
  EXPECT_FALSE(studio.loop().thread()->is_paused()) << "a body moves by itself";
}

TEST(Studio, DrawingEndsTheSelectionThatAPasteMade) {
  Fixture fixture;
  fixture.draw({20, 20}, {60, 20});
  fixture.studio.apply(SelectStrokes{});
  fixture.studio.apply(DuplicateEvent{});  // the copy is selected, as after a paste or an import
  ASSERT_FALSE(fixture.studio.session().selection().empty());
  fixture.studio.apply(SelectTool{"lasso"});
  fixture.studio.apply(SelectTool{"pencil"});
  ASSERT_FALSE(fixture.studio.session().selection().empty()) << "a tool alone changes nothing";
  fixture.draw({20, 80}, {60, 80});
  EXPECT_TRUE(fixture.studio.session().selection().empty());
  const std::string before = fixture.drawing();
  fixture.studio.apply(RestyleEvent{.color = "#b02020"});
  EXPECT_EQ(fixture.drawing(), before) << "a colour for the next line is only that";
  EXPECT_EQ(as_recorded(fixture.events), fixture.drawing());
}

TEST(KeptOptions, ChoicesForAFewGesturesAreNotKept) {
  Settings& settings = Settings::the();
  Studio studio({.live = false});
  const KeptOptions kept(studio);
  studio.apply(SetOption{"transform.duplicate", true});
  studio.apply(SetOption{"transform.constrain", true});
  studio.apply(SetOption{"lasso.combine", std::string("subtract")});
  for (const char* id : {"transform.duplicate", "transform.constrain", "lasso.combine"}) {
    EXPECT_FALSE(settings.value(QStringLiteral("options/") + QString::fromLatin1(id)).isValid());
  }
  settings.set(QStringLiteral("options/transform.duplicate"),
               true);  // stored by an earlier version
  Studio next({.live = false});
  const KeptOptions again(next);
  EXPECT_EQ(next.session().option("transform.duplicate").value(), OptionValue(false));
  settings.reset(QStringLiteral("options/transform.duplicate"));
}

TEST(KeptOptions, AnotherStartBeginsWithThem) {
  Settings& settings = Settings::the();
  {
    Studio studio({.live = false});
    const KeptOptions kept(studio);
    studio.apply(SetOption{"pencil.medium", std::string("charcoal")});
    studio.apply(SetOption{"pencil.max_width_mm", 3.5});
    studio.apply(SetOption{"pencil.snap", std::string("force")});
    studio.apply(SetOption{"pencil.stabiliser", std::string("towed")});
    studio.apply(SetOption{"eraser.mode", std::string("stroke")});
    studio.apply(SetOption{"ink.color", std::string("#b02020")});
    studio.apply(SetOption{"pencil.refine", false});
    studio.apply(SetOption{"pencil.refine", true});
  }
  EXPECT_FALSE(settings.value(QStringLiteral("options/pencil.refine")).isValid())
      << "what is as at first is not stored";
  settings.set(QStringLiteral("options/pencil.gamma"), 1e9);
  settings.set(QStringLiteral("options/pull.mode"), QStringLiteral("no such"));
  Studio next({.live = false});
  const KeptOptions kept(next);
  const auto option = [&next](const char* id) { return next.session().option(id).value(); };
  EXPECT_EQ(option("pencil.medium"), OptionValue(std::string("charcoal")));
  EXPECT_EQ(option("pencil.max_width_mm"), OptionValue(3.5));
  EXPECT_EQ(option("pencil.snap"), OptionValue(std::string("force")));
  EXPECT_EQ(option("pencil.stabiliser"), OptionValue(std::string("towed")));
  EXPECT_EQ(option("eraser.mode"), OptionValue(std::string("stroke")));
  EXPECT_EQ(option("ink.color"), OptionValue(std::string("#b02020")));
  EXPECT_EQ(option("pencil.gamma"), OptionValue(1.0)) << "out of range";
  for (const char* id : {"pencil.medium", "pencil.max_width_mm", "pencil.snap", "pencil.stabiliser",
                         "eraser.mode", "ink.color", "pencil.gamma", "pull.mode"}) {
    settings.reset(QStringLiteral("options/") + QString::fromLatin1(id));
  }
}

TEST(KeptOptions, AreReadByTheirFormerIds) {
  Settings& settings = Settings::the();
  settings.set(QStringLiteral("options/pencil.material"), QStringLiteral("charcoal"));
  settings.set(QStringLiteral("options/sheet.color"), QStringLiteral("#b02020"));
  Studio studio({.live = false});
  const KeptOptions kept(studio);
  EXPECT_EQ(studio.session().option("pencil.medium"), OptionValue(std::string("charcoal")));
  EXPECT_EQ(studio.session().ink_color(), (Rgba{0xb0, 0x20, 0x20, 255}));
  settings.reset(QStringLiteral("options/pencil.material"));
  settings.reset(QStringLiteral("options/sheet.color"));
}

TEST(Studio, AFormerOptionIdIsReportedByItsPresentId) {
  Studio studio({.live = false});
  std::vector<QString> changed;
  QObject::connect(&studio, &Studio::option_changed, &studio,
                   [&changed](const QString& id) { changed.push_back(id); });
  studio.apply(SetOption{"pencil.material", std::string("chalk")});
  studio.apply(SetOption{"sheet.material", std::string("wood")});
  EXPECT_EQ(changed, (std::vector<QString>{QStringLiteral("pencil.medium"),
                                           QStringLiteral("surface.material")}));
  EXPECT_EQ(studio.page().surface, "wood");
}

}  // namespace
}  // namespace felt::desktop::studio_test
