#include "tests/drawing/materials/blind_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/drawing/materials/feel_features.h"

namespace felt {
namespace {

constexpr std::size_t kFeatures = FeelFeatures::kCount;

struct Known {
  std::vector<FeelFeatures> centroids;
  std::array<double, kFeatures> spread{};  // rms spread within the choices
};

// The features of each stroke with one choice, with random errors like those of human senses.
using Felt = std::vector<FeelFeatures>;

Felt feel(const BlindCheck& check, std::size_t choice, bool& is_sound) {
  Felt felt;
  for (int stroke = 0; stroke < check.learn + check.judge; ++stroke) {
    const auto seed = static_cast<std::uint32_t>(1 + stroke);
    std::mt19937 random(seed);
    const auto part = [&] { return static_cast<double>(random()) / 4294967296.0; };
    StrokePlan plan{.device = find_stylus_preset(check.device),
                    .hand = &typical_hand(),
                    .period_ns = check.period_ns,
                    .surface = check.choices[choice].surface,
                    .tool = check.choices[choice].tool,
                    .seed = seed};
    plan.speed_mm_per_s = 50.0 + 100.0 * part();
    plan.press_n = 0.5 + 0.3 * part();
    const StrokeForces forces = draw_stroke(plan);
    is_sound = is_sound && forces.is_sound;
    // Each stroke of each choice gets different random errors.
    const auto index = static_cast<std::uint32_t>(choice);
    felt.push_back(blurred(features_of(forces, plan.leg_mm), 1000 * (index + 1) + seed));
  }
  return felt;
}

Known learn(const std::vector<Felt>& felt, std::size_t count) {
  Known known;
  double strokes = 0.0;
  for (const Felt& of_choice : felt) {
    FeelFeatures mean;
    for (std::size_t f = 0; f < kFeatures; ++f) {
      for (std::size_t i = 0; i < count; ++i) mean.jnd[f] += of_choice[i].jnd[f];
      mean.jnd[f] /= static_cast<double>(count);
      for (std::size_t i = 0; i < count; ++i) {
        const double off = of_choice[i].jnd[f] - mean.jnd[f];
        known.spread[f] += off * off;
      }
    }
    known.centroids.push_back(mean);
    strokes += static_cast<double>(count);
  }
  for (double& spread : known.spread) spread = std::sqrt(spread / strokes);
  return known;
}

double distance_squared(const Known& known, std::size_t choice, const FeelFeatures& felt) {
  double sum = 0.0;
  for (std::size_t f = 0; f < kFeatures; ++f) {
    const double off = (felt.jnd[f] - known.centroids[choice].jnd[f]) / known.spread[f];
    sum += off * off;
  }
  return sum;
}

}  // namespace

std::vector<Choice> surfaces_under(std::string_view tool) {
  std::vector<Choice> choices;
  for (const SurfaceMaterial& surface : surface_materials()) {
    choices.push_back({surface.id, &surface, find_medium(tool)});
  }
  return choices;
}

std::vector<Choice> media_on(std::string_view surface) {
  std::vector<Choice> choices;
  for (const Medium& medium : media()) {
    choices.push_back({medium.id, find_surface(surface), &medium});
  }
  return choices;
}

std::vector<BlindCheck> blind_checks_of_surfaces() {
  return {{.name = "touch", .device = "touch", .choices = surfaces_under("pencil")},
          {.name = "omega",
           .device = "omega",
           .period_ns = 250'000,
           .choices = surfaces_under("pencil")}};
}

std::vector<BlindCheck> blind_checks_of_media() {
  return {{.name = "touch", .device = "touch", .choices = media_on(kMediaSurface)},
          {.name = "omega",
           .device = "omega",
           .period_ns = 250'000,
           .choices = media_on(kMediaSurface)}};
}

double Confusion::accuracy() const {
  int right = 0, all = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    right += counts[i][i];
    for (const int count : counts[i]) all += count;
  }
  return all > 0 ? static_cast<double>(right) / all : 0.0;
}

int Confusion::pairs() const {
  const auto count = static_cast<int>(of_two.size());
  return count * (count - 1) / 2;
}

int Confusion::distinct_pairs() const {
  int distinct = 0;
  for (std::size_t i = 0; i < of_two.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) distinct += of_two[i][j] >= kDistinct ? 1 : 0;
  }
  return distinct;
}

std::string Confusion::text() const {
  std::string out = "| drawn | taken for";
  for (const std::string& id : ids) out += " " + id + " |";
  out += "\n|---|";
  for (std::size_t j = 0; j < counts.size(); ++j) out += "---|";
  out += '\n';
  for (std::size_t i = 0; i < counts.size(); ++i) {
    out += "| " + ids[i] + " |";
    for (std::size_t j = 0; j < counts.size(); ++j) {
      const std::string count = counts[i][j] > 0 ? std::to_string(counts[i][j]) : "";
      out += i == j ? " **" + count + "** |" : " " + count + " |";
    }
    out += '\n';
  }
  return out;
}

Confusion run_blind_check(const BlindCheck& check) {
  Confusion result;
  std::vector<Felt> felt;
  for (std::size_t choice = 0; choice < check.choices.size(); ++choice) {
    result.ids.push_back(check.choices[choice].id);
    felt.push_back(feel(check, choice, result.is_sound));
  }
  const Known known = learn(felt, static_cast<std::size_t>(check.learn));
  const std::size_t count = felt.size();
  result.counts.assign(count, std::vector<int>(count, 0));
  result.of_two.assign(count, std::vector<double>(count, 0.0));
  for (std::size_t i = 0; i < count; ++i) {
    for (auto stroke = static_cast<std::size_t>(check.learn); stroke < felt[i].size(); ++stroke) {
      std::size_t nearest = 0;
      std::vector<double> off(count);
      for (std::size_t j = 0; j < count; ++j) {
        off[j] = distance_squared(known, j, felt[i][stroke]);
        if (off[j] < off[nearest]) nearest = j;
      }
      ++result.counts[i][nearest];
      for (std::size_t j = 0; j < count; ++j) {
        const double share = 0.5 / check.judge;
        if (off[i] < off[j]) result.of_two[i][j] += share;
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      result.of_two[i][j] = result.of_two[j][i] = result.of_two[i][j] + result.of_two[j][i];
    }
  }
  return result;
}

std::string name_of_pair(const BlindCheck& check, std::size_t i, std::size_t j) {
  return check.name + ": " + check.choices[i].id + ", " + check.choices[j].id;
}

std::vector<std::string> alike_pairs(const BlindCheck& check, const Confusion& confusion) {
  std::vector<std::string> pairs;
  for (std::size_t i = 0; i < confusion.of_two.size(); ++i) {
    for (std::size_t j = i + 1; j < confusion.of_two.size(); ++j) {
      if (confusion.of_two[i][j] < kDistinct) pairs.push_back(name_of_pair(check, i, j));
    }
  }
  return pairs;
}

}  // namespace felt
