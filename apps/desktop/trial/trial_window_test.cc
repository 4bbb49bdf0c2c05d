#include "desktop/trial/trial_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <fstream>
#include <memory>
#include <string_view>

#include "desktop/trial/testing/test_participant.h"
#include "desktop/trial/trial_start.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/replay/apply_recording.h"
#include "felt/store/felt_file.h"
#include "felt/studies/measured_trial.h"

namespace felt::desktop::trial_window_test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kShortStudy = R"(
id = "short"
label = "A short study"
blind = true
practice_trials = 1
questions = { forms = ["nasa-tlx", "ueq-s"], after = "session" }
[[condition]]
name = "free"
forces = false
[[condition]]
name = "towed"
settings = { "pencil.stabiliser" = "towed", "surface.material" = "blackboard" }
[[shape]]
name = "line"
kind = "line"
size_mm = 60
[[shape]]
name = "wave"
kind = "wave"
task = "tunnel"
tunnel_mm = 8
size_mm = 90
)";

constexpr const char* kOneTrial = R"(
id = "one"
[[condition]]
name = "free"
[[shape]]
name = "line"
kind = "line"
size_mm = 60
)";

class TrialWindowTest : public ::testing::Test {
 protected:
  void write_study(const std::string& text) { std::ofstream(study_path()) << text; }
  [[nodiscard]] std::string study_path() const {
    return folder_.path().toStdString() + "/my-study.toml";
  }
  [[nodiscard]] TrialRequest request() const {
    return {QString::fromStdString(study_path()), folder_.path() + QStringLiteral("/results"), 3};
  }
  [[nodiscard]] Result<TrialSetup> prepare(const char* device = "touch") const {
    const StylusPreset& preset = *find_stylus_preset(device);
    return prepare_trials(request(), QString::fromUtf8(preset.label.data()), preset.capabilities);
  }

  /// Opens a window, as the program does, but with a virtual clock.
  void open(const char* device = "touch") {
    Result<TrialSetup> setup = prepare(device);
    ASSERT_TRUE(setup) << setup.error().message;
    studio_ = std::make_unique<Studio>(
        StudioOptions{.device = QStringLiteral("simulated:") + QString::fromUtf8(device),
                      .live = false,
                      .reads_forces = true});
    lock_.emplace(std::move(setup->lock));
    run_ =
        std::make_unique<TrialRun>(std::move(setup->folder), std::move(setup->session), *studio_);
    window_ = std::make_unique<TrialWindow>(*run_, *studio_);
    window_->resize(1000, 750);
    window_->show();
    person_ = std::make_unique<TestParticipant>(
        *window_, [this](int ms) { studio_->advance(ms * 1'000'000LL); });
    QTest::qWait(20);
  }
  /// Ends the program without any further step, as a crash does.
  void crash() {
    window_.reset();
    run_.reset();
    studio_.reset();
    lock_.reset();
  }

  [[nodiscard]] const PlannedTrial& trial() const {
    return run_->session().plan.at(std::size_t(std::get<TrialStep>(run_->next()).trial.number - 1));
  }
  [[nodiscard]] StudyPath path() const {
    return run_->files().paths[std::get<TrialStep>(run_->next()).trial.shape];
  }
  [[nodiscard]] bool shows(const QWidget& screen) const {
    return window_->shown_screen() == &screen;
  }
  void draw_trial(double share = 1.0) {
    person_->draw(path(), share);
    person_->press(Qt::Key_Space);
  }
  /// Takes part until `stops` returns true or the session has ended.
  void take_part(const std::function<bool()>& stops = [] { return false; }) {
    bool has_ended = false;
    QObject::connect(window_.get(), &TrialWindow::ended, [&has_ended] { has_ended = true; });
    for (int i = 0; i < 200 && !has_ended && !stops(); ++i) {
      if (shows(window_->trial_screen())) {
        draw_trial();
        continue;
      }
      if (shows(window_->question_screen())) person_->answer(2);
      person_->press(Qt::Key_Return);
      QTest::qWait(1);
    }
  }
  [[nodiscard]] StudySession saved() const {
    const auto folder = StudyFolder::open(request().folder.toStdString());
    if (!folder) throw std::runtime_error(folder.error().message);
    const auto sessions = folder->sessions();
    if (!sessions) throw std::runtime_error(sessions.error().message);
    return sessions->at(0);
  }
  [[nodiscard]] FeltRecording recording(const TrialResult& result) const {
    const auto folder = StudyFolder::open(request().folder.toStdString());
    const auto session = saved();
    auto recording = folder->recording(session.info, result);
    if (!recording) throw std::runtime_error(recording.error().message);
    return *std::move(recording);
  }

  QTemporaryDir folder_;
  std::optional<FolderLock> lock_;
  std::unique_ptr<Studio> studio_;
  std::unique_ptr<TrialRun> run_;
  std::unique_ptr<TrialWindow> window_;
  std::unique_ptr<TestParticipant> person_;
};

TEST_F(TrialWindowTest, AWholeStudyIsPlayedAndSaved) {
  write_study(kShortStudy);
  open();
  EXPECT_TRUE(shows(window_->message_screen()));
  take_part();
  EXPECT_TRUE(window_->is_finished());
  crash();

  const StudySession session = saved();
  EXPECT_EQ(session.info.participant, 3);
  ASSERT_EQ(session.results.size(), session.plan.size());
  EXPECT_EQ(session.results.size(), 6u);  // two practice trials, two shapes in two conditions
  const auto folder = StudyFolder::open(request().folder.toStdString());
  for (std::size_t i = 0; i < session.plan.size(); ++i) {
    const PlannedTrial& planned = session.plan[i];
    EXPECT_EQ(session.results[i].trial, planned.number);
    EXPECT_EQ(session.results[i].invalid, "");
    const FeltRecording trial = recording(session.results[i]);
    const auto samples = trial_samples(trial);
    const TrialMetrics metrics = measure_recorded_trial(folder->files(), planned, samples);
    EXPECT_GT(metrics.ink_length_mm.value_or(0.0), 50.0);
    EXPECT_LT(metrics.err_mean_mm.value_or(99.0), 5.0);
    // Every tick has its forces, and they are on only in one of the conditions.
    double largest_n = 0.0;
    for (const RecordedSample& sample : trial.samples) {
      ASSERT_TRUE(sample.forces);
      const Force& sent = sample.forces->sent;
      largest_n = std::max({largest_n, std::abs(sent.x), std::abs(sent.y), std::abs(sent.z)});
    }
    EXPECT_EQ(largest_n > 0.0, planned.condition == 1) << i;
    EXPECT_LT(trial.events.empty() ? 1 : trial.events.front().event.time_ns, 1);
  }
  ASSERT_EQ(session.answers.size(), 2u);
  EXPECT_EQ(session.answers[0].values, std::vector<double>(6, 10.0));
  EXPECT_EQ(session.answers[1].values, std::vector<double>(8, 3.0));
  EXPECT_THAT(prepare().error().message, HasSubstr("participant 3 has already finished"));
}

TEST_F(TrialWindowTest, ForcesArePromisedOnlyByADeviceThatHasThem) {
  write_study(kOneTrial);
  for (const char* device : {"mouse", "touch"}) {
    open(device);
    QString shown;
    for (const QLabel* label : window_->message_screen().findChildren<QLabel*>()) {
      shown += label->text();
    }
    EXPECT_TRUE(shown.contains(QStringLiteral("press Space"))) << shown.toStdString();
    EXPECT_EQ(shown.contains(QStringLiteral("forces")), std::string_view(device) == "touch");
    crash();
  }
}

TEST_F(TrialWindowTest, OptionsOfATrialDoNotReachTheNext) {
  write_study(kShortStudy);
  open();
  bool has_towed = false, has_free = false;
  take_part([&] {
    if (!shows(window_->trial_screen())) return false;
    const bool is_towed = trial().condition == 1;
    const auto stabiliser = studio_->session().option("pencil.stabiliser");
    EXPECT_EQ(std::get<std::string>(*stabiliser) == "towed", is_towed);
    EXPECT_EQ(studio_->session().surface().id == "blackboard", is_towed);
    EXPECT_EQ(studio_->page().paper, Page{}.paper);
    EXPECT_EQ(studio_->session().document().stroke_count(), 0u);
    EXPECT_EQ(studio_->loop().forces_are_on(), is_towed);
    (is_towed ? has_towed : has_free) = true;
    return false;
  });
  EXPECT_TRUE(has_towed && has_free);
}

TEST_F(TrialWindowTest, DoneNeedsATouchAndIgnoresAHeldKey) {
  write_study(kOneTrial);
  open();
  person_->press(Qt::Key_Space);
  ASSERT_TRUE(shows(window_->trial_screen()));
  person_->press(Qt::Key_Space);
  EXPECT_TRUE(shows(window_->trial_screen()));
  person_->draw(path());
  person_->press(Qt::Key_Space, true);
  EXPECT_TRUE(shows(window_->trial_screen()));
  auto* done = window_->trial_screen().findChild<QPushButton*>();
  ASSERT_TRUE(done && done->isEnabled());
  done->click();
  EXPECT_TRUE(window_->is_finished());
}

TEST_F(TrialWindowTest, ARestCannotBeSkipped) {
  write_study(std::string("blocks = 2\nrest = { seconds = 1 }\n") + kOneTrial);
  open();
  person_->press(Qt::Key_Space);
  draw_trial();
  ASSERT_TRUE(shows(window_->message_screen()));
  for (int i = 0; i < 8; ++i) {
    person_->press(Qt::Key_Space);
    EXPECT_TRUE(shows(window_->message_screen()));
    QTest::qWait(100);
  }
  QTest::qWait(500);
  person_->press(Qt::Key_Space);
  EXPECT_TRUE(shows(window_->trial_screen()));
}

TEST_F(TrialWindowTest, ATrialThatBreaksARuleIsRepeated) {
  write_study(std::string("catch = { min_length_share = 0.8, action = \"repeat\" }\n") + kOneTrial);
  open();
  person_->press(Qt::Key_Space);
  draw_trial(0.0);  // only a dot
  ASSERT_TRUE(shows(window_->message_screen()));
  EXPECT_FALSE(window_->is_finished());
  person_->press(Qt::Key_Space);
  ASSERT_TRUE(shows(window_->trial_screen()));
  draw_trial();
  EXPECT_TRUE(window_->is_finished());
  const StudySession session = saved();
  ASSERT_EQ(session.results.size(), 2u);
  EXPECT_EQ(session.results[0].invalid, "min_length_share");
  EXPECT_EQ(session.results[1].invalid, "");
  EXPECT_EQ(session.results[1].attempt, 2);
}

TEST_F(TrialWindowTest, AStoppedSessionContinues) {
  write_study(kShortStudy);
  open();
  take_part([this] { return run_->session().results.size() == 2; });
  person_->draw(path(), 0.5);
  window_->stop();
  crash();
  EXPECT_EQ(saved().results.size(), 3u);
  EXPECT_EQ(saved().results.back().invalid, "interrupted");
  open();
  EXPECT_EQ(std::get<TrialStep>(run_->next()).trial.number, 3);
  EXPECT_EQ(std::get<TrialStep>(run_->next()).attempt, 2);
  take_part();
  EXPECT_TRUE(window_->is_finished());
  EXPECT_EQ(saved().results.size(), 7u);
}

TEST_F(TrialWindowTest, EscAsksBeforeItStops) {
  write_study(kOneTrial);
  open();
  person_->press(Qt::Key_Space);
  bool has_ended = false;
  QObject::connect(window_.get(), &TrialWindow::ended, [&has_ended] { has_ended = true; });
  for (const int wanted : {1, 0}) {  // first "Go on", then "Stop"
    QTimer::singleShot(20, [wanted] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_TRUE(box);
      EXPECT_TRUE(box->text().contains(QStringLiteral("Finished trials are saved.")));
      box->buttons().at(wanted)->click();
    });
    person_->press(Qt::Key_Escape);
    EXPECT_EQ(has_ended, wanted == 0);
  }
  crash();
  EXPECT_TRUE(saved().results.empty()) << "the pen has not touched";
}

TEST_F(TrialWindowTest, AnInterruptedTrialIsRecovered) {
  write_study(kOneTrial);
  open();
  person_->press(Qt::Key_Space);
  person_->draw(path());
  person_->draw(path(), 0.5);
  QTest::qWait(80);  // the events of a trial are written at most 50 ms later
  crash();
  ASSERT_TRUE(saved().results.empty());
  ASSERT_TRUE(prepare());
  const StudySession session = saved();
  ASSERT_EQ(session.results.size(), 1u);
  EXPECT_EQ(session.results[0].invalid, "interrupted");
  const auto samples = trial_samples(recording(session.results[0]));
  EXPECT_EQ(std::count_if(samples.begin() + 1, samples.end(),
                          [](const TrialSample& s) { return s.contact && !(&s - 1)->contact; }),
            2)
      << "both lines are there";
  EXPECT_FALSE(QFile::exists(request().folder +
                             QStringLiteral("/participant-0003/train/unfinished-1-1.ndjson")));
  open();
  EXPECT_EQ(std::get<TrialStep>(run_->next()).attempt, 2);
}

TEST_F(TrialWindowTest, RefusalsSayWhatIsWrong) {
  write_study(std::string("blocks = 0\n") + kOneTrial);
  EXPECT_THAT(prepare().error().message, HasSubstr("my-study.toml:1: blocks"));
  write_study(
      "id = \"x\"\n[[condition]]\nname = \"felt\"\nneeds = \"force\"\n"
      "[[shape]]\nname = \"line\"\nkind = \"line\"\n");
  const Result<TrialSetup> mouse = prepare("tablet");
  ASSERT_FALSE(mouse);
  EXPECT_THAT(mouse.error().message, HasSubstr("felt"));
  EXPECT_THAT(mouse.error().message, HasSubstr("device: "));
  EXPECT_FALSE(QFile::exists(request().folder)) << "a refusal creates no folder";
  ASSERT_TRUE(prepare("touch"));
  {
    const auto first = prepare("touch");
    EXPECT_THAT(prepare("touch").error().message, HasSubstr("in use by another program"));
  }
  write_study(kOneTrial);
  EXPECT_THAT(prepare().error().message, HasSubstr("has the results of another study"));
  TrialRequest wrong = request();
  wrong.session = QStringLiteral("post");
  const Capabilities& touch = find_stylus_preset("touch")->capabilities;
  EXPECT_THAT(prepare_trials(wrong, {}, touch).error().message, HasSubstr("post"));
  wrong.session = QStringLiteral("later");
  EXPECT_THAT(prepare_trials(wrong, {}, touch).error().message, HasSubstr("--session: 'later'"));
}

TEST_F(TrialWindowTest, TheParticipantCannotChangeToolOrView) {
  write_study(kOneTrial);
  open();
  person_->press(Qt::Key_Space);
  Canvas& canvas = window_->trial_screen().canvas();
  const CanvasView view = canvas.view();
  QWheelEvent wheel({50, 50}, {50, 50}, {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&canvas, &wheel);
  for (const Qt::MouseButton button : {Qt::RightButton, Qt::MiddleButton}) {
    for (const QEvent::Type type : {QEvent::MouseButtonPress, QEvent::MouseMove}) {
      QMouseEvent event(type, QPointF(80, 80), QPointF(80, 80), QPointF(80, 80),
                        type == QEvent::MouseMove ? Qt::NoButton : button, button, Qt::NoModifier);
      QApplication::sendEvent(&canvas, &event);
      studio_->advance(20'000'000);
    }
  }
  for (const int key : {int(Qt::Key_E), int(Qt::Key_2), int(Qt::Key_Z)}) person_->press(key);
  EXPECT_EQ(canvas.view(), view);
  EXPECT_EQ(studio_->session().tool().info().kind, ToolKind::kDraws);
  EXPECT_EQ(studio_->session().document().stroke_count(), 0u);
  EXPECT_FALSE(run_->has_contact());
}

TEST_F(TrialWindowTest, TrialsBeginWithTheirInkAndTool) {
  write_study(R"(
id = "tasks"
[[condition]]
name = "free"
[[shape]]
name = "over"
kind = "circle"
size_mm = 40
task = "retrace"
[[shape]]
name = "rub"
kind = "line"
size_mm = 90
task = "erase"
[[shape]]
name = "broad"
kind = "line"
size_mm = 60
task = "width"
width_mm = 3
)");
  open();
  const Rgba ink = studio_->session().ink_color();
  const std::size_t ink_before[] = {1, 5, 0};
  std::size_t seen = 0;
  take_part([&] {
    if (!shows(window_->trial_screen())) return false;
    const StudyTask task = run_->files().study.shapes[trial().shape].task;
    EXPECT_EQ(studio_->session().document().stroke_count(), ink_before[seen]) << seen;
    EXPECT_EQ(studio_->session().tool().info().kind == ToolKind::kDraws, task != StudyTask::kErase);
    EXPECT_EQ(studio_->session().ink_color(), ink) << "the line to draw over is lighter";
    ++seen;
    return false;
  });
  EXPECT_EQ(seen, 3u);
  EXPECT_TRUE(window_->is_finished());
  crash();
  const StudySession session = saved();
  const auto folder = StudyFolder::open(request().folder.toStdString());
  ASSERT_EQ(session.results.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    std::string bytes;
    const auto recording = folder->recording(session.info, session.results[i], &bytes);
    ASSERT_TRUE(recording);
    const Drawing drawing = parse_felt(bytes).value();
    Session replayed(make_tools(), {});
    ASSERT_TRUE(apply_recording(drawing, {}, replayed));
    EXPECT_EQ(replayed.document().stroke_count(), drawing.document.stroke_count()) << i;
    const TrialMetrics metrics = measure_recorded_trial(
        folder->files(), session.plan[i], trial_samples(*recording), drawing.document);
    EXPECT_EQ(metrics.erased_left_mm.has_value(), i == 1);
    EXPECT_EQ(metrics.width_cv.has_value(), i == 2);
    // The participant leads the eraser along the whole line.
    if (i == 1) EXPECT_GT(*metrics.erased_extra_mm, 20.0);
    if (i == 1) EXPECT_LT(*metrics.erased_left_mm, 1.0);
  }
}

TEST_F(TrialWindowTest, WithoutVisionThePageIsBlankWhileThePenDraws) {
  write_study(
      "id = \"x\"\n[[condition]]\nname = \"dark\"\nvision = false\n"
      "[[shape]]\nname = \"line\"\nkind = \"line\"\n");
  open();
  person_->press(Qt::Key_Space);
  person_->draw(path());
  const QImage seen = window_->trial_screen().canvas().grab().toImage();
  for (int y = 0; y < seen.height(); y += 3) {
    for (int x = 0; x < seen.width(); x += 3) {
      ASSERT_EQ(seen.pixelColor(x, y), QColor(Qt::white)) << x << ' ' << y;
    }
  }
  EXPECT_GT(studio_->session().document().stroke_count(), 0u);
}

}  // namespace
}  // namespace felt::desktop::trial_window_test
