// What many contacts do at once, in three acts: Newton's cradle and the break of fifteen balls,
// each under three models, and balls that pour on the cylinder and come to rest.
#include <cstdio>
#include <functional>

#include "render/film/film.hpp"
#include "scene_pictures.hpp"

using namespace lab::multi_contact;

namespace {

/// A part of the film; its times are those since its start.
struct Act {
  double start;
  double duration;
  std::vector<double> strip_times;
  std::string measured;  ///< for the foot of the strip
  std::function<void(render::Scene& scene, double time)> draw;
};

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// As in 2.2e-16, but 0 for zero.
std::string short_number(double value) { return value == 0.0 ? "0" : formatted("%.2g", value); }

/// What each model makes of a motion; nothing for one that is not written yet.
template <typename Motion>
using OfModels = std::array<std::optional<Motion>, models.size()>;

template <typename Motion>
OfModels<Motion> of_models(Motion (*make)(const Model&), std::vector<std::string>& missing) {
  OfModels<Motion> motions;
  for (std::size_t i = 0; i < models.size(); ++i) {
    motions[i] = common::if_written(missing, [&] { return make(models[i]); });
  }
  return motions;
}

template <typename Motion>
bool any(const OfModels<Motion>& motions) {
  return std::any_of(motions.begin(), motions.end(), [](const auto& one) { return one; });
}

std::string name(const Model& model) { return std::string(model.name[0]) + " " + model.name[1]; }

/// As in "4 impulses".
std::string work(const Ledger& ledger, const Model& model) {
  return std::to_string(ledger.first_count) + " " + model.what;
}

Act cradle_act(const OfModels<Cradle>& cradles) {
  Act act{0.0, 1.75 * period, {0.0, 0.4 * period, 0.93 * period, 1.4 * period}, "", nullptr};
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!cradles[i]) continue;
    const Ledger& ledger = cradles[i]->ledger;
    act.measured += act.measured.empty() ? "cradle, |Δp|/|p| and |ΔE|/E at most: " : ", ";
    act.measured += name(models[i]) + " " + short_number(ledger.momentum_error) + " and " +
                    short_number(ledger.energy_error);
  }
  act.draw = [=](render::Scene& scene, double time) {
    add_stand(scene);
    for (std::size_t i = 0; i < models.size(); ++i) {
      if (!cradles[i]) continue;
      add_cradle(scene, *cradles[i], i, time);
      add_words(scene, {0.0, -2.1, bar_height(i) - 0.3}, models[i],
                {work(cradles[i]->ledger, models[i])});
    }
  };
  return act;
}

Act break_act(const OfModels<Break>& played) {
  Act act{0.0, break_duration, {0.2, 0.99 * break_duration}, "", nullptr};
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!played[i]) continue;
    act.measured += (act.measured.empty() ? "break, |ΔE|/E: " : ", ") +
                    short_number(played[i]->ledger.energy_error);
  }
  act.draw = [=](render::Scene& scene, double time) {
    scene.ground = false;
    for (std::size_t i = 0; i < models.size(); ++i) {
      if (!played[i]) continue;
      add_table(scene, *played[i], i, time);
      std::vector<std::string> words;
      if (played[i]->ledger.impacts > 0 && time >= played[i]->flights[1].start) {
        words.push_back(work(played[i]->ledger, models[i]));
        words.insert(words.end(), {"asymmetry", short_number(played[i]->asymmetry)});
      }
      add_words(scene, {0.0, table_middle(i) - 0.48 * table_width, 2.2}, models[i], words);
    }
  };
  return act;
}

Act pile_act(const Pile& pile) {
  Act act{0.0, pile_duration, {1.4, pile_duration}, "", nullptr};
  act.measured = formatted(
      "pile: overlap at most %.1f mm, where exact impulses allow %.1f mm; at the end %.1f mm, "
      "%.1g m/s, and floor and cylinder carry %.1f of %zu weights",
      1e3 * pile.deepest, 1e3 * pile.sinks, 1e3 * pile.deepest_at_end, pile.fastest_at_end,
      pile.carried, pile.steps.back().size());
  if (pile.contacts >= too_many) {
    act.measured += formatted("; stopped after %.2f s with %zu contacts",
                              dt * static_cast<double>(pile.steps.size()), pile.contacts);
  }
  act.draw = [pile](render::Scene& scene, double time) { add_pile(scene, pile, time); };
  return act;
}

/// One act after the other.
void play(std::vector<Act> acts, render::Film& film) {
  film.duration = 0.0;
  for (Act& act : acts) {
    act.start = film.duration;
    for (const double time : act.strip_times) film.strip_times.push_back(film.duration + time);
    film.measured += (film.measured.empty() ? "" : ";  ") + act.measured;
    film.duration += act.duration;
  }
  film.scene_at = [=](double time) {
    const Act& act = part_at(acts, time);
    render::Scene scene;
    scene.ground_height = ground_height;
    act.draw(scene, std::min(time - act.start, act.duration));
    return scene;
  };
}

render::Film make_film() {
  render::Film film;
  film.title = "Many contacts at once";
  film.subtitle =
      "Newton's cradle and a break of fifteen balls under three models, and a pile that comes to "
      "rest";
  film.parameters = formatted(
      "cradle and break: e = 1, swings by the small-angle law; pile: %d balls, e = 0, %d steps a "
      "second of %d sweeps, colours: borne load in weights of a ball",
      pile_balls, steps_a_second, sweeps);
  film.bounds = {{-0.2, -2.15, ground_height}, {0.2, 2.15, 2.25}};
  film.towards_eye = towards_eye;

  const OfModels<Cradle> cradles = of_models<Cradle>(swung, film.missing);
  const OfModels<Break> played = of_models<Break>(broken, film.missing);
  const std::optional<Pile> pile = piled(film.missing);
  std::vector<Act> acts;
  if (any(cradles)) acts.push_back(cradle_act(cradles));
  if (any(played)) acts.push_back(break_act(played));
  if (pile) acts.push_back(pile_act(*pile));
  if (!acts.empty()) play(acts, film);  // else film_main says what is missing
  return film;
}

}  // namespace

int main(int argc, char** argv) { return render::film_main(argc, argv, make_film); }
