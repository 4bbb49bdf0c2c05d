#include "force_plot.h"

#include <fmt/core.h>

#include <limits>

namespace felt::cli {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr Rgba kSentColor{25, 25, 28, 255};
constexpr Rgba kAskedColor{86, 180, 233, 255};

PlotLine line(const char* name, std::size_t color, const PlotTrace& trace, double width = 1.3) {
  return {name, plot_color(color), trace, width};
}

}  // namespace

ForcePlot::ForcePlot(double period_s, const SafetyLimits& limits)
    : period_s_(period_s), limits_(limits) {}

void ForcePlot::begin(double start_s) {
  start_s_ = start_s;
  contact_ = x_ = y_ = z_ = width_ = asked_ = sent_ = new_trace();
}

PlotTrace& ForcePlot::term_trace(const std::string& name) {
  for (Term& term : terms_) {
    if (term.name == name) return term.strength;
  }
  terms_.push_back({name, new_trace()});
  for (std::size_t i = 0; i < ticks_; ++i) terms_.back().strength.add(kGap);
  return terms_.back().strength;
}

void ForcePlot::add(const TickReport& tick, std::optional<double> width_mm) {
  const PenSample& pen = tick.sample;
  if (ticks_ == 0) begin(1e-9 * static_cast<double>(pen.time_ns));
  contact_.add(in_contact(pen) ? 1.0 : 0.0);
  x_.add(pen.position.x);
  y_.add(pen.position.y);
  z_.add(pen.position.z);
  width_.add(width_mm.value_or(0.0));
  asked_.add(norm(tick.asked));
  sent_.add(norm(tick.sent));
  // A term may occur several times in a tick, or not at all. In both cases its trace gets exactly
  // one value for the tick.
  for (const ForceTerms::Term& term : tick.terms) term_trace(term.name);
  for (Term& known : terms_) {
    Force sum;
    for (const ForceTerms::Term& term : tick.terms) {
      if (known.name == term.name) sum += term.force;
    }
    known.strength.add(norm(sum));
  }
  ++ticks_;
}

void ForcePlot::set_title(std::string title, std::string note) {
  title_ = std::move(title);
  note_ = std::move(note);
}

PlotSpan ForcePlot::whole() const noexcept {
  return {start_s_, start_s_ + static_cast<double>(ticks_) * period_s_};
}

PlotPanel ForcePlot::force_panel() const {
  PlotPanel panel{"Force on the hand", "N"};
  panel.lines = {{"requested by the tool", kAskedColor, asked_, 2.4},
                 {"sent to the pen", kSentColor, sent_, 1.1}};
  panel.limits = {
      {fmt::format("peak limit, {:.3g} N", limits_.peak_force_n), limits_.peak_force_n}};
  if (limits_.continuous_force_n > 0.0 && limits_.continuous_force_n < limits_.peak_force_n) {
    panel.limits.push_back(
        {fmt::format("continuous limit (RMS), {:.3g} N", limits_.continuous_force_n),
         limits_.continuous_force_n});
  }
  panel.height = 130.0;
  panel.from_zero = true;
  return panel;
}

Result<Image> ForcePlot::draw(const PlotOptions& options) const {
  if (ticks_ == 0) return fail(ErrorCode::kInvalidData, "nothing to plot: no tick was recorded");
  Plot plot;
  plot.title = title_;
  plot.note = note_;
  plot.span = span_.value_or(whole());
  plot.shade = contact_;
  plot.shade_name = "pen on the surface";
  if (span_) {
    PlotPanel strip{"Total: force sent", "N", {{"", kSentColor, sent_, 0.8}}};
    strip.height = 40.0;
    strip.from_zero = true;
    strip.span = whole();
    plot.panels.push_back(std::move(strip));
  }
  PlotPanel position{"Position on the surface", "mm", {line("x", 0, x_), line("y", 1, y_)}};
  PlotPanel height{"Height above the surface (pressing is below 0)", "mm", {line("z", 2, z_)}};
  PlotPanel width{"Width of the ink", "mm", {line("width", 6, width_)}};
  width.from_zero = true;
  height.height = width.height = 80.0;
  PlotPanel terms{"Force terms", "N"};
  std::size_t color = 0;
  for (const Term& term : terms_)
    terms.lines.push_back(line(term.name.c_str(), color++, term.strength));
  terms.from_zero = true;
  terms.height = 130.0;
  plot.panels.insert(plot.panels.end(), {std::move(position), std::move(height), std::move(width)});
  if (!terms_.empty()) plot.panels.push_back(std::move(terms));
  plot.panels.push_back(force_panel());
  return draw_plot(plot, options);
}

}  // namespace felt::cli
