#pragma once

#include <QString>
#include <vector>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// A pen that the user has kept under a name: medium, size, colour, opacity and all other options
/// of the tool that draws.
struct Preset {
  QString name;
  std::vector<SetOption> options;

  friend bool operator==(const Preset&, const Preset&) = default;
};

/// The setting with the presets: a JSON text, [{"name": .., "options": {ID: VALUE, ..}}, ..].
inline constexpr auto kPresets = "pens/presets";
/// The largest number of presets.
inline constexpr std::size_t kMaxPresets = 100;

/// Returns the presets of the settings, in the order in which they were kept. Skips entries that
/// cannot be read.
std::vector<Preset> stored_presets();
/// Stores the present options under a name; replaces the preset of that name. Does nothing if the
/// name is blank or there are kMaxPresets others.
void keep_preset(const Session& session, const QString& name);
void remove_preset(const QString& name);

/// Sets the options of a preset, and chooses the tool that draws unless the current tool uses the
/// options, too (a shape). An option that the session refuses keeps its value, and
/// Studio::refused says why.
void use_preset(Studio& studio, const Preset& preset);

}  // namespace felt::desktop
