#include "identify/decision/decision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fourpost {
namespace {

using Eigen::Index;

double QuantileOfSorted(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

/// Adds the share of this draw to its best settings, and its regrets.
void AddDraw(const Eigen::MatrixXd& cost, Index draw, const std::vector<bool>& is_admitted, Decision& decision) {
  double least = std::numeric_limits<double>::infinity();
  Index equals = 0;
  for (Index s = 0; s < cost.rows(); ++s) {
    if (!is_admitted[static_cast<std::size_t>(s)] || cost(s, draw) > least) continue;
    equals = cost(s, draw) < least ? 1 : equals + 1;
    least = cost(s, draw);
  }
  const auto draws = static_cast<double>(cost.cols());
  for (Index s = 0; s < cost.rows(); ++s) {
    if (is_admitted[static_cast<std::size_t>(s)] && cost(s, draw) == least)
      decision.best_probability[s] += 1 / (draws * static_cast<double>(equals));
    decision.regret[s] += (cost(s, draw) - least) / draws;
  }
}

std::size_t BestOf(const Eigen::VectorXd& mean, const std::vector<bool>& is_admitted) {
  std::size_t best = is_admitted.size();
  for (std::size_t s = 0; s < is_admitted.size(); ++s)
    if (is_admitted[s] && (best == is_admitted.size() || mean[static_cast<Index>(s)] < mean[static_cast<Index>(best)]))
      best = s;
  if (best == is_admitted.size()) throw std::invalid_argument("no setting is admitted");
  return best;
}

}  // namespace

std::size_t Decision::IndistinctCount() const {
  return static_cast<std::size_t>(std::count(is_indistinct.begin(), is_indistinct.end(), true));
}

std::size_t Decision::Rival() const {
  std::size_t rival = best;
  for (std::size_t s = 0; s < is_admitted.size(); ++s) {
    if (!is_admitted[s] || s == best) continue;
    const auto i = static_cast<Index>(s);
    const auto r = static_cast<Index>(rival);
    if (rival == best || best_probability[i] > best_probability[r] ||
        (best_probability[i] == best_probability[r] && mean[i] < mean[r]))
      rival = s;
  }
  return rival;
}

DrawSummary Summarise(const Eigen::VectorXd& draws) {
  std::vector<double> sorted(draws.begin(), draws.end());
  std::sort(sorted.begin(), sorted.end());
  const double mean = draws.mean();
  const auto freedom = std::max<double>(1, static_cast<double>(draws.size() - 1));
  return {.mean = mean,
          .sd = std::sqrt((draws.array() - mean).square().sum() / freedom),
          .lower = QuantileOfSorted(sorted, 0.025),
          .upper = QuantileOfSorted(sorted, 0.975)};
}

Decision Decide(const Eigen::MatrixXd& cost, const std::vector<bool>& is_admitted) {
  if (cost.cols() < 1) throw std::invalid_argument("a decision needs a draw");
  const Index settings = cost.rows();
  Decision decision;
  decision.is_admitted = is_admitted;
  decision.mean = cost.rowwise().mean();
  decision.best = BestOf(decision.mean, is_admitted);
  decision.best_probability = Eigen::VectorXd::Zero(settings);
  decision.regret = Eigen::VectorXd::Zero(settings);
  for (Index d = 0; d < cost.cols(); ++d) AddDraw(cost, d, is_admitted, decision);
  for (Eigen::VectorXd* of : {&decision.difference, &decision.difference_sd, &decision.lower, &decision.upper})
    of->resize(settings);
  for (Index s = 0; s < settings; ++s) {
    const DrawSummary summary = Summarise((cost.row(s) - cost.row(static_cast<Index>(decision.best))).transpose());
    decision.difference[s] = summary.mean;
    decision.difference_sd[s] = summary.sd;
    decision.lower[s] = summary.lower;
    decision.upper[s] = summary.upper;
    decision.is_indistinct.push_back(is_admitted[static_cast<std::size_t>(s)] && summary.lower <= 0);
  }
  return decision;
}

std::vector<std::size_t> ParetoFront(const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                                     const std::vector<bool>& is_admitted) {
  std::vector<std::size_t> order;
  for (std::size_t s = 0; s < is_admitted.size(); ++s)
    if (is_admitted[s]) order.push_back(s);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto i = static_cast<Index>(a);
    const auto j = static_cast<Index>(b);
    return first[i] != first[j] ? first[i] < first[j] : second[i] < second[j];
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t s : order) {
    if (!(second[static_cast<Index>(s)] < least)) continue;
    least = second[static_cast<Index>(s)];
    front.push_back(s);
  }
  return front;
}

}  // namespace fourpost
