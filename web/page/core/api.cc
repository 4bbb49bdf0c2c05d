// The functions that core.js calls in both modules; api_full.cc has those of the full module alone.
// Texts and bytes from JavaScript are written to the buffer that felt_input() returns; those for
// JavaScript are in the reply: the functions return its size, and felt_reply() its place.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "web/page/core/api_reply.h"

/// The time in ms, for the budget of paint().
extern "C" __attribute__((import_module("env"), import_name("now_ms"))) double now_ms();

namespace felt::page {

Core& core() {
  static Core* const made = new Core;  // lives as long as the module
  return *made;
}

namespace {

constexpr std::size_t kSampleNumbers = 8;

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
    sample.buttons = static_cast<std::uint32_t>(n[7]) & 7U;
    core().studio.point(sample);
  }
  core().shows = true;
}

/// Undo, redo, cancel: 0, 1, 2.
FELT_EXPORT(felt_command) std::size_t felt_command(int command) {
  core().shows = true;
  if (command == 0) return reply(core().studio.apply(UndoEvent{}));
  if (command == 1) return reply(core().studio.apply(RedoEvent{}));
  return reply(core().studio.apply(CancelEvent{}));
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
/// Returns why a sample was refused, as for the functions that can fail.
FELT_EXPORT(felt_refusal) std::size_t felt_refusal() {
  return reply(core().studio.take_refusal());
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
FELT_EXPORT(felt_set_page) void felt_set_page(double width, double height) {
  Page page = core().studio.page();
  page.width_mm = std::clamp(width, Page::kMinMm, Page::kMaxMm);
  page.height_mm = std::clamp(height, Page::kMinMm, Page::kMaxMm);
  core().studio.set_page(page);
  core().wants_rebase();
  core().set_ground();
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
FELT_EXPORT(felt_marks) std::size_t felt_marks() {
  core().show();
  return reply(marks_text(core().marks, core().picture.view(), core().dpr));
}
FELT_EXPORT(felt_pen) std::size_t felt_pen() {
  return reply(pen_text(core().studio, core().picture, core().dpr));
}

// --- State

FELT_EXPORT(felt_devices) std::size_t felt_devices() {
  return reply(devices_text());
}
FELT_EXPORT(felt_state) std::size_t felt_state() {
  return reply(state_text(core().studio));
}

// --- Autosave

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

}  // namespace felt::page
