#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/session/session.h"
#include "felt/tools/contact.h"
#include "tests/drawing/gestures/checks.h"
#include "tests/drawing/gestures/dice.h"

namespace felt::gestures {

/// What gestures with one tool came to.
struct ToolTotals {
  std::uint64_t gestures = 0, edits = 0, previews = 0, selections = 0;
  double largest_n = 0.0;  ///< beside the sheet's forces
};

struct Totals {
  std::map<std::string, ToolTotals, std::less<>> tools;
  std::uint64_t samples = 0, undone = 0;
  std::uint64_t digest = 0xcbf29ce484222325ULL;  ///< of every document at its end
};

struct EpisodeOptions {
  std::uint64_t seed = 1;
  int gestures = 20;
  std::string tool;  ///< most gestures are made with this one; "" is any
  bool trace = false;
};

/// One drawing session from a random drawing on: random gestures with all tools and options, with
/// undo, redo, cancel and changes of tool in the middle. After each step the rules of checks.h, and
/// those of history: a gesture is one step at most and changes something, a cancelled one left
/// nothing, and at the end undo leads back to the first byte and redo forth to the last (R52).
class Episode {
 public:
  Episode(const EpisodeOptions& options, const std::vector<Stroke>& real, Totals& totals);

  /// The rule that broke, or nothing.
  Broken run();
  /// What was being done: "pull, gesture 7 (along), pull.radius_mm = 20".
  [[nodiscard]] const std::string& where() const noexcept { return where_; }
  [[nodiscard]] std::string_view tool() const noexcept { return session_.tool().info().id; }

 private:
  SessionOptions session_options(const std::vector<Stroke>& real);
  ToolTotals& tool_totals();
  void see_edit(const Edit& edit);
  void break_rule(Broken broken);
  template <class What>
  void apply(const What& what);
  /// Likewise for what is no tool's doing.
  template <class What>
  void command(const What& what);
  void take(const PenSample& sample);
  void check_state(const PenSample& sample);

  void one_gesture(int number);
  void choose_tool();
  void choose_options();
  void choose_option(std::string_view owner, const OptionSpec& spec);
  void between_gestures();
  void interfere();
  void undo_and_redo();
  void cancel();
  void import();
  void select_or_delete();
  void change_layers();
  void back_and_forth();

  EpisodeOptions options_;
  Totals& totals_;
  Dice dice_;
  ForceProbe probe_;
  std::uint64_t edits_ = 0;
  bool is_command_ = false;  // the next edits are those of undo, redo, layers: no tool's
  Broken broken_;
  std::string where_;
  std::int64_t now_ns_ = 0;
  Contact contact_;
  bool pen_is_up_ = true;
  std::uint64_t touches_ = 0, commits_ = 0;
  std::size_t samples_in_gesture_ = 0;
  VelocityFilter velocity_;
  std::int64_t velocity_ns_ = 0;
  Selection last_selection_;
  Overlay overlay_;
  Document last_;  // before the next edit
  Document start_;
  Session session_;
};

/// All of a document as bytes: layers, and strokes as a file has them.
std::string bytes_of(const Document& document);

}  // namespace felt::gestures
