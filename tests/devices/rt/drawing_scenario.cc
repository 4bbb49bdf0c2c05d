#include "tests/devices/rt/drawing_scenario.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "felt/devices/simulated/samples/drawings.h"
#include "felt/devices/simulated/scripted_hand.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/session/session.h"

namespace felt::rt_test {
namespace {

constexpr int kTurnTicks = 4;       // the edit side runs at every fourth tick
constexpr int kOptionTicks = 3000;  // between two changes of an option

using Choice = std::pair<const char*, const char*>;
constexpr std::array<Choice, 8> kChoices = {{{"pencil.medium", "chalk"},
                                             {"pencil.snap", "both"},
                                             {"surface.material", "blackboard"},
                                             {"pencil.stabiliser", "inertia"},
                                             {"pencil.medium", "felt-tip"},
                                             {"pencil.stabiliser", "towed"},
                                             {"surface.material", "felt"},
                                             {"pencil.snap", "off"}}};

class DrawingSession final : public Session {
 public:
  DrawingSession()
      : stylus_(*find_stylus_preset("touch")),
        session_(
            make_tools(),
            {.device = stylus_.capabilities(), .document = {}, .on_event = {}, .on_edit = {}}) {
    ServoOptions options;
    options.period_ns = stylus_.capabilities().period_ns;
    options.limits = limits_for(stylus_.capabilities());
    servo_ = std::make_unique<Servo>(stylus_, options);
    servo_->arm();
    const std::vector<Gesture> gestures = random_gestures(11, 40);
    aims_ = script_hand(gestures, HandOptions{},
                        script_options_for(*find_stylus_preset("touch"), typical_hand()));
  }

  Servo& servo() override { return *servo_; }

  void edit(int tick, std::int64_t now_ns) override {
    const TimedAim& aim = aims_[static_cast<std::size_t>(tick) % aims_.size()];
    stylus_.aim(aim.target_mm, aim.pressure, 0);
    if (tick % kTurnTicks != 0) return;
    PenSample sample;
    while (servo_->for_edit().pop(sample)) (void)session_.sample(sample);
    while (servo_->for_autosave().pop(sample)) {
    }
    if (tick % kOptionTicks == 0) {
      const Choice& choice =
          kChoices[static_cast<std::size_t>(tick / kOptionTicks) % kChoices.size()];
      (void)session_.apply({now_ns, SetOption{choice.first, std::string(choice.second)}});
    }
    servo_->heartbeat(now_ns);
    servo_->publish(session_.force());
  }

 private:
  SimulatedStylus stylus_;
  felt::Session session_;
  std::unique_ptr<Servo> servo_;
  std::vector<TimedAim> aims_;
};

}  // namespace

std::unique_ptr<Session> make_drawing_session() {
  return std::make_unique<DrawingSession>();
}

}  // namespace felt::rt_test
