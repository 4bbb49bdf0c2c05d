#include "tests/drawing/materials/materials_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/drawing/materials/blind_check.h"
#include "tests/drawing/materials/pair_figures.h"

namespace felt {
namespace {

constexpr const char* kIntroduction = R"(# Materials

The properties of surfaces and media, how they feel, and which of them can be distinguished. Written by
`./dev bench materials`, in virtual time with the simulated hand: the same figures on every run. No
human hand and no real surface was measured: frictions, stiffnesses and reliefs are estimates
([share/materials](../share/materials) says which), and the devices are
[simulated](../src/felt/devices/simulated/README.md).

The tables hold for the full friction. The option `pencil.strength` has the default 0.6
([why](design/simulation.md#what-the-default-forces-were-chosen-by)), which takes a share of the friction. The relief keeps its
force from 0.5 on: with the defaults, the pencil feels rough-paper, watercolour, canvas, blackboard and wood on every device at 50
and 100 mm/s (a test checks it). What a device rubs by itself is not rendered again ([rule](design/forces.md#friction)).

Each surface has one relief, made from a seed. The ink shows it and the hand feels it (R47).

![every surface with five dry media at three forces](images/surfaces.png)

)";

constexpr const char* kFigures = R"(
## Every medium on every surface
On every simulated device with motors (worst, touch, touch-x, premium, falcon, omega, inverse3), at
1 kHz and at 5 kHz. Each entry: the peak force of the texture itself, N, at 50, 100 and 150 mm/s.
It is measured along the surface, at wavelengths from 0.8 to 9 mm: a stroke pressed with 0.8 N, minus
the same stroke on the same surface made smooth, along x or along y, whichever is more; of all
devices and rates the **weakest**. **Bold** is 0.04 N or more, what can just be felt, hence felt
everywhere; with a `+` it is felt on some of them; the rest is there and too weak. `mu` is the
friction of the pair.

)";

constexpr const char* kLoops = R"(
The other figures of these pairs (R48, R56), the worst of all of them on each device and rate:

1. the largest share of the stiffness that the device bears along an axis which is in use: the
   surface, or the friction's bristle and what the texture adds; at most 100 %;
2. the stiffest place of any texture, of what the loop bears ([design](design/forces.md#texture));
3. the force above 30 Hz that a resting pen feels, N, of the worst of four hands; below 0.04 N.

)";

constexpr const char* kFelt = R"(
Felt on every device at every of these speeds (`ctest -L materials` holds it):

)";

constexpr const char* kBlind = R"(
## Told apart blindly
The same strokes are drawn with every choice, 40 mm along x and 40 mm along y, at 50 to 150 mm/s, with
0.5 to 0.8 N and a trembling typical hand. From the forces and the friction of the device alone six features are taken: friction,
hardness, and how strong and how coarse the texture is in each of the two directions, each with the
error that a sense makes: 10 % of a force, 22 % of a stiffness, 20 % of the strength and 25 % of the
wavelength of a texture, of which nothing is felt far below 0.04 N. The nearest centroid decides. 40
strokes of each choice to learn from, 60 others to be judged, one by one; numbers are strokes. Two are
called distinct where, with only these two to choose from, at least 90 % of the strokes are put right.

)";

std::string number(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string percent(double share) {
  return number(100.0 * share, 0) + " %";
}

std::string surfaces() {
  std::string out =
      "| surface | stiffness N/m | damping N s/m | friction (pencil) | relief rms um "
      "| wavelength mm |\n|---|---|---|---|---|---|\n";
  for (const SurfaceMaterial& s : surface_materials()) {
    out += "| " + std::string(s.id) + " | " + number(s.stiffness_n_per_m, 0) + " | " +
           number(s.damping_n_s_per_m, 1) + " | " + number(s.friction, 2) + " | ";
    out += s.grain_um > 0.0 ? number(s.grain_um, 1) + " | " + number(s.grain_mm, 1) + " |\n"
                            : "smooth | |\n";
  }
  return out;
}

std::string media_table() {
  std::string out =
      "| medium | friction (paper) | bristle N/m | grain felt through it | worn by a firm push | "
      "frictions of its own |\n|---|---|---|---|---|---|\n";
  for (const Medium& m : media()) {
    out += "| " + m.id + " | " + number(m.friction, 3) + " | " + number(m.bristle_n_per_m, 0) +
           " | " + percent(m.grain) + " | " + percent(m.wear) + " | ";
    for (const PairFriction& pair : m.pairs) {
      out +=
          (&pair == m.pairs.data() ? "" : ", ") + pair.surface + " " + number(pair.coefficient, 2);
    }
    out += " |\n";
  }
  return out;
}

// Extreme values of a pair over all devices and loop rates.
struct Worst {
  std::array<double, kBandSpeeds.size()> min_n{}, max_n{};
  bool has_texture = false;
};

void add(Worst& worst, const PairFigures& figures, bool is_first) {
  worst.has_texture = figures.texture_n_per_m > 0.0;
  for (std::size_t i = 0; i < kBandSpeeds.size(); ++i) {
    const double band = figures.band_n[i];
    worst.min_n[i] = is_first ? band : std::min(worst.min_n[i], band);
    worst.max_n[i] = std::max(worst.max_n[i], band);
  }
}

bool is_felt(const Worst& worst) {
  return std::all_of(worst.min_n.begin(), worst.min_n.end(),
                     [](double n) { return n >= kFeltForceN; });
}

std::string entry(const Worst& worst, double mu) {
  std::string out = "mu " + number(mu, 2);
  if (!worst.has_texture) return out;
  out += ';';
  for (std::size_t i = 0; i < kBandSpeeds.size(); ++i) {
    // Rounds down, so that a figure below the bound is not printed as the bound.
    const std::string text = number(std::floor(100.0 * worst.min_n[i]) / 100.0, 2);
    if (worst.min_n[i] >= kFeltForceN) {
      out += " **" + text + "**";
    } else {
      out += " " + text + (worst.max_n[i] >= kFeltForceN ? "+" : "");
    }
  }
  return out;
}

std::string row_of(const DeviceLoop& loop, const std::vector<PairFigures>& all) {
  double budget = 0.0, texture = 0.0, rest = 0.0;
  bool is_sound = true;
  for (const PairFigures& f : all) {
    budget = std::max(budget, f.budget_share);
    texture = std::max(texture, f.texture_n_per_m / f.texture_limit_n_per_m);
    rest = std::max(rest, f.rest_n);
    is_sound = is_sound && f.is_sound;
  }
  return "| " + name_of(loop) + " | " + percent(budget) + " | " + percent(texture) + " | " +
         number(rest, 3) + (is_sound ? "" : ", fault") + " |\n";
}

std::string pairs() {
  const std::size_t columns = media().size();
  std::vector<Worst> worst(surface_materials().size() * columns);
  std::string loops = "| device | stiffness | texture | rest N |\n|---|---|---|---|\n";
  bool is_first = true;
  for (const DeviceLoop& loop : device_loops()) {
    std::vector<PairFigures> all;
    for (const SurfaceMaterial& surface : surface_materials()) {
      for (const PairFigures& f : measured_figures(loop, surface)) all.push_back(f);
    }
    for (std::size_t i = 0; i < all.size(); ++i) add(worst[i], all[i], is_first);
    is_first = false;
    loops += row_of(loop, all);
  }
  std::string table = "| surface |", rule = "\n|---|", felt;
  for (const Medium& tool : media()) {
    table += " " + tool.id + " |";
    rule += "---|";
  }
  table += rule + "\n";
  for (std::size_t row = 0; row < surface_materials().size(); ++row) {
    const SurfaceMaterial& surface = surface_materials()[row];
    table += "| " + surface.id + " |";
    for (std::size_t column = 0; column < columns; ++column) {
      const Worst& of = worst[row * columns + column];
      table += " " + entry(of, friction_of(media()[column], surface)) + " |";
      if (of.has_texture && is_felt(of)) felt += name_of_pair(media()[column], surface) + "\n";
    }
    table += "\n";
  }
  return table + kFelt + "```felt\n" + felt + "```\n" + kLoops + loops;
}

std::string blindly(const std::vector<BlindCheck>& checks) {
  std::string out;
  std::vector<std::string> alike;
  for (const BlindCheck& check : checks) {
    const Confusion confusion = run_blind_check(check);
    out += "#### " + check.name + ", " + std::to_string(1'000'000 / check.period_ns) +
           " kHz: " + percent(confusion.accuracy()) + " right, " +
           std::to_string(confusion.distinct_pairs()) + " of " + std::to_string(confusion.pairs()) +
           " pairs distinct\n" + confusion.text() + "\n";
    for (const std::string& pair : alike_pairs(check, confusion)) alike.push_back(pair);
  }
  out += "Not distinct; all other pairs are (`ctest -L materials` holds both):\n\n```alike\n";
  for (const std::string& pair : alike) out += pair + "\n";
  return out + "```\n";
}

}  // namespace

std::string materials_report() {
  return kIntroduction + surfaces() + "\n" + media_table() + kFigures + pairs() + kBlind +
         "### Surfaces, under the pencil\n" + blindly(blind_checks_of_surfaces()) +
         "\n### Media, on " + std::string(kMediaSurface) + "\n" + blindly(blind_checks_of_media());
}

}  // namespace felt
