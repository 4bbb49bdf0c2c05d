#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "felt/base/result.h"
#include "felt/document/history.h"
#include "felt/material/materials.h"
#include "felt/session/event.h"

namespace felt {

/// The last move or timing event. Those in quick succession are one step of undo.
struct RecentChange {
  std::int64_t time_ns = 0;
  std::uint64_t position = 0;  ///< in the history, after it
  // Of moves with the lines that follow.
  Vec by_mm{};                                       ///< of all in quick succession
  std::optional<Selection> before = {}, after = {};  ///< the selection before the first, and now
};

/// Counts the gestures that changed nothing because the drawing would have exceeded a limit: a line
/// that would need one more layer (kMaxLayers), or a drag that would make copies (check_copies).
struct Refusals {
  std::uint64_t gestures = 0;
  std::string first{};  ///< why the first of them was refused; empty if there is none

  /// Counts a gesture. Returns the error that says why it was refused.
  tl::unexpected<Error> add(Error error) {
    if (gestures++ == 0) first = error.message;
    return tl::unexpected(std::move(error));
  }
};

/// What a session starts with, and what it reports to.
struct SessionOptions {
  /// The device that will output forces. A mouse or tablet has zero forces. UseDevice changes the
  /// device.
  Capabilities device;
  /// The known surfaces and media, built-in and user-defined. UseMaterial adds materials.
  Materials materials = Materials::built_in();
  /// The document before the first event; the undo history starts after it.
  Document document = {};
  /// The selection before the first event. Strokes whose marks do not fit the document are left
  /// out.
  Selection selection = {};
  /// Called with every event that the session accepted, in order, including pen samples as
  /// PenEvent. It may be a Recorder.
  std::function<void(const Event&)> on_event = {};
  /// Called with every edit applied to the document, in order, including those of undo and redo.
  /// The autosave uses it.
  std::function<void(const Edit&)> on_edit = {};
  std::size_t history_limit_bytes = History::kDefaultLimitBytes;
};

}  // namespace felt
