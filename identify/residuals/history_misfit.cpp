#include "identify/residuals/history_misfit.h"

#include "analysis/signals/autocorrelation.h"

namespace fourpost {

void JudgeNoise(const Eigen::VectorXd& residual, HistoryMisfit& misfit) {
  const Whiteness whiteness = WhitenessOf(residual);
  misfit.residual_correlation = whiteness.next;
  misfit.is_white = whiteness.IsWhite();
  misfit.effective_samples = EffectiveSamples(residual.array() - residual.mean());
}

std::vector<ErrorShare> ErrorShares(const std::vector<HistoryMisfit>& misfits) {
  std::vector<ErrorShare> shares;
  for (const HistoryMisfit& misfit : misfits)
    shares.push_back({.channel = misfit.name,
                      .recording = misfit.recording,
                      .kind = misfit.unit,
                      .unit = misfit.unit,
                      .error = misfit.nmse_percent / 100 * misfit.measured_squares,
                      .measured = misfit.measured_squares});
  return shares;
}

}  // namespace fourpost
