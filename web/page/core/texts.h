#pragma once

#include <string>

#include "felt/tools/overlay.h"
#include "web/page/core/picture.h"
#include "web/page/core/studio.h"

/// What the page shows, as the JSON texts that core.d.ts describes.
namespace felt::page {

/// Returns the type Catalog, without the icons.
std::string catalog_text(const Session& session);
/// Returns the type State.
std::string state_text(const Studio& studio);
/// Returns a list of the type Mark. `px` is the number of device pixels of a CSS pixel.
std::string marks_text(const Overlay& overlay, const View& view, double px);
/// Returns the type Pen.
std::string pen_text(const Studio& studio, const Picture& picture, double px);
/// Returns the result of forceTerms().
std::string terms_text(const TickReport& tick, const View& view);
/// Returns the result of devices().
std::string devices_text();
/// Returns the value of an option as JSON; "null" if it does not exist.
std::string option_text(const Session& session, const std::string& id);
/// Returns the type Done.
std::string done_text(const Result<void>& done, const std::vector<std::string>& notices = {});

}  // namespace felt::page
