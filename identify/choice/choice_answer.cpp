#include "identify/choice/choice_answer.h"

#include <algorithm>
#include <cmath>

namespace fourpost {

std::vector<std::string> ChoiceAnswer::ExactKnobs() const {
  std::vector<std::string> names;
  for (const Knob& knob : knobs())
    if (knob.positions.front().drawn.size() == 0) names.push_back(knob.name);
  return names;
}

bool ChoiceAnswer::HasStraightLines() const {
  const auto is_between = [](double row) { return row != std::floor(row); };
  return std::any_of(knobs().begin(), knobs().end(), [&](const Knob& knob) {
    return knob.bench && std::any_of(knob.bench->rows.begin(), knob.bench->rows.end(), is_between);
  });
}

std::string ChoiceAnswer::NameOf(std::size_t row) const { return SettingText(knobs(), choice.rows[row].setting); }

std::vector<std::size_t> ChoiceAnswer::NotableRows(std::size_t count) const {
  std::vector<std::size_t> rows;
  for (std::size_t s = 0; s < choice.rows.size(); ++s)
    if (choice.rows[s].is_indistinct && s != choice.best && s != choice.present) rows.push_back(s);
  std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return choice.rows[a].best_probability > choice.rows[b].best_probability;
  });
  if (choice.best != choice.present) rows.insert(rows.begin(), choice.present);
  if (choice.best) rows.insert(rows.begin(), *choice.best);
  rows.resize(std::min(rows.size(), count));
  return rows;
}

}  // namespace fourpost
