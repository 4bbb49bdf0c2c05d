#include "desktop/feel/force_panel.h"

#include <gtest/gtest.h>

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "desktop/feel/safety_words.h"
#include "felt/base/constants.h"

namespace felt::desktop::force_panel_test {
namespace {

TickReport tick_at(std::int64_t time_ns, double plane_n, double friction_n = 0.0) {
  TickReport tick;
  tick.sample.time_ns = time_ns;
  tick.terms.add("plane", {0, 0, plane_n});
  if (friction_n != 0.0) tick.terms.add("friction", {friction_n, 0, 0});
  tick.asked = {friction_n, 0, plane_n};
  tick.sent = 0.5 * tick.asked;
  return tick;
}

// For any timing of ticks, a bin has the maximum of its ticks, and ticks older than the history
// are removed.
TEST(ForceHistory, KeepsThePeakOfEachBinAndForgetsInTime) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto history = std::make_unique<ForceHistory>();
    std::vector<std::pair<std::int64_t, double>> reported;
    std::int64_t now = 0;
    for (int i = 0; i < 3000; ++i) {
      now += 1 + static_cast<std::int64_t>(random() % (i % 500 == 0 ? 9000 * kMs : 5 * kMs));
      const double force = 1e-3 * static_cast<double>(random() % 3000);
      reported.emplace_back(now, force);
      history->add(tick_at(now, force));
    }
    const std::int64_t newest = now / ForceHistory::kBinNs;
    std::vector<double> expected(ForceHistory::kBins, -1.0);
    double largest = 0.0;
    for (const auto& [time, force] : reported) {
      const std::int64_t age = newest - time / ForceHistory::kBinNs;
      if (age >= static_cast<std::int64_t>(ForceHistory::kBins)) continue;
      double& bin = expected[ForceHistory::kBins - 1 - static_cast<std::size_t>(age)];
      bin = std::max(bin, force);
      largest = std::max(largest, force);
    }
    for (std::size_t bin = 0; bin < ForceHistory::kBins; ++bin) {
      const std::int64_t number =
          newest - std::int64_t{ForceHistory::kBins} + 1 + std::int64_t(bin);
      ASSERT_NEAR(history->at(2, number), expected[bin], 1e-6) << bin;
      ASSERT_NEAR(history->at(ForceHistory::kSent, number),
                  expected[bin] < 0.0 ? -1.0 : 0.5 * expected[bin], 1e-6);
    }
    EXPECT_NEAR(history->largest(2), largest, 1e-6);
  }
}

TEST(ForceHistory, TermsAreKnownByNameAndShownAsFelt) {
  ForceHistory history;
  history.add(tick_at(kMs, 1.0));
  TickReport tick = tick_at(20 * kMs, 1.0, 0.4);
  tick.strength = 0.5;
  history.add(tick);
  ASSERT_EQ(history.tracks(), 4u);
  EXPECT_STREQ(history.name(3), "friction");
  EXPECT_FLOAT_EQ(history.now(2), 0.5F);
  EXPECT_FLOAT_EQ(history.now(3), 0.2F);
  history.add(tick_at(30 * kMs, 1.0));
  EXPECT_FLOAT_EQ(history.now(3), 0.0F) << "a term that is absent is none";
  history.add(tick_at(kMs, 2.0));  // the clock of another loop
  EXPECT_EQ(history.tracks(), 3u);
}

TEST(ForceHistory, NumbersThatAreNoneAndTooManyNamesAreSurvived) {
  static const char* const kNames[] = {"a", "b", "c", "d", "e", "f", "g", "h",
                                       "i", "j", "k", "l", "m", "n", "o", "p"};
  ForceHistory history;
  std::int64_t now = 0;
  for (const char* name : kNames) {
    TickReport tick;
    tick.sample.time_ns = now += kMs;
    tick.terms.add(name, {std::nan(""), 0, 0});
    tick.asked = {std::numeric_limits<double>::infinity(), 0, 0};
    history.add(tick);
  }
  EXPECT_EQ(history.tracks(), ForceHistory::kTracks);
  EXPECT_EQ(history.largest(ForceHistory::kAsked), 0.0F);
}

TEST(SafetyWords, EveryStateAndFaultHasWordsOfItsOwn) {
  QStringList faults;
  for (int fault = 1; fault <= static_cast<int>(SafetyFault::kSelfTest); ++fault) {
    const QString words = words_for(static_cast<SafetyFault>(fault));
    EXPECT_FALSE(words.isEmpty()) << fault;
    EXPECT_FALSE(faults.contains(words)) << fault;
    faults.push_back(words);
    SafetyReport report;
    report.state = SafetyState::kLatched;
    report.fault = static_cast<SafetyFault>(fault);
    const SafetyWords latched = words_for(report, true, false);
    EXPECT_TRUE(latched.state.contains(words));
    EXPECT_TRUE(latched.detail.contains(QStringLiteral("again")));
    EXPECT_EQ(latched.level, FeelLevel::kStopped);
  }
  for (int state = 0; state <= static_cast<int>(SafetyState::kLatched); ++state) {
    SafetyReport report;
    report.state = static_cast<SafetyState>(state);
    EXPECT_FALSE(words_for(report, true, true).state.isEmpty()) << state;
  }
}

struct Drawing {
  explicit Drawing(const QString& device) {
    StudioOptions options;
    options.device = device;
    options.live = false;
    studio = std::make_unique<Studio>(options);
  }
  void draw(int ms) {
    for (int i = 0; i < ms; i += 5) {
      const double t = 0.001 * i;
      studio->point({studio->now_ns(), {60 + 40 * t, 60 + 8 * std::sin(6 * t)}, i > 1000, 0.5});
      studio->advance(5 * kMs);
    }
  }
  std::unique_ptr<Studio> studio;
};

TEST(ForcePanel, ShowsWhatTheLoopDoesInAPlotAndInATable) {
  Drawing drawing(QStringLiteral("simulated:touch"));
  ForcePanel panel(*drawing.studio);
  panel.resize(900, 220);
  panel.show();
  drawing.draw(3000);
  const auto* table = panel.findChild<QTableWidget*>();
  ASSERT_NE(table, nullptr);
  EXPECT_TRUE(QTest::qWaitFor([&] { return table->rowCount() > 3; }));
  QStringList names;
  for (int row = 0; row < table->rowCount(); ++row) names << table->item(row, 0)->text();
  EXPECT_TRUE(names.contains(QStringLiteral("Surface")));
  EXPECT_TRUE(names.contains(QStringLiteral("Friction")));
  EXPECT_TRUE(names.contains(QStringLiteral("Sent to the pen")));
  EXPECT_GT(panel.history().largest(ForceHistory::kSent), 0.1F);
  EXPECT_FALSE(panel.grab().isNull());
}

// A plot that is drawn incrementally looks like one that is drawn completely.
TEST(ForceGraph, IsTheSameDrawnBitByBitOrAtOnce) {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto history = std::make_unique<ForceHistory>();
    ForceGraph bit_by_bit(*history);
    bit_by_bit.resize(QSize(317, 140) + QSize(int(random() % 400), int(random() % 60)));
    std::int64_t now = 0;
    double force = 0.5;
    for (int frame = 0; frame < 200; ++frame) {
      const int ticks = frame % 60 == 59 ? 900 : 33;
      for (int i = 0; i < ticks; ++i) {
        force =
            std::clamp(force + 0.02 * (static_cast<double>(random() % 201) - 100) / 100, 0.0, 0.9);
        history->add(tick_at(now += kMs, force, 0.3));
      }
      static_cast<void>(bit_by_bit.grab());
    }
    ForceGraph at_once(*history);
    at_once.resize(bit_by_bit.size());
    const QImage a = bit_by_bit.grab().toImage(), b = at_once.grab().toImage();
    // At a seam of two parts of a line, some pixels differ a little.
    int far_off = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) {
        far_off += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 60 ? 1 : 0;
      }
    }
    EXPECT_LT(far_off, a.width() * a.height() / 100);
  }
}

TEST(ForcePanel, APausedPlotStandsStillWhileTheHistoryGoesOn) {
  Drawing drawing(QStringLiteral("simulated:touch"));
  ForcePanel panel(*drawing.studio);
  panel.resize(900, 220);
  panel.show();
  drawing.draw(2500);
  panel.set_paused(true);
  ASSERT_TRUE(panel.is_paused());
  auto* graph = panel.findChild<ForceGraph*>();
  const QImage before = graph->grab().toImage();
  drawing.draw(2500);
  EXPECT_EQ(graph->grab().toImage(), before);
  panel.set_paused(false);
  EXPECT_NE(graph->grab().toImage(), before);
}

TEST(ForcePanel, WithoutMotorsItSaysSoAndPlotsWhatWouldBeAsked) {
  Drawing drawing(QStringLiteral("tablet"));
  ForcePanel panel(*drawing.studio);
  panel.show();
  drawing.draw(2500);
  QString text;
  for (const auto* label : panel.findChildren<QLabel*>()) text += label->text();
  EXPECT_TRUE(text.contains(QStringLiteral("Shown, not felt"))) << text.toStdString();
  EXPECT_EQ(panel.history().largest(ForceHistory::kSent), 0.0F);
}

}  // namespace
}  // namespace felt::desktop::force_panel_test
