#include "tests/devices/rt/scenarios.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "felt/base/constants.h"
#include "felt/devices/simulated/faulty_device.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/geometry/testing/ball.h"
#include "felt/haptics/bricks/damping.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/solid_surface.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/bricks/stabiliser.h"
#include "felt/haptics/force_model.h"
#include "felt/rt/null_device.h"
#include "tests/devices/drivers/driver_bench.h"
#include "tests/devices/rt/drawing_scenario.h"
#include "tests/devices/rt/driver_scenario.h"
#include "tests/devices/rt/editing_scenario.h"

namespace felt::rt_test {
namespace {

// A simulated stylus in a hand that scribbles and moves into the surface and out of it.
class Scribble : public Session {
 public:
  explicit Scribble(const char* preset = "touch", std::vector<FaultWindow> faults = {})
      : stylus_(*find_stylus_preset(preset)), faulty_(stylus_, std::move(faults)) {
    ServoOptions options;
    options.period_ns = stylus_.capabilities().period_ns;
    options.limits = limits_for(stylus_.capabilities());
    servo_ = std::make_unique<Servo>(faulty_, options);
    const Capabilities& device = stylus_.capabilities();
    middle_ = 0.5 * (device.workspace_min + device.workspace_max);
    servo_->arm();
  }

  Servo& servo() override { return *servo_; }
  void edit(int tick, std::int64_t now_ns) override {
    const double t_s = 1e-9 * static_cast<double>(now_ns);
    const double depth_mm = 3.0 * std::sin(2.0 * t_s);
    stylus_.aim(
        {middle_.x + 20.0 * std::sin(5.0 * t_s), middle_.y + 15.0 * std::cos(7.0 * t_s), -depth_mm},
        {}, tick % 512 == 0 ? 1 : 0);
    servo_->heartbeat(now_ns);
    if (tick % 700 == 0) servo_->arm();  // re-arms after a fault
    feel(tick);
    if (drains_) {
      PenSample sample;
      while (servo_->for_edit().pop(sample)) {
      }
      while (servo_->for_autosave().pop(sample)) {
      }
    }
  }

 protected:
  virtual void feel(int tick) = 0;
  template <class F>
  void publish(const F& functor, std::uint32_t fade_id) {
    ForceModel model(functor);
    model.set_fade_id(fade_id);
    servo_->publish(model);
  }
  [[nodiscard]] const Capabilities& device() const { return stylus_.capabilities(); }
  [[nodiscard]] const Vec3& middle() const { return middle_; }

  bool drains_ = true;

 private:
  SimulatedStylus stylus_;
  FaultyDevice faulty_;
  Vec3 middle_;
  std::unique_ptr<Servo> servo_;
};

// Publishes every surface with every medium in turn. Each model is cross-faded into the next.
class AllMaterials final : public Scribble {
 public:
  using Scribble::Scribble;

 private:
  void feel(int tick) override {
    if (tick % 30 != 0) return;
    const auto surfaces = surface_materials();
    const auto tools = media();
    const auto turn = static_cast<std::size_t>(tick / 30);
    const SurfaceMaterial& surface = surfaces[turn % surfaces.size()];
    const Medium& tool = tools[(turn / surfaces.size()) % tools.size()];
    publish(make_surface_force(surface, tool, device(), surface_grain(surface)),
            static_cast<std::uint32_t>(turn + 1));
  }
};

// Publishes every kind of brick in turn, several of them together. Each change comes while the
// previous one is still fading.
class AllBricks final : public Scribble {
 private:
  void feel(int tick) override {
    const auto surface = make_surface_force(surface_materials()[0], media()[0], device(),
                                            surface_grain(surface_materials()[0]));
    const Point here{middle().x, middle().y};
    const std::array<Point, 3> targets{here, here + Vec{5.0, 0.0}, here + Vec{0.0, 9.0}};
    const auto id = static_cast<std::uint32_t>(tick / 7 + 1);
    switch (tick / 7 % 5) {
      case 0:
        return publish(Compose(surface, SnapWells(targets), Damping()), id);
      case 1:
        return publish(Compose(surface, EditSpring(here)), id);
      case 2:
        return publish(Compose(surface, SweepSpring({.pen = here, .curve = here, .normal = {0, 1}}),
                               PushSpring({.pen = here, .normal = {0, 1}, .displacement_mm = 3.0})),
                       id);
      case 3:
        return publish(Compose(surface, Towed()), id);
      default:
        return publish(Compose(surface, Inertia(), Damping()), id);
    }
  }
};

// Lets the pen touch bodies of 10^5 triangles. Each is cross-faded into a slightly other one.
class Bodies final : public Scribble {
 private:
  static TriangleTree body(const Vec3& middle, double half_mm) {
    return TriangleTree(testing::ball({middle.x, middle.y, -half_mm + 1.0},
                                      {2.0 * half_mm, 2.0 * half_mm, half_mm}, 224, 224));
  }
  void feel(int tick) override {
    if (tick % 130 != 0) return;
    const auto turn = static_cast<std::uint32_t>(tick / 130);
    const SurfaceMaterial& paper = surface_materials()[0];
    publish(make_solid_surface(turn % 2 == 0 ? one_ : other_, paper, media()[0], device(), turn + 1,
                               surface_grain(paper)),
            turn + 1);
  }

  TriangleTree one_ = body(middle(), 20.0), other_ = body(middle(), 20.5);
};

// Publishes the force of the surface once, without other bricks.
class Paper : public Scribble {
 public:
  using Scribble::Scribble;

 protected:
  void feel(int tick) override {
    if (tick != 0) return;
    publish(make_surface_force(surface_materials()[0], media()[0], device()), 1);
  }
};

class HungEditSide final : public Paper {
 public:
  HungEditSide() { drains_ = false; }
};

// Simulates one fault after the other. The pauses between them let the forces engage again.
std::unique_ptr<Session> make_faulty() {
  std::vector<FaultWindow> faults;
  std::int64_t at_ms = 1000;
  for (const InjectedFault fault : injected_faults()) {
    faults.push_back({fault, at_ms * kMs, (at_ms + 50) * kMs, 20.0});
    at_ms += 1400;
  }
  return std::make_unique<Paper>("touch", std::move(faults));
}

class Mouse final : public Session {
 public:
  Servo& servo() override { return *servo_; }
  void edit(int tick, std::int64_t) override {
    if (tick % 8 == 0) device_.aim({0.01 * tick, 5.0, tick % 64 == 0 ? 1.0 : -1.0}, 0.5, 1);
  }

 private:
  NullDevice device_;
  std::unique_ptr<Servo> servo_ = std::make_unique<Servo>(device_, ServoOptions{});
};

template <class S>
std::unique_ptr<Session> make() {
  return std::make_unique<S>();
}

std::vector<Scenario> all_scenarios() {
  std::vector<Scenario> all{
      {"mouse", false, make<Mouse>},
      {"paper", true, make<Paper>},
      {"paper, 4 kHz", true, [] { return std::unique_ptr<Session>(new Paper("omega")); }},
      {"all materials", true, make<AllMaterials>},
      {"all bricks, always fading", true, make<AllBricks>},
      {"bodies of 10^5 triangles", true, make<Bodies>},
      {"a drawing session, pencil", true, make_drawing_session},
      {"editing, every tool", true, make_editing_session},
      {"edit side hangs", true, make<HungEditSide>},
      {"device faults", true, make_faulty},
  };
  for (const std::string_view bench : driver_bench_names()) {
    const std::string name = "driver " + std::string(bench);
    all.push_back({name, true, [bench] { return make_driver_session(bench, false); }});
    all.push_back({name + ", faults", true, [bench] { return make_driver_session(bench, true); }});
  }
  return all;
}

}  // namespace

std::span<const Scenario> scenarios() {
  static const std::vector<Scenario> all = all_scenarios();
  return all;
}

}  // namespace felt::rt_test
