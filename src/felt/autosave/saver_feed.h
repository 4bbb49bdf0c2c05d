#pragma once

#include <cstdint>
#include <string>

#include "felt/autosave/saver.h"
#include "felt/session/session.h"

namespace felt {

/// Tells a saver what a session does. Its calls belong into SessionOptions::on_event and on_edit,
/// and at the beginning of each session. Edit thread.
///
///   SaverFeed feed(saver);
///   feed.begin(session, drawing, "Untitled", "", false);
///   options.on_event = [&](const Event& event) { feed.hear(session, event); };
///   options.on_edit = [&](const Edit& edit) { feed.hear(session, edit); };
class SaverFeed {
 public:
  explicit SaverFeed(Saver& saver) : saver_(saver) {}

  /// This drawing is what the session has now.
  void begin(const Session& session, StoredDrawing drawing, std::string name, std::string path,
             bool modified);
  void hear(const Session& session, const Event& event);
  void hear(const Session& session, const Edit& edit);

 private:
  void tell_layer(const Session& session);
  void tell_selection(const Session& session);

  Saver& saver_;
  LayerId layer_;
  std::uint64_t selection_ = 0;
};

}  // namespace felt
