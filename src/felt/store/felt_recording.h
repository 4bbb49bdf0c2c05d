#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/haptics/force.h"
#include "felt/haptics/pen_sample.h"
#include "felt/session/event.h"

namespace felt {

struct Drawing;

/// Recorded forces are multiples of this force, in N. It is much finer than the resolution of any
/// device.
inline constexpr double kRecordedForceStepN = 1e-4;
/// Largest recorded component of a force, in N. Larger components are clamped to
/// +-kMaxRecordedForceN; components that are not finite are recorded as 0.
inline constexpr double kMaxRecordedForceN = 100.0;

/// The force that the haptic loop computed at a sample, and the force that it sent to the device
/// after the safety chain.
struct RecordedForces {
  Force asked, sent;
  friend bool operator==(const RecordedForces&, const RecordedForces&) = default;
};

/// A sample as the session received it, bit for bit.
struct RecordedSample {
  std::int64_t time_ns = 0;  ///< time since the session began
  PenEvent pen;
  std::optional<RecordedForces> forces;  ///< absent if unknown, or if the device has no forces
  friend bool operator==(const RecordedSample&, const RecordedSample&) = default;
};

/// An event that the session received and that is not a pen sample.
struct RecordedEvent {
  std::size_t before_sample = 0;  ///< number of samples before this event
  Event event;                    ///< not a PenEvent
  friend bool operator==(const RecordedEvent&, const RecordedEvent&) = default;
};

/// How a drawing was made from an empty page: all events that its session received, and the forces
/// of the haptic loop. If the events are applied to a new session, they give the same drawing, bit
/// for bit. An import event also needs the file that it names.
struct FeltRecording {
  std::string device;                  ///< source of the samples, shown to the user
  std::int64_t period_ns = 1'000'000;  ///< period of the haptic loop
  std::vector<RecordedSample> samples;
  std::vector<RecordedEvent> events;
  friend bool operator==(const FeltRecording&, const FeltRecording&) = default;
};

/// Records a session while it runs. Pass every event of SessionOptions::on_event to event(), and
/// the forces of every tick to forces(). The forces of a tick may come before or after its sample.
/// Call on the edit thread.
class FeltRecorder {
 public:
  FeltRecorder(std::string device, std::int64_t period_ns);

  void event(const Event& event);
  void forces(std::int64_t time_ns, const Force& asked, const Force& sent);
  /// Returns the recording and empties the recorder.
  [[nodiscard]] FeltRecording take();

 private:
  struct Tick {
    std::int64_t time_ns = 0;
    RecordedForces forces;
  };
  void match();

  FeltRecording recording_;
  std::vector<Tick> ticks_;    // ticks whose sample has not arrived yet
  std::size_t unmatched_ = 0;  // index of the first sample that has not been matched with a tick
  std::size_t next_tick_ = 0;  // index in ticks_ of the next tick to match
  std::int64_t last_ns_ = 0;
};

/// Calls `report` for every event of a recording, in order, with samples as pen events. Stops at
/// the first error of `report` and returns it.
Result<void> play_recording(const FeltRecording& recording,
                            const std::function<Result<void>(const Event&)>& report);

/// Summary of a recording, available without reading its samples.
struct RecordingInfo {
  std::string device;
  std::int64_t period_ns = 0;
  std::int64_t samples = 0;
  std::int64_t events = 0;
  double duration_s = 0.0;
};

/// Returns summaries of a drawing's recordings, the earliest first. Does not read the recorded
/// samples.
Result<std::vector<RecordingInfo>> recordings_of(const Drawing& drawing);
/// Reads the recording at index `number` of recordings_of(), and checks its content and checksum.
/// Fails if the recording does not exist or is damaged; the message says where.
Result<FeltRecording> read_recording(const Drawing& drawing, std::size_t number);
/// Checks that the content of a recording is valid and in order. Fails with a message that names
/// the sample or event.
Result<void> check_recording(const FeltRecording& recording);
/// Adds a recording to a drawing, to be saved with it. Fails if the recording is not valid, for
/// example if a position is NaN or times run backwards.
Result<void> add_recording(Drawing& drawing, FeltRecording recording);

}  // namespace felt
