#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/autosave/autosave_database.h"
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

/// The part of a drawing that is not an edit yet, as chunks of an AutosaveDatabase: the gesture in
/// progress, and all state besides the document that its ink depends on. The chunks are made from
/// two sources:
///   - the events that the session accepted, in order, from the edit thread;
///   - the samples of the haptic loop, from the autosave's own ring, even if the session has not
///     received them yet. The samples after the session's last sample are the *overhang*. It grows
///     while the edit thread hangs. Recovery draws the ink of these samples, too.
/// The chunks of one gesture are a *stretch*. It begins when the pen touches the surface. It ends
/// with the edit of the gesture, or when it is clear that the gesture makes no edit (kNoEditNs).
/// Touches in an open ring (UseRing) draw nothing, so they are not saved.
/// Uses no clock, thread or file. Not thread-safe.
class LiveInk {
 public:
  /// Maximum number of hover samples that a stretch contains before the contact. They are enough
  /// for the velocity filter and the contact detection to settle.
  static constexpr std::size_t kHoverSamples = 64;
  /// If a gesture makes no edit, its stretch ends after the pen was out of contact for this time.
  static constexpr std::int64_t kNoEditNs = 200'000'000;
  /// Maximum size of a stretch in bytes, which corresponds to ten minutes without a lift. Events
  /// and samples beyond this size are not saved.
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

  /// Prepares for a new session: discards everything except the device.
  void clear();
  /// Adds an event that sets state on which the next gesture depends: option, tool, device,
  /// material or layer.
  void add_context(const Event& event);
  void set_selection(Selection selection) { selection_ = std::move(selection); }
  /// Adds an event that the session accepted. If it is a pen sample, `gesture_in_progress` says
  /// whether a gesture was in progress before the sample.
  void event_applied(const Event& event, bool gesture_in_progress);
  /// Ends the stretch, because the document has applied an edit that contains the gesture. The
  /// hover samples remain for the next stretch if the edit adds no ink, but for example a layer.
  void edit_applied(const Edit& edit);
  /// Adds a sample of the haptic loop. The sample's time must be on the session's clock.
  void add_loop_sample(const PenSample& sample);

  /// Changes of the stretch since the last take_changes(). To apply them, first delete all chunks
  /// in the database if `clear` is true, then add `chunks`.
  struct Changes {
    bool clear = false;
    std::vector<LiveChunk> chunks;
  };
  Changes take_changes();
  /// Returns the whole stretch up to the last take_changes(), for a new database.
  [[nodiscard]] const std::vector<LiveChunk>& chunks() const noexcept { return chunks_; }
  /// Returns the time of the newest sample of the overhang in chunks(), or INT64_MIN if chunks()
  /// has no such sample.
  [[nodiscard]] std::int64_t kept_ns() const noexcept { return kept_ns_; }

 private:
  /// Finds the samples that are for a ring: all while it is open, and the rest of a contact that
  /// began in it, also across a bounce.
  class RingTouch {
   public:
    bool holds(bool ring_is_open, const PenSample& sample) noexcept;

   private:
    Contact contact_;
    bool is_held_ = false;
  };

  void open();
  void close();
  [[nodiscard]] bool is_chosen(std::string_view key) const;
  void keep(Changes& changes, LiveKind kind, std::string bytes);
  bool overhang_touches();
  void follow_ring(const Event& event, bool gesture_in_progress);

  std::map<std::string, OptionValue> options_;
  std::optional<UseDevice> device_;
  std::map<std::string, std::string> materials_;  // texts by "surface my-paper"
  std::string tool_;
  LayerId layer_;
  UseView view_;
  Selection selection_;
  std::deque<Event> hover_;         // the last hover samples that the session received
  std::deque<PenSample> overhang_;  // may begin with hover samples
  std::int64_t session_ns_ = INT64_MIN, last_contact_ns_ = INT64_MIN, kept_ns_ = INT64_MIN;
  Contact contact_;         // contact state after the session's last sample
  bool has_ended_ = false;  // the gesture of this contact has ended, although the pen is still down
  bool ring_is_open_ = false;
  RingTouch events_ring_, loop_ring_;  // of the samples of either source
  bool open_ = false, clear_ = false;
  std::string context_, events_;  // not in chunks_ yet
  std::vector<LiveChunk> chunks_;
  std::size_t bytes_ = 0;
};

/// The content of the chunks of a stretch.
struct LiveStretch {
  Selection selection;
  std::string script;               ///< events as lines
  std::vector<PenSample> overhang;  ///< in order; `script` may also contain some of these samples
};

/// Adds a chunk to `stretch`. Fails if its bytes are damaged.
Result<void> read_live_chunk(LiveKind kind, std::string_view bytes, LiveStretch& stretch);

}  // namespace felt
