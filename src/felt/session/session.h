#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/document/history.h"
#include "felt/haptics/pen_sample.h"
#include "felt/session/event.h"
#include "felt/session/sheet_options.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/tool.h"

namespace felt {

struct SessionOptions {
  /// What will push back; no force describes mouse and tablet. UseDevice changes it.
  Capabilities device;
  /// Sheets and media that are known: those that Feltline brings, and a person's own. UseMaterial
  /// adds to them.
  Materials materials = Materials::built_in();
  /// What is there before the first event; the history starts after it.
  Document document = {};
  /// What of it is selected then; marks that do not fit count for nothing.
  Selection selection = {};
  /// Told every event that the session took, pen samples as PenEvent, in order: a Recorder.
  std::function<void(const Event&)> on_event = {};
  /// Told every edit that the document took, undo's and redo's too, in order: for autosave.
  std::function<void(const Edit&)> on_edit = {};
  std::size_t history_limit_bytes = History::kDefaultLimitBytes;
};

/// A drawing session: document, history, tools and what is chosen, as a deterministic function of
/// its events (architecture section 6). The live program, replay and tests all drive this class:
///
///   Session session(make_tools(), options);
///   session.sample(s);                    // every sample of the device, in the air too
///   session.apply({t, SetOption{"pencil.snap", "both"}});
///   servo.publish(session.force());       // every few ms
///
/// A *gesture* is in work from the sample that touches the sheet until the tool says what came of
/// it (as a rule when the pen is lifted), or while the preview that it left behind is shown. What
/// a hovering pen shows is no gesture.
///   tool chosen, import, finish    the gesture is ended as if the pen were lifted: no ink is lost
///   cancel                         it never was
///   undo                           cancels it, and does nothing else: what was seen last goes
///   redo, select, delete, duplicate, layer    do nothing
/// After a tool was chosen or a gesture cancelled, the pen must be lifted before it begins
/// anything.
///
/// New ink goes to the *layer in use*, which is always visible and unlocked: when it no longer is,
/// the highest other one is used, and where there is none the edit that takes the last one away
/// adds one. The *selection* follows every edit; strokes that come to stand in hidden or locked
/// layers are no longer selected. Neither is part of undo.
///
/// Samples that are not finite, or farther than 1e9 mm, are dropped. Velocities are
/// worked out here from places and times, whatever the device says, pressures held to 0..1 and
/// leans to 0..90 degrees (one that is not a number is none): a recording has no velocity, and must
/// give the same session.
///
/// Edit thread only; no clock, thread or file.
class Session {
 public:
  /// Starts with the first tool that draws, or the first one if none does. Requires one tool at
  /// least.
  Session(std::vector<std::unique_ptr<Tool>> tools, SessionOptions options);
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// Error: no such tool or option, or a value that it does not take; a HandEvent, which is for the
  /// Player; an ImportEvent, whose file the caller reads for import(); a material whose text
  /// read_material refuses. Nothing changes then, and
  /// the event is not recorded. Likewise for a layer that is not there or cannot be used.
  Result<void> apply(const Event& event);
  /// What a PenEvent ends in. Error: the tool made an edit that does not fit: a defect.
  Result<void> sample(const PenSample& sample);
  /// Handles an ImportEvent: adds the strokes of its file on top of the layer in use as one step.
  Result<void> import(std::int64_t time_ns, const ImportEvent& event,
                      std::span<const StrokePtr> strokes);
  /// No sample follows for now: the device is gone, the script or the program ends.
  Result<void> finish();

  /// What the hand should feel from now on.
  [[nodiscard]] ForceModel force() const;
  /// What is to be seen besides the document. Replaces the content.
  void draw(Overlay& overlay) const;
  /// The document with this edit is what is to be seen: what a gesture in work would do, or one
  /// that would begin here.
  [[nodiscard]] const std::optional<Edit>& preview() const noexcept { return preview_; }

  [[nodiscard]] const Document& document() const noexcept { return document_; }
  [[nodiscard]] const Selection& selection() const noexcept { return selection_; }
  /// What pushes back now.
  [[nodiscard]] const Capabilities& device() const noexcept { return options_.device; }
  /// The layer in use.
  [[nodiscard]] LayerId layer() const noexcept { return layer_; }
  [[nodiscard]] const History& history() const noexcept { return history_; }
  /// All that are known now. A UseMaterial may move them.
  [[nodiscard]] const Materials& materials() const noexcept { return options_.materials; }
  [[nodiscard]] const SheetOptions& sheet() const noexcept;
  [[nodiscard]] std::span<const std::unique_ptr<Tool>> tools() const noexcept { return tools_; }
  [[nodiscard]] const Tool& tool() const noexcept { return *tools_[active_]; }
  /// Returns the first tool of this kind, or null.
  [[nodiscard]] const Tool* first_tool(ToolKind kind) const noexcept;
  [[nodiscard]] bool gesture_in_work() const noexcept {
    return gesture_is_open_ || preview_is_of_gesture_;
  }
  /// By "tool.option" or "sheet.option".
  [[nodiscard]] Result<OptionValue> option(std::string_view id) const;
  /// Edits that the document took, undo's and redo's too.
  [[nodiscard]] std::uint64_t edit_count() const noexcept { return edits_; }
  /// Grows whenever the selection may have changed.
  [[nodiscard]] std::uint64_t selection_count() const noexcept { return selections_; }
  /// The version of the defaults that options without an event have (kOptionDefaults).
  [[nodiscard]] int option_defaults() const noexcept { return option_defaults_; }
  /// Samples that were dropped.
  [[nodiscard]] std::uint64_t dropped_samples() const noexcept { return dropped_; }

 private:
  struct Apply;
  struct Parts;

  [[nodiscard]] Scene scene() const;
  [[nodiscard]] Result<std::size_t> find_tool(std::string_view id) const;
  Result<void> select(const std::string& id);
  Result<void> set_option(std::int64_t time_ns, const std::string& id, const OptionValue& value);
  Result<void> use_defaults(int version);
  Result<void> use_material(const UseMaterial& event);
  /// Before an option names a material that only this program has, which is no part of a recording.
  void tell_material(std::int64_t time_ns, OpenChoice kind, const OptionValue& value);
  Result<void> undo();
  Result<void> redo();
  /// Before the document changes behind the tool's back, while no gesture is in work. With the pen
  /// up, a tool may still hold ink back until it believes in the lift: that is the last step then.
  /// With the pen down, the tool said already what came of its gesture: no more of it.
  Result<void> settle();
  void cancel();
  Result<void> select_strokes(SelectStrokes::What what);
  Result<void> delete_selected();
  Result<void> duplicate_selected();
  Result<void> restyle_selected(const RestyleEvent& event);
  Result<void> change_layer(const LayerEvent& event);
  void keep_layer_open();
  void show(std::optional<Edit> preview);
  Result<void> take(ToolResult result);
  Result<void> commit(Edit edit);
  void follow(const Edit& applied);
  void set_selection(Selection selection);
  void record(const Event& event) const;

  SessionOptions options_;
  std::vector<std::unique_ptr<Tool>> tools_;
  std::size_t active_ = 0;
  Document document_;
  std::unique_ptr<Parts> parts_;
  Selection selection_;
  History history_;
  LayerId layer_;
  std::optional<Edit> preview_;
  bool preview_is_of_gesture_ = false;
  std::int64_t last_sample_ns_ = 0;
  bool must_lift_ = false;  // what the pen does until then is no gesture of the tool in hand
  bool pen_is_down_ = false;
  bool gesture_is_open_ = false;   // touched the sheet, and nothing came of it yet
  std::vector<std::string> told_;  // kinds and ids of materials that a recording has
  int option_defaults_ = kOptionDefaults;
  std::uint64_t dropped_ = 0;
  std::uint64_t edits_ = 0;
  std::uint64_t selections_ = 0;
};

/// A document of these strokes: one layer, in their order. For SessionOptions.
Document document_of(std::span<const StrokePtr> strokes);

}  // namespace felt
