#include "identify/choice/bench_doubt.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "analysis/signals/mix_bits.h"
#include "identify/choice/findings.h"
#include "identify/choice/position_table.h"
#include "identify/run/run_draws.h"
#include "identify/run/run_spread.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Without a slash at the end.
std::filesystem::path Canonical(const std::filesystem::path& path) {
  std::error_code failure;
  std::filesystem::path canonical = std::filesystem::weakly_canonical(path, failure);
  if (failure) canonical = path;
  return canonical.has_filename() ? canonical : canonical.parent_path();
}

/// The fit of a bench, and the knobs that follow it.
class FollowedBench {
 public:
  FollowedBench(BenchRun run, std::vector<Knob*> knobs) : run_(std::move(run)), knobs_(std::move(knobs)) {}

  BenchDoubt Follow(const RunDraws& draws) {
    BenchDoubt doubt{.confidence = draws.confidence};
    for (const Knob* knob : knobs_) doubt.knobs.push_back(knob->name);
    SetDrawn(draws);
    std::vector<Index> followed;
    for (std::size_t j = 0; j < draws.names.size(); ++j)
      if (IsFollowed(draws.names[j])) {
        followed.push_back(static_cast<Index>(j));
        doubt.parameters.push_back(draws.names[j]);
      }
    doubt.draws = draws.values(Eigen::all, followed);
    return doubt;
  }

 private:
  std::optional<std::size_t> PlaceOf(const std::string& name) const {
    const std::vector<Parameter>& parameters = run_.vehicle.parameters;
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const Parameter& parameter) { return parameter.name == name; });
    if (found == parameters.end()) return std::nullopt;
    return static_cast<std::size_t>(found - parameters.begin());
  }

  void SetDrawn(const RunDraws& draws) {
    for (Knob* knob : knobs_)
      for (Knob::Position& position : knob->positions)
        position.drawn.resize(draws.values.rows(), static_cast<Index>(position.values.size()));
    std::vector<double> values = run_.vehicle.ParameterValues();
    for (Index d = 0; d < draws.values.rows(); ++d) {
      for (std::size_t j = 0; j < draws.names.size(); ++j)
        if (const std::optional<std::size_t> place = PlaceOf(draws.names[j]))
          values[*place] = draws.values(d, static_cast<Index>(j));
      const PositionTable table = run_.TableAt(values);
      for (Knob* knob : knobs_)
        for (std::size_t p = 0; p < knob->positions.size(); ++p)
          for (std::size_t i = 0; i < knob->bench->columns.size(); ++i)
            knob->positions[p].drawn(d, static_cast<Index>(i)) =
                knob->bench->factors[i] * table.At(knob->bench->columns[i], knob->bench->rows[p]);
    }
  }

  /// Whether a number that a position takes changes with this parameter.
  bool IsFollowed(const std::string& name) const {
    const std::optional<std::size_t> place = PlaceOf(name);
    if (!place) return false;
    std::vector<double> values = run_.vehicle.ParameterValues();
    const PositionTable before = run_.TableAt(values);
    values[*place] += 1;
    const PositionTable after = run_.TableAt(values);
    for (const Knob* knob : knobs_)
      for (const std::size_t column : knob->bench->columns)
        for (const double row : knob->bench->rows)
          if (before.At(column, row) != after.At(column, row)) return true;
    return false;
  }

  BenchRun run_;
  std::vector<Knob*> knobs_;
};

}  // namespace

BenchDraws DrawBenches(std::vector<Knob>& knobs, const std::filesystem::path& file, const BenchDrawRequest& request,
                       const WorkHooks& hooks) {
  // In the order of the file, so that seeds do not depend on where it lies.
  std::vector<std::pair<std::filesystem::path, std::vector<Knob*>>> followers;
  for (Knob& knob : knobs) {
    if (!knob.bench) continue;
    const std::filesystem::path run = Canonical(knob.bench->run);
    auto found = std::find_if(followers.begin(), followers.end(), [&](const auto& one) { return one.first == run; });
    if (found == followers.end()) found = followers.insert(found, {run, {}});
    found->second.push_back(&knob);
  }
  BenchDraws drawn;
  for (std::size_t k = 0; k < followers.size(); ++k) {
    const std::filesystem::path run = followers[k].second.front()->bench->run;
    const Place place{file.string(), followers[k].second.front()->line};
    std::optional<BenchRun> bench = ReadBenchRun(run, drawn.findings);
    if (!bench) continue;
    if (!HasRunSpread(run)) {
      drawn.findings.Report(kBenchWithoutDoubt, place, {run.string()});
      continue;
    }
    const bool is_car = !request.car.empty() && followers[k].first == Canonical(request.car);
    // Other streams than the car's: equal seeds would make equal normal numbers.
    const std::uint64_t seed = is_car ? request.seed : MixBits(MixBits(request.seed) + k);
    const std::optional<RunDraws> draws =
        DrawFromRun({.run = run, .count = request.count, .seed = seed, .threads = request.threads}, hooks);
    drawn.is_interrupted = drawn.is_interrupted || !draws;
    if (!draws) return drawn;
    BenchDoubt doubt = FollowedBench(*std::move(bench), followers[k].second).Follow(*draws);
    if (is_car) continue;
    doubt.name = followers[k].first.filename().string();
    const auto is_named_so = [&](const auto& other) { return other.first.filename() == doubt.name; };
    if (std::count_if(followers.begin(), followers.end(), is_named_so) > 1) doubt.name = run.string();
    drawn.findings.Add(draws->findings);
    drawn.benches.push_back(std::move(doubt));
  }
  return drawn;
}

}  // namespace fourpost
