// Tests constant forces with the simulated hand, device, haptic loop and safety chain together.
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/rt/servo.h"
#include "felt/rt/virtual_clock.h"
#include "felt/stroke/fit/width_map.h"
#include "felt/tools/pressing.h"

namespace felt::steady_push_test {
namespace {

constexpr Point kMiddle{60.0, 50.0};

/// A simulated pen in a typical hand, above the surface.
struct Pressed {
  explicit Pressed(const StylusPreset& preset) : device(preset) {
    center_workspace(device.capabilities, kMiddle);
    stylus.emplace(device, typical_hand());
    const Capabilities& can = device.capabilities;
    servo = std::make_unique<Servo>(
        *stylus, ServoOptions{.period_ns = can.period_ns, .limits = limits_for(can)});
    stylus->place({kMiddle.x, kMiddle.y, 3.0});
  }
  [[nodiscard]] const Capabilities& can() const { return device.capabilities; }

  StylusPreset device;
  std::optional<SimulatedStylus> stylus;
  std::unique_ptr<Servo> servo;
};

/// The range of line widths while a hand presses with a constant force for 60 s after the landing.
struct Widths {
  double min_mm = 1e9, max_mm = 0.0;
  double min_sent_n = 1e9;
};
Widths widths_of(const StylusPreset& preset, double push_n, double circle_mm) {
  Pressed pen(preset);
  const SurfaceMaterial& paper = surface_materials().front();
  pen.servo->publish(ForceModel(make_surface_force(paper, media().front(), pen.can())));
  pen.servo->arm();
  const Pressing pressing(paper, pen.can());
  const double depth_mm =
      1e3 * push_n * (1.0 / pressing.stiffness_n_per_m() + 1.0 / typical_hand().stiffness_n_per_m);
  Widths widths;
  double pressed = 0.0;  // pressure after the same low-pass filter as in the pencil
  VirtualClock clock(*pen.servo);
  while (clock.next_ns() < 62'000'000'000) {
    const double t_s = 1e-9 * static_cast<double>(clock.next_ns());
    const double landed = std::min(std::max(0.0, t_s - 0.8), 1.0);
    const double turn = 2.0 * std::numbers::pi * 0.5 * t_s;
    pen.stylus->aim({kMiddle.x + circle_mm * std::cos(turn), kMiddle.y + circle_mm * std::sin(turn),
                     3.0 - (3.0 + depth_mm) * landed},
                    {}, 0);
    const TickReport& tick = clock.tick();
    EXPECT_EQ(tick.safety.fault, SafetyFault::kNone);
    pressed += (pressing.of(tick.sample).value_or(0.0) - pressed) * tick.dt_s / 0.020;
    if (t_s < 2.0) continue;
    const double width = width_of_pressure({}, pressed);
    widths.min_mm = std::min(widths.min_mm, width);
    widths.max_mm = std::max(widths.max_mm, width);
    widths.min_sent_n = std::min(widths.min_sent_n, tick.sent.z);
  }
  return widths;
}

TEST(SteadyPush, R14_DrawsTheSameWidthHoweverWarmTheMotorsAre) {
  for (const StylusPreset& preset : stylus_presets()) {
    if (!preset.renders_surface()) continue;
    for (const double push_n : {0.3, 0.65, 0.98}) {
      const Widths widths = widths_of(preset, push_n, 0.0);
      EXPECT_LE(widths.max_mm - widths.min_mm, 0.05)
          << preset.name << ", " << push_n << " N: " << widths.min_mm << " to " << widths.max_mm
          << " mm";
      if (push_n > 0.9) {
        EXPECT_GT(widths.min_sent_n, 0.4) << preset.name << ": it is held";
      }
    }
  }
}

TEST(SteadyPush, R14_FullWidthCanBeHeldWhileDrawing) {
  const StylusPreset& touch = *find_stylus_preset("touch");
  const double full_n = firm_push_n(touch.capabilities);
  // The friction of the device reduces the force of the hand. The remaining force is slightly more
  // than full width needs.
  const Widths widths = widths_of(touch, full_n + 0.35, 15.0);
  EXPECT_NEAR(widths.max_mm, WidthMapOptions{}.max_mm, 1e-9);
  EXPECT_GT(widths.min_mm, WidthMapOptions{}.max_mm - 0.05);
}

TEST(SlowLoop, R30_R56_APullIsHeldByTheWholeLawAt250Hz) {
  for (const std::int64_t period_ns : {1'000'000, 4'000'000}) {
    StylusPreset premium = *find_stylus_preset("premium");
    premium.capabilities.period_ns = period_ns;
    Pressed pen(premium);
    const Point origin = kMiddle - Vec{12.0, 0.0};
    pen.servo->publish(ForceModel(EditSpring(origin)));
    pen.stylus->place({origin.x, origin.y, 1.0});
    pen.servo->arm();
    VirtualClock clock(*pen.servo);
    double sent_n = 0.0, far_mm = 0.0;
    while (clock.next_ns() < 4'000'000'000) {
      const double t_s = 1e-9 * static_cast<double>(clock.next_ns());
      const double way = std::min(std::max(0.0, (t_s - 1.0) / 1.5), 1.0);
      pen.stylus->aim({origin.x + 15.0 * way, origin.y, 1.0}, {}, 0);
      const TickReport& tick = clock.tick();
      sent_n = -tick.sent.x;
      far_mm = tick.sample.position.x - origin.x;
    }
    EXPECT_GT(far_mm, 8.0);
    EXPECT_NEAR(sent_n, kEditLaw.force_n(far_mm), 0.01) << period_ns;
  }
}

}  // namespace
}  // namespace felt::steady_push_test
