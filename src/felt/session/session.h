#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/document/history.h"
#include "felt/haptics/pen_sample.h"
#include "felt/session/event.h"
#include "felt/session/session_options.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/tool.h"

namespace felt {

class ChoiceRing;
class DocumentMap;
class EdgeRidges;
class StrokeGuide;
struct ExactOffer;

/// A drawing session: document, history, tools and settings, as a deterministic function of its
/// events (docs/design/loop.md#determinism). The program, replay and tests all use this class:
///
///   Session session(make_tools(), options);
///   session.sample(s);                    // every sample of the device, hover samples too
///   session.apply({t, SetOption{"pencil.snap", "both"}});
///   servo.publish(session.force());       // every few ms
///
/// A *gesture* begins with the sample that touches the surface. It ends when the tool has returned
/// its result (usually when the pen is lifted) and the gesture's preview is no longer shown. The
/// preview of a hovering pen is not a gesture. During a gesture:
///   choose                         chooses one of the meanings that it offers
///   tool, import, device, finish   end it as if the pen had been lifted, so that no ink is lost
///   cancel                         discards it
///   undo                           discards it, and undoes nothing else
///   redo, as-drawn, exact, select, delete, duplicate, move, order, restyle, layer,
///   picture, guides, ring, timing, body, view          have no effect
/// After a tool is chosen or a gesture is cancelled, the pen must be lifted before it can begin
/// another gesture.
///
/// A finished stroke may *offer* other meanings (Offer). The choice that applies is one undo step,
/// or none if it changes nothing. The offer ends with a choice, with the next touch, with any other
/// change of the document, and with tool, device, finish and cancel.
///
/// New ink goes to the *current layer*. It is *open*, that is, visible and unlocked, as long as any
/// layer is: if it is hidden, locked or removed, the highest open layer becomes current. If no
/// layer is open, a touch that adds ink first adds a layer on top, and so does an import; both are
/// one undo step with the ink. The *selection* is updated by every edit; strokes in hidden or
/// locked layers are deselected. Undo does not restore the current layer or the selection.
///
/// Samples with a coordinate that is not finite or exceeds 1e9 mm are dropped. Pressures are
/// clamped to 0..1 and tilts to 0..90 degrees (NaN counts as unknown). Velocities are computed from
/// positions and times, whatever the device reports, because a recording does not contain
/// velocities and must give the same session.
///
/// Use it on the edit thread only. It does not use clocks, threads or files.
class Session {
 public:
  /// Starts with the first tool that draws, or else with the first tool. Requires a tool.
  Session(std::vector<std::unique_ptr<Tool>> tools, SessionOptions options);
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// Handles an event. Fails if the tool, option, layer or medium does not exist; if the option
  /// does not accept the value, or the layer cannot be used; for a HandEvent, which is for the
  /// Player; for an ImportEvent, because the caller must read its file for import(); or if
  /// read_material refuses the text of a material, or check_guide, guide_edit, timing_edit or
  /// body_edit_edit an event. After a failure nothing has changed, and the event is not recorded.
  Result<void> apply(const Event& event);
  /// Handles one pen sample. Fails if a tool returns an invalid edit (a bug). Also fails with
  /// kLimitExceeded, unlike a PenEvent, once for each gesture in refusals().
  Result<void> sample(const PenSample& reported);
  /// Handles an ImportEvent: adds the strokes of its file on top of the current layer, as one undo
  /// step. The pieces of the fills name the strokes by their numbers, from 1 (VisibleInk).
  Result<void> import(std::int64_t time_ns, const ImportEvent& event,
                      std::span<const StrokePtr> strokes, std::span<const FillPtr> fills = {});
  /// Ends the gesture as if the pen had been lifted. Call it when the sample stream stops: the
  /// device was disconnected, or the script or program ends.
  Result<void> finish();

  /// Returns the force model to publish.
  [[nodiscard]] ForceModel force() const;
  /// Replaces the content of `overlay` with everything to show besides the document.
  void draw(Overlay& overlay) const;
  /// Adds the spring that shows how a guide of the drawing pulls the pen. draw() does so, too, if
  /// the device has no force; a program whose user does not feel the force of the device calls
  /// this.
  void draw_guide_spring(Overlay& overlay) const;
  /// Returns the preview, if there is one: an edit that the display shows as if it were applied to
  /// the document. It is the result so far of the gesture in progress, or the result of a gesture
  /// that would begin at the position of the pen.
  [[nodiscard]] const std::optional<Edit>& preview() const noexcept { return preview_; }
  /// Returns preview() with the mirror images and the fills that follow it. This may take longer
  /// than a sample does, so it is meant for displays, once per frame.
  [[nodiscard]] const std::optional<Edit>& preview_with_fills() const;

  /// Returns what the gesture in progress or the last stroke offers, or nullopt.
  [[nodiscard]] std::optional<OfferView> offered() const;

  [[nodiscard]] const Document& document() const noexcept { return document_; }
  /// Returns the document as tools see it: the layers that are out of view (UseView) are hidden.
  [[nodiscard]] const Document& seen() const noexcept { return seen_ ? *seen_ : document_; }
  /// Returns the layers that are out of view, ascending.
  [[nodiscard]] const std::vector<LayerId>& out_of_view() const noexcept { return out_of_view_; }
  /// Returns an edit of the document as the edit of seen() that it means.
  [[nodiscard]] Edit seen_edit(Edit edit) const;
  [[nodiscard]] const Selection& selection() const noexcept { return selection_; }
  /// Returns the current device.
  [[nodiscard]] const Capabilities& device() const noexcept { return options_.device; }
  /// Returns the current layer. It is hidden or locked only if all layers are.
  [[nodiscard]] LayerId layer() const noexcept { return layer_; }
  /// Returns the number of layers that were added because ink needed one.
  [[nodiscard]] std::uint64_t layers_added_for_ink() const noexcept { return ink_layers_; }
  [[nodiscard]] const History& history() const noexcept { return history_; }
  /// Returns the known surfaces and media. A UseMaterial may invalidate references to them.
  [[nodiscard]] const Materials& materials() const noexcept { return options_.materials; }
  [[nodiscard]] const SurfaceMaterial& surface() const noexcept;
  /// Returns the symmetry whose mirror images new ink gets: the newest visible guide of this kind;
  /// null if there is none.
  [[nodiscard]] const DrawingGuide* symmetry() const noexcept;
  /// Returns the path along which the pencil guides the pen (UseGuide), or null.
  [[nodiscard]] const GuideLine* guide() const noexcept;
  /// Returns the line that holds the pen because it is drawn over (Retrace), or nullopt.
  [[nodiscard]] std::optional<StrokeId> retraced() const noexcept;
  /// Returns the open ring, with what the pen chooses in it, or null (UseRing).
  [[nodiscard]] const ChoiceRing* ring() const noexcept { return ring_.get(); }
  /// Returns the edges that are felt (UseEdges).
  [[nodiscard]] const UseEdges& edges() const noexcept { return edges_; }
  /// Returns the line or arc that the last stroke would become by an ExactEvent, or null. It is
  /// offered from the end of a stroke that kept to a guide of the drawing until the next touch or
  /// until the stroke changes; draw() shows it.
  [[nodiscard]] StrokePtr exact_offer() const;
  /// Returns true if the event `as-drawn` would replace the last line.
  [[nodiscard]] bool can_show_as_drawn() const;
  /// Returns a count of events of guides of the drawing that should be felt as a tick.
  [[nodiscard]] std::uint64_t guide_ticks() const noexcept;
  /// Returns the colour of new ink (option "ink.color").
  [[nodiscard]] Rgba ink_color() const noexcept;
  [[nodiscard]] std::span<const std::unique_ptr<Tool>> tools() const noexcept { return tools_; }
  [[nodiscard]] const Tool& tool() const noexcept { return *tools_[active_]; }
  /// Returns the first tool of this kind, or null.
  [[nodiscard]] const Tool* first_tool(ToolKind kind) const noexcept;
  [[nodiscard]] bool gesture_in_progress() const noexcept {
    return gesture_is_open_ || preview_is_of_gesture_;
  }
  /// Returns the ids of all options: "TOOL.OPTION", "surface.OPTION" and "ink.color".
  [[nodiscard]] std::vector<std::string> option_ids() const;
  /// Returns the present id of an option that was renamed, for example "surface.material" for
  /// "sheet.material". Returns any other id unchanged.
  [[nodiscard]] std::string current_option_id(std::string_view id) const;
  /// Returns the value of an option, by its current or a former id. Fails if the option does not
  /// exist.
  [[nodiscard]] Result<OptionValue> option(std::string_view id) const;
  /// Returns the number of edits applied to the document, including those of undo and redo.
  [[nodiscard]] std::uint64_t edit_count() const noexcept { return edits_; }
  /// Returns a count that grows whenever the selection may have changed.
  [[nodiscard]] std::uint64_t selection_count() const noexcept { return selections_; }
  /// Returns the version (kOptionDefaults) of the defaults of those options that no event has set.
  [[nodiscard]] int option_defaults() const noexcept { return option_defaults_; }
  /// Return the gestures that changed nothing, and the number of dropped samples.
  [[nodiscard]] const Refusals& refusals() const noexcept { return refusals_; }
  [[nodiscard]] std::uint64_t dropped_samples() const noexcept { return dropped_; }

 private:
  struct Apply;
  struct Parts;

  [[nodiscard]] Scene scene() const;
  [[nodiscard]] Result<std::size_t> find_tool(std::string_view id) const;
  Result<void> select(const std::string& id);
  Result<void> set_option(std::int64_t time_ns, const std::string& id, const OptionValue& value);
  Result<void> use_defaults(int version);
  void add_first_open_layer();
  Result<void> use_material(const UseMaterial& event);
  Result<void> use_guide(const UseGuide& event);
  Result<void> use_edges(const UseEdges& event);
  Result<void> use_ring(const UseRing& event);
  Result<void> use_view(const UseView& event);
  void set_view(std::vector<LayerId> out_of_view);
  void bring_into_view(LayerId layer);
  /// If an option names a material that is not built in, records the material before the option,
  /// but each material only once.
  void report_material(std::int64_t time_ns, OpenChoice kind, const OptionValue& value);
  Result<void> undo();
  Result<void> redo();
  Result<void> show_as_drawn();
  /// Prepares for a change of the document by a command, while no gesture is in progress. If the
  /// pen is up, a tool may still hold ink back until the lift is certain; commits this ink first.
  /// If the pen is down, the gesture has already returned its result; cancels the remaining part of
  /// it.
  Result<void> settle();
  void cancel();
  Result<void> select_strokes(SelectStrokes::What what);
  Result<void> delete_selected();
  Result<void> duplicate_selected();
  Result<void> move_selected(std::int64_t time_ns, const MoveEvent& event);
  Result<void> move_connected(std::int64_t time_ns, Vec by_mm);
  Result<void> order_selected(OrderEvent::To to);
  Result<void> restyle_selected(const RestyleEvent& event);
  Result<void> change_layer(const LayerEvent& event);
  Result<void> add_picture(const AddPicture& event);
  Result<void> add_line(const AddLine& event);
  Result<void> change_guides(const GuidesEvent& event);
  Result<void> change_timing(std::int64_t time_ns, const TimingEvent& event);
  Result<void> change_body(const BodyEvent& event);
  Result<void> choose(OfferKind what);
  [[nodiscard]] bool has_offer() const noexcept { return offer_ && offer_edits_ == edits_; }
  /// Marks what the first other choice of the offer would change.
  void draw_offer(Overlay& overlay) const;
  Result<void> make_exact();
  void offer_exact(const Edit& drawn);
  void follow_guides(const PenSample& sample);
  void follow_edges(const PenSample& sample);
  /// Moves the ring's choice, and lifts the pen of the sample.
  void follow_ring(PenSample& sample);
  void draw_ring(Overlay& overlay) const;
  void keep_layer_open();
  /// Returns true if the sample begins a gesture of a tool that adds ink.
  [[nodiscard]] bool begins_ink(const PenSample& sample) const;
  /// Adds a layer if no layer is open. Fails if the drawing has too many layers.
  Result<void> open_layer_for_ink();
  void show(std::optional<Edit> preview);
  Result<void> take(ToolResult result);
  /// Completes an edit of a command and commits it.
  Result<void> commit(Edit edit);
  Result<void> apply_and_record(Edit edit);
  /// Returns true if the tool in use adds ink, which gets mirror images.
  [[nodiscard]] bool draws_ink() const noexcept;
  /// Adds what follows from an edit: the changes of linked strokes, of traces and of fills. If the
  /// edit is of the tool in use, also the mirror images of new ink.
  enum class Origin : std::uint8_t { kTool, kCommand };
  void let_others_follow(Edit& edit, Origin origin) const;
  /// Adds the changes of fills whose boundary the edit changes.
  void let_fills_follow(Edit& edit) const;
  /// Commits an edit as a part of the previous undo step, if History::extend() allows it.
  Result<void> commit_with_previous(Edit edit);
  void follow(const Edit& applied);
  /// Updates the index and the selection after an edit of seen().
  void follow_seen(const Edit& edit);
  void set_selection(Selection selection);
  void record(const Event& event) const;

  SessionOptions options_;
  std::vector<std::unique_ptr<Tool>> tools_;
  std::size_t active_ = 0;
  Document document_;
  std::unique_ptr<Document> seen_;    // null while all layers are in view
  std::vector<LayerId> out_of_view_;  // ascending
  std::unique_ptr<Parts> parts_;
  Selection selection_;
  History history_;
  LayerId layer_;
  std::uint64_t ink_layers_ = 0;
  // The position in the history after the last layer was added for ink.
  std::optional<std::uint64_t> ink_layer_step_;
  std::optional<Edit> preview_;
  mutable std::optional<Edit> shown_preview_;      // preview_with_fills()
  mutable bool shown_is_current_ = true;           // shown_preview_ belongs to preview_
  mutable std::unique_ptr<DocumentMap> fill_map_;  // of all strokes; null while there is no fill
  bool preview_is_of_gesture_ = false;
  std::int64_t last_sample_ns_ = 0;
  bool must_lift_ = false;  // the pen must be lifted before it can begin a gesture
  bool pen_is_down_ = false;
  // The pen has touched the surface, and the gesture has no result yet.
  bool gesture_is_open_ = false;
  std::optional<RecentChange> moved_;  // by the last move or timing event
  // The edit that shows the last line as drawn, and the position in the history before it.
  struct AsDrawn {
    Edit edit;
    std::uint64_t position;
  };
  std::optional<AsDrawn> as_drawn_;
  std::optional<Offer> offer_;         // of the last stroke
  std::uint64_t offer_edits_ = 0;      // edits_ when it was made; it is over if this differs
  std::vector<std::string> reported_;  // kinds and ids of recorded materials
  int option_defaults_ = kOptionDefaults;
  std::unique_ptr<StrokeGuide> stroke_guide_;
  std::unique_ptr<ChoiceRing> ring_;  // null: closed
  bool touches_ring_ = false;         // the pen touches since the ring is open
  UseEdges edges_;
  std::unique_ptr<EdgeRidges> edge_ridges_;  // null until an edge is felt
  std::unique_ptr<ExactOffer> exact_;        // null: no offer
  std::uint64_t dropped_ = 0;
  Refusals refusals_;
  std::uint64_t edits_ = 0;
  std::uint64_t selections_ = 0;
};

/// Returns a document with these strokes in one layer, in their order, for SessionOptions.
Document document_of(std::span<const StrokePtr> strokes);

}  // namespace felt
