#include "identify/search/downhill_simplex.h"

#include "analysis/text/option_check.h"
#include "identify/search/draws.h"
#include "identify/search/dvhde_operators.h"

namespace fourpost {

void SimplexOptions::Validate() const { RequireOption(scouts >= 1, "scouts", scouts, "1 or more"); }

DownhillSimplex::DownhillSimplex(const Lattice& lattice, const SimplexOptions& options, std::uint64_t seed)
    : lattice_(&lattice), options_(options), seed_(seed) {
  options_.Validate();
  best_.failure = Failure::kNotFinite;
  AskScouts();
}

const std::vector<LatticePoint>& DownhillSimplex::Ask() const {
  return simplex_ && !state_.collapsed ? simplex_->Ask() : asked_;
}

void DownhillSimplex::Tell(const std::vector<Score>& scores) {
  ends_generation_ = false;
  if (simplex_) {
    simplex_->Tell(scores);
    if (simplex_->iterations() > iterations_) EndGeneration();
    return;
  }
  Population scouts;
  for (std::size_t i = 0; i < scores.size(); ++i) scouts.push_back({asked_[i], scores[i]});
  if (!options_.from_scouts) scouts = {scouts[BestIndex(scouts)]};
  asked_.clear();
  simplex_.emplace(*lattice_, scouts);
  iterations_ = 0;
}

void DownhillSimplex::AskScouts() {
  for (std::size_t i = 0; i < static_cast<std::size_t>(options_.scouts); ++i) {
    Draws draws(seed_, DrawPurpose::kStart, restarts_, i);
    asked_.push_back(RandomPoint(*lattice_, draws));
  }
}

void DownhillSimplex::EndGeneration() {
  ends_generation_ = true;
  iterations_ = simplex_->iterations();
  ++state_.generation;
  const bool gained = IsBetter(simplex_->best().score, best_);
  if (gained) best_ = simplex_->best().score;
  state_.stagnant_generations = gained ? 0 : state_.stagnant_generations + 1;
  state_.migrated = false;
  if (!simplex_->IsCollapsed()) return;
  state_.collapsed = !options_.restarts;
  if (state_.collapsed) return;
  state_.migrated = true;
  simplex_.reset();
  ++restarts_;
  AskScouts();
}

}  // namespace fourpost
