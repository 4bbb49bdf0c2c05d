// The functions that only the full module has. api.cc has the others.

#include <algorithm>
#include <string>
#include <vector>

#include "web/page/core/api_reply.h"

namespace felt::page {

// --- Input

FELT_EXPORT(felt_event) std::size_t felt_event(std::size_t size) {
  return reply(core().event(input(size)));
}
FELT_EXPORT(felt_set_medium) std::size_t felt_set_medium(std::size_t size) {
  return reply(core().set_medium(std::string(input(size))));
}
FELT_EXPORT(felt_set_size) std::size_t felt_set_size(double mm) {
  return reply(core().set_size(mm));
}

// --- The picture

FELT_EXPORT(felt_set_paper) void felt_set_paper(int is_set, unsigned rgb) {
  core().set_paper(is_set != 0, rgb);
}
FELT_EXPORT(felt_set_grain) void felt_set_grain(int on) {
  core().wants_grain = on != 0;
  core().update_grain();
}
/// Paints everything again, because the pixels of pictures are there now.
FELT_EXPORT(felt_repaint) void felt_repaint() {
  core().picture.open(core().studio.session().document());
  core().shows = true;
}
FELT_EXPORT(felt_warm_up) void felt_warm_up() {
  core().warm_up();
}
FELT_EXPORT(felt_export) std::size_t felt_export(double dpi, int transparent) {
  return core().export_picture(dpi, transparent != 0);
}
FELT_EXPORT(felt_export_size) int felt_export_size(int side) {
  const std::optional<Image>& image = core().exported;
  return image ? (side == 0 ? image->width() : image->height()) : 0;
}
FELT_EXPORT(felt_export_pixels) const std::uint8_t* felt_export_pixels() {
  return core().exported ? core().exported->bytes().data() : nullptr;
}
FELT_EXPORT(felt_end_export) void felt_end_export() {
  core().exported.reset();
}

// --- Forces and sound

FELT_EXPORT(felt_set_device) std::size_t felt_set_device(std::size_t size) {
  const Result<void> done = core().studio.use_device(input(size));
  core().shows = true;
  return reply(done);
}
FELT_EXPORT(felt_set_forces) void felt_set_forces(int on) {
  core().studio.set_forces(on != 0);
}
FELT_EXPORT(felt_set_strength) void felt_set_strength(double share) {
  core().studio.set_strength(share);
}
FELT_EXPORT(felt_forces) std::size_t felt_forces() {
  return core().take_forces();
}
FELT_EXPORT(felt_force_terms) std::size_t felt_force_terms() {
  return reply(terms_text(core().studio.tick(), core().picture.view()));
}
FELT_EXPORT(felt_sound) std::size_t felt_sound(std::size_t frames) {
  return core().render_sound(frames);
}

// --- State

FELT_EXPORT(felt_catalog) std::size_t felt_catalog() {
  return reply(catalog_text(core().studio.session()));
}
FELT_EXPORT(felt_option) std::size_t felt_option(std::size_t size) {
  return reply(option_text(core().studio.session(), std::string(input(size))));
}

// --- The simulated hand

FELT_EXPORT(felt_play) std::size_t felt_play(std::size_t size, double mm_per_unit, double speed) {
  const std::string script(input(size));
  core().warm_up();
  return reply(core().studio.play("script", script, mm_per_unit, speed));
}
FELT_EXPORT(felt_playing) double felt_playing() {
  return core().studio.is_playing() ? core().studio.played() : -1.0;
}
FELT_EXPORT(felt_play_error) std::size_t felt_play_error() {
  return reply(core().studio.take_play_error());
}
FELT_EXPORT(felt_stop_play) void felt_stop_play() {
  core().studio.stop_play();
}

// --- Files

/// The input is the name of the file, which has `name_size` bytes, and the file. `how`: 0 opens, 1
/// adds it moved by `x` and `y`, 2 adds it with its middle there, in mm.
FELT_EXPORT(felt_open)
std::size_t felt_open(std::size_t size, std::size_t name_size, int how, double x, double y) {
  const std::string all(input(size));
  std::vector<std::string> notices;
  const std::string name = all.substr(0, name_size);
  const std::string_view bytes = std::string_view(all).substr(name_size);
  const Result<void> done = how == 0 ? core().open(bytes, name, notices)
                                     : core().add(bytes, name, {x, y}, how == 2, notices);
  return reply(done, notices);
}
/// Returns an SVG file for the clipboard, and makes the picture for felt_export_pixels().
FELT_EXPORT(felt_copied) std::size_t felt_copied(int is_whole, double dpi) {
  return reply(core().copied(is_whole != 0, dpi).value_or(std::string()));
}
FELT_EXPORT(felt_save) std::size_t felt_save(std::size_t size) {
  std::vector<std::string> losses;
  Result<std::string> bytes = core().save(input(size), losses);
  const Result<void> done = bytes ? Result<void>() : tl::unexpected(bytes.error());
  core().saved = done_text(done, losses);
  return reply(bytes ? *std::move(bytes) : std::string());
}
/// Returns why the last felt_save() returned nothing, or what its file lacks.
FELT_EXPORT(felt_saved) std::size_t felt_saved() {
  return reply(core().saved);
}
FELT_EXPORT(felt_clear) void felt_clear() {
  core().clear();
}
FELT_EXPORT(felt_rebase) void felt_rebase() {
  core().wants_rebase();
}
/// The input is the base, which has `base_size` bytes, and the recorded events.
FELT_EXPORT(felt_restore) std::size_t felt_restore(std::size_t size, std::size_t base_size) {
  const std::string all(input(size));
  return reply(core().restore(std::string_view(all).substr(0, base_size),
                              std::string_view(all).substr(base_size)));
}
/// `how`: 1 draws a recording unchanged, 2 is without forces. The input is the id of the device and
/// the script.
FELT_EXPORT(felt_replay)
std::size_t felt_replay(std::size_t size, std::size_t device_size, int how) {
  const std::string all(input(size));
  ReplayChoice choice;
  choice.as_recorded = (how & 1) != 0;
  choice.forces = (how & 2) == 0;
  choice.device = all.substr(0, device_size);
  return reply(core().replay(std::string_view(all).substr(device_size), choice));
}

}  // namespace felt::page
