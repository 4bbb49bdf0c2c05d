#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/autosave/working_store.h"
#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/haptics/pen_sample.h"
#include "felt/session/event.h"
#include "felt/tools/contact.h"

namespace felt {

struct LiveChunk {
  LiveKind kind = LiveKind::kEvents;
  std::string bytes;
};

/// What of a drawing is not an edit yet, as chunks of a working store: the gesture in work, with
/// all that its ink depends on besides the document. It hears the same from two sides:
///   - what the session was *told*, in order, by the edit thread;
///   - the samples of the haptic loop, by the saver's own ring, whether the session was told them
///     or not. Those that come after the last told event are the *overhang*. It grows while the
///     edit thread hangs, and ink in it is as good as told.
/// A stretch of chunks begins when the pen touches the sheet and ends with the edit that came of
/// it, or when nothing came of it. No clock, thread or file; one thread.
class LiveInk {
 public:
  static constexpr std::size_t kAirSamples = 64;  ///< enough for velocity and contact to settle
  static constexpr std::int64_t kNothingCameNs = 200'000'000;  ///< in the air since
  /// Largest stretch: ten minutes without a lift. What comes after it is not kept.
  static constexpr std::size_t kMostBytes = std::size_t{64} << 20;

  /// Another session: everything is forgotten but the device.
  void begin();
  /// An event that says what the next gesture depends on.
  void context(const Event& event);
  void selection(Selection selection) { selection_ = std::move(selection); }
  /// The session took this; whether a gesture was in work just before.
  void told(const Event& event, bool gesture_in_work);
  /// The document took an edit: what was in work is in it.
  void edit();
  /// The loop handed this over; its time is the session's.
  void sample(const PenSample& sample);

  /// What became of the stretch since the last call: whether the chunks that the store has are void
  /// now, and what is to be added.
  struct Changes {
    bool clear = false;
    std::vector<LiveChunk> chunks;
  };
  Changes take();
  /// All of the stretch that was taken, for another store.
  [[nodiscard]] const std::vector<LiveChunk>& chunks() const noexcept { return chunks_; }
  /// Of the newest sample that was taken before it was told; INT64_MIN where there is none.
  [[nodiscard]] std::int64_t kept_ns() const noexcept { return kept_ns_; }

 private:
  void open();
  void close();
  [[nodiscard]] bool is_chosen(std::string_view key) const;
  void keep(Changes& changes, LiveKind kind, std::string bytes);
  bool overhang_touches();

  std::map<std::string, OptionValue> options_;
  std::optional<UseDevice> device_;
  std::map<std::string, std::string> materials_;  // texts by "sheet my-paper"
  std::string tool_;
  LayerId layer_;
  Selection selection_;
  std::deque<Event> air_;         // the last told samples above the sheet
  std::deque<PenSample> untold_;  // the overhang
  std::int64_t told_ns_ = INT64_MIN, last_contact_ns_ = INT64_MIN, kept_ns_ = INT64_MIN;
  Contact contact_;  // after the last told sample
  bool open_ = false, clear_ = false;
  std::string context_, events_;  // not taken yet
  std::vector<LiveChunk> chunks_;
  std::size_t bytes_ = 0;
};

/// What the chunks of a stretch say, read back.
struct LiveStretch {
  Selection selection;
  std::string script;               ///< events as lines
  std::vector<PenSample> overhang;  ///< in order; some may be in the script, too
};

/// Adds a chunk. Error: its bytes are damaged.
Result<void> read_live_chunk(LiveKind kind, std::string_view bytes, LiveStretch& stretch);

}  // namespace felt
