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

/// A force of a recording is a multiple of this, in N: far finer than any device's.
inline constexpr double kRecordedForceStepN = 1e-4;
/// Larger ones are recorded as this, in N, and those that are no numbers as 0.
inline constexpr double kMostRecordedForceN = 100.0;

/// What the loop asked of the device at a sample, and what it sent after the safety chain.
struct RecordedForces {
  Force asked, sent;
  friend bool operator==(const RecordedForces&, const RecordedForces&) = default;
};

/// A sample as the session got it, to the last bit.
struct RecordedSample {
  std::int64_t time_ns = 0;  ///< since the session began
  PenEvent pen;
  std::optional<RecordedForces> forces;  ///< none where nobody knows, or there are none
  friend bool operator==(const RecordedSample&, const RecordedSample&) = default;
};

/// Everything else that the session was told.
struct RecordedEvent {
  std::size_t before_sample = 0;  ///< it came after so many samples
  Event event;                    ///< no PenEvent
  friend bool operator==(const RecordedEvent&, const RecordedEvent&) = default;
};

/// How a drawing was made, from an empty sheet: all that its session was told, and the forces of
/// the loop. Told to a session again it gives the same drawing, to the last bit; an event that
/// imports needs the file that it names.
struct FeltRecording {
  std::string device;                  ///< what the samples came from, for people
  std::int64_t period_ns = 1'000'000;  ///< of the loop
  std::vector<RecordedSample> samples;
  std::vector<RecordedEvent> events;
  friend bool operator==(const FeltRecording&, const FeltRecording&) = default;
};

/// Makes a recording while a session is worked with: every event goes to event() as the session
/// tells it (SessionOptions::on_event), the forces of every tick to forces(), before or after the
/// event of its sample. Edit thread.
class FeltRecorder {
 public:
  FeltRecorder(std::string device, std::int64_t period_ns);

  void event(const Event& event);
  void forces(std::int64_t time_ns, const Force& asked, const Force& sent);
  /// All of it; the recorder is empty then.
  [[nodiscard]] FeltRecording take();

 private:
  struct Tick {
    std::int64_t time_ns = 0;
    RecordedForces forces;
  };
  void match();

  FeltRecording recording_;
  std::vector<Tick> ticks_;    // whose sample has not come yet
  std::size_t unmatched_ = 0;  // samples from here on have no forces yet
  std::size_t next_tick_ = 0;  // in ticks_
  std::int64_t last_ns_ = 0;
};

/// Tells all events of it, in order, samples as pen events. Error: the first that `tell` gives.
Result<void> play_recording(const FeltRecording& recording,
                            const std::function<Result<void>(const Event&)>& tell);

/// What there is to know of a recording without reading it.
struct RecordingInfo {
  std::string device;
  std::int64_t period_ns = 0;
  std::int64_t samples = 0;
  std::int64_t events = 0;
  double duration_s = 0.0;
};

/// The recordings of a drawing that was read, the earliest first. Their samples are not read.
Result<std::vector<RecordingInfo>> recordings_of(const Drawing& drawing);
/// Reads one, checks it and its checksum. Error: there is none of that number (from 0), or it is
/// damaged; the message says where.
Result<FeltRecording> read_recording(const Drawing& drawing, std::size_t number);
/// That a recording holds only what one may hold, and in order. Error: names the sample or event.
Result<void> check_recording(const FeltRecording& recording);
/// Adds one to what the drawing's file will hold. Error: something that no recording may hold (a
/// place that is no number, times that run backwards).
Result<void> add_recording(Drawing& drawing, FeltRecording recording);

}  // namespace felt
