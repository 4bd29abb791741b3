#include "analysis/zero_phase.h"

#include <algorithm>

#include "analysis/option_check.h"

namespace fourpost {

std::vector<double> ZeroPhase(std::vector<double> signal, const LowPass& filter) {
  const auto is_first_order = [](const LowPass::Section& section) { return section.b2 == 0; };
  const auto& sections = filter.sections();
  const auto odd = static_cast<std::size_t>(std::count_if(sections.begin(), sections.end(), is_first_order));
  const std::size_t edge = 3 * (2 * sections.size() + 1 - odd);
  RequireOption(signal.size() > edge, "ZeroPhase: samples", signal.size(), "more than " + std::to_string(edge));
  std::vector<double> longer;
  const std::size_t size = signal.size();
  for (std::size_t k = edge; k > 0; --k) longer.push_back(2 * signal.front() - signal[k]);
  longer.insert(longer.end(), signal.begin(), signal.end());
  for (std::size_t k = 1; k <= edge; ++k) longer.push_back(2 * signal.back() - signal[size - 1 - k]);
  for (int way = 0; way < 2; ++way) {
    filter.ApplySettled(longer);
    std::reverse(longer.begin(), longer.end());
  }
  return {longer.begin() + static_cast<std::ptrdiff_t>(edge), longer.end() - static_cast<std::ptrdiff_t>(edge)};
}

}  // namespace fourpost
