#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "felt/base/random.h"
#include "felt/store/felt_recording.h"

namespace felt::testing {

/// Makes recordings by hand: a pen without a simulated device, with a sample every 8 ms.
class DrawnRecording {
 public:
  static constexpr std::int64_t kStepNs = 8'000'000;

  /// Adds an event a moment after the last one.
  void add(Event event) {
    event.time_ns = now_ns_ += kStepNs;
    recorder_.event(event);
  }
  template <class What>
  void event(What what) {
    add({0, std::move(what)});
  }
  /// Waits without events.
  void pause(double seconds) { now_ns_ += static_cast<std::int64_t>(1e9 * seconds); }

  /// Draws a wave from one point to another with the tool in use, in `samples` samples.
  void line(Point from, Point to, int samples, double wave_mm = 2.0) {
    hover(from);
    for (int i = 0; i < samples; ++i) {
      const double share = samples > 1 ? static_cast<double>(i) / (samples - 1) : 0.0;
      const Point at = from + share * (to - from);
      event(PenEvent{{at.x, at.y + wave_mm * std::sin(9.0 * share), 0.0}, 0.4 + 0.3 * share});
    }
    hover(to);
  }
  /// Moves the pen above the surface, long enough for the tools to see that it was lifted.
  void hover(Point at) {
    for (int i = 0; i < 12; ++i) event(PenEvent{{at.x, at.y, 5.0}, 0.0});
  }
  [[nodiscard]] FeltRecording take() { return recorder_.take(); }

 private:
  FeltRecorder recorder_{"test", 1'000'000};
  std::int64_t now_ns_ = 0;
};

/// Returns a recording with everything that changes pictures, in a random order: strokes in three
/// layers and several colours, opacities, blend modes, layers that are hidden or out of view,
/// pulls, erasing, undo and redo.
inline FeltRecording random_recording(std::uint64_t seed, int steps) {
  Random random(seed);
  DrawnRecording made;
  const auto point = [&random] {
    return Point{random.between(5.0, 95.0), random.between(5.0, 65.0)};
  };
  const auto pick = [&random](int count) {
    return static_cast<int>(random.bits() % static_cast<std::uint64_t>(count));
  };
  LayerId layer{1};
  const auto change_layer = [&](LayerEvent::Do what) {
    made.event(
        LayerEvent{.what = what, .layer = layer, .opacity = 0.5, .mode = BlendMode::kMultiply});
  };
  for (int i = 0; i < 2; ++i) made.event(LayerEvent{.what = LayerEvent::Do::kAdd, .layer = {}});
  int drawn = 0;  // steps that an undo may take back without removing a layer
  for (int i = 0; i < steps; ++i) {
    layer = LayerId{1 + static_cast<std::uint64_t>(pick(3))};
    switch (pick(14)) {
      case 0:
        made.event(SetOption{"ink.color", std::string(pick(2) == 0 ? "#c0304080" : "#204080")});
        break;
      case 1:
        made.event(SelectTool{pick(2) == 0 ? "pull" : "eraser"});
        made.line(point(), point(), 30);
        made.event(SelectTool{"pencil"});
        break;
      case 2:
        if (drawn > 0) made.event(UndoEvent{});
        --drawn;
        break;
      case 3:
        made.event(RedoEvent{});
        break;
      case 4:
        change_layer(LayerEvent::Do::kShow);  // a hidden layer cannot be used
        change_layer(LayerEvent::Do::kUse);
        break;
      case 5:
        change_layer(LayerEvent::Do::kOpacity);
        break;
      case 6:
        change_layer(LayerEvent::Do::kBlend);
        break;
      case 7:
        change_layer(pick(2) == 0 ? LayerEvent::Do::kHide : LayerEvent::Do::kShow);
        break;
      case 8:
        made.event(pick(3) == 0 ? UseView{} : UseView{{layer}});
        break;
      default:
        made.line(point(), point(), 5 + pick(60));
        ++drawn;
    }
  }
  return made.take();
}

}  // namespace felt::testing
