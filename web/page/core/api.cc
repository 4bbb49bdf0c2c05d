// The functions that core.js calls. Texts and bytes from JavaScript are written to the buffer that
// felt_input() returns; those for JavaScript are in the reply: the functions return its size, and
// felt_reply() its place.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "web/page/core/api_state.h"

#define FELT_EXPORT(name) extern "C" __attribute__((export_name(#name), used))

/// The time in ms, for the budget of paint().
extern "C" __attribute__((import_module("env"), import_name("now_ms"))) double now_ms();

namespace felt::page {

Core& core() {
  static Core* const made = new Core;  // lives as long as the module
  return *made;
}

namespace {

constexpr std::size_t kSampleNumbers = 8;

std::size_t reply(std::string text) {
  core().reply = std::move(text);
  return core().reply.size();
}
std::size_t reply(const Result<void>& done, const std::vector<std::string>& notices = {}) {
  return reply(done_text(done, notices));
}
std::string_view input(std::size_t size) {
  return {core().input.data(), size};
}

std::int64_t ns_of(double ms) {
  return static_cast<std::int64_t>(std::clamp(std::round(ms * 1e6), -9e15, 9e15));
}
std::optional<double> known(double number) {
  return std::isnan(number) ? std::nullopt : std::optional(number);
}

}  // namespace

FELT_EXPORT(felt_input) char* felt_input(std::size_t size) {
  std::vector<char>& input = core().input;
  constexpr std::size_t kKept = std::size_t{1} << 20;
  if (input.capacity() > kKept && size < kKept) input = {};
  input.resize(size + 1);
  return input.data();
}
FELT_EXPORT(felt_reply) const char* felt_reply() {
  return core().reply.data();
}

// --- Input

FELT_EXPORT(felt_samples) void felt_samples(std::size_t count) {
  std::vector<double> numbers(count * kSampleNumbers);
  std::memcpy(numbers.data(), core().input.data(), numbers.size() * sizeof(double));
  for (std::size_t i = 0; i < count; ++i) {
    const double* n = numbers.data() + i * kSampleNumbers;
    PointerSample sample;
    sample.time_ns = ns_of(n[0]);
    sample.position = core().to_page({n[1], n[2]});
    sample.touching = n[3] != 0.0;
    sample.pressure = known(n[4]);
    if (known(n[5]) && known(n[6])) sample.tilt_deg = tilt_of_xy(n[5], n[6]);
    sample.buttons = static_cast<std::uint32_t>(n[7]) & 3U;
    core().studio.point(sample);
  }
  core().shows = true;
}

FELT_EXPORT(felt_event) std::size_t felt_event(std::size_t size) {
  return reply(core().event(input(size)));
}
FELT_EXPORT(felt_set_medium) std::size_t felt_set_medium(std::size_t size) {
  return reply(core().set_medium(std::string(input(size))));
}
FELT_EXPORT(felt_set_size) std::size_t felt_set_size(double mm) {
  return reply(core().set_size(mm));
}
FELT_EXPORT(felt_advance) void felt_advance(double ms) {
  core().advance(ns_of(ms));
}
FELT_EXPORT(felt_finish) void felt_finish() {
  core().studio.finish();
  core().shows = true;
}
FELT_EXPORT(felt_changes) unsigned felt_changes() {
  return core().changes();
}
FELT_EXPORT(felt_ticks) double felt_ticks() {
  return static_cast<double>(core().studio.session().guide_ticks());
}

// --- The picture

FELT_EXPORT(felt_resize) void felt_resize(double width, double height, double dpr) {
  core().resize(width, height, dpr);
}
FELT_EXPORT(felt_set_view)
void felt_set_view(double x, double y, double scale, double angle_deg, int mirrored) {
  core().set_view(x, y, scale, angle_deg, mirrored != 0);
}
FELT_EXPORT(felt_set_desk) void felt_set_desk(unsigned rgb) {
  core().desk = {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U),
                 static_cast<std::uint8_t>(rgb), 255};
  core().set_ground();
}
FELT_EXPORT(felt_set_paper) void felt_set_paper(int is_set, unsigned rgb) {
  core().set_paper(is_set != 0, rgb);
}
FELT_EXPORT(felt_set_page) void felt_set_page(double width, double height) {
  Page page = core().studio.page();
  page.width_mm = std::clamp(width, Page::kMinMm, Page::kMaxMm);
  page.height_mm = std::clamp(height, Page::kMinMm, Page::kMaxMm);
  core().studio.set_page(page);
  core().wants_rebase();
  core().set_ground();
}
FELT_EXPORT(felt_set_grain) void felt_set_grain(int on) {
  core().wants_grain = on != 0;
  core().update_grain();
}
FELT_EXPORT(felt_warm_up) void felt_warm_up() {
  core().warm_up();
}
FELT_EXPORT(felt_paint) int felt_paint(double budget_ms) {
  core().show();
  const double end = now_ms() + budget_ms;
  return core().picture.paint([end] { return now_ms() > end; }) ? 1 : 0;
}
FELT_EXPORT(felt_pixels) const std::uint8_t* felt_pixels() {
  return core().picture.pixels().data;
}
/// Side 0..3 of the painted rectangle: x0, y0, x1, y1.
FELT_EXPORT(felt_painted) int felt_painted(int side) {
  const PixelRect r = core().picture.painted();
  return std::array{r.x0, r.y0, r.x1, r.y1}[static_cast<std::size_t>(side & 3)];
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
FELT_EXPORT(felt_marks) std::size_t felt_marks() {
  core().show();
  return reply(marks_text(core().marks, core().picture.view(), core().dpr));
}
FELT_EXPORT(felt_pen) std::size_t felt_pen() {
  return reply(pen_text(core().studio, core().picture, core().dpr));
}

// --- Forces and sound

FELT_EXPORT(felt_devices) std::size_t felt_devices() {
  return reply(devices_text());
}
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
FELT_EXPORT(felt_state) std::size_t felt_state() {
  return reply(state_text(core().studio));
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
/// adds.
FELT_EXPORT(felt_open) std::size_t felt_open(std::size_t size, std::size_t name_size, int how) {
  const std::string all(input(size));
  std::vector<std::string> notices;
  const std::string name = all.substr(0, name_size);
  const std::string_view bytes = std::string_view(all).substr(name_size);
  const Result<void> done = core().open(bytes, name, how == 1, notices);
  return reply(done, notices);
}
FELT_EXPORT(felt_save) std::size_t felt_save(std::size_t size) {
  Result<std::string> bytes = core().save(input(size));
  return reply(bytes ? *std::move(bytes) : std::string());
}
FELT_EXPORT(felt_clear) void felt_clear() {
  core().clear();
}
/// Prepares what felt_base() and felt_recorded() return. Returns 1 if it replaces what was stored.
FELT_EXPORT(felt_autosave) int felt_autosave() {
  return core().autosave() ? 1 : 0;
}
FELT_EXPORT(felt_base) std::size_t felt_base() {
  return reply(core().base);
}
FELT_EXPORT(felt_recorded) std::size_t felt_recorded() {
  return reply(std::exchange(core().recorded, {}));
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
