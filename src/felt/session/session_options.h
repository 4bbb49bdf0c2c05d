#pragma once

#include <cstddef>
#include <functional>

#include "felt/document/history.h"
#include "felt/material/materials.h"
#include "felt/session/event.h"

namespace felt {

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
