#include "identify/residuals/yardstick.h"

#include <algorithm>
#include <cmath>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/arx.h"
#include "analysis/signals/spectrum.h"

namespace fourpost {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kHighestOrder = 20;
constexpr Index kMostSamples = 20000;

std::span<const double> Span(const VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

/// Samples from one that a linear model takes to the next.
Index StrideOf(const VectorXd& values, double rate_Hz) {
  constexpr double kSamplesPerPeriod = 25;
  constexpr double kShare = 0.95;
  if (values.size() < 16) return 1;
  const auto segment = static_cast<std::size_t>(std::min<Index>(2048, values.size()));
  const Spectrum spectrum = WelchSpectrum(Span(values), Span(values), rate_Hz, segment);
  double all = 0;
  for (const double power : spectrum.first) all += power;
  double below = 0;
  std::size_t k = 0;
  while (k + 1 < spectrum.first.size() && (below += spectrum.first[k]) < kShare * all) ++k;
  const double edge_Hz = std::max(spectrum.frequency_Hz[k], spectrum.frequency_Hz[1]);
  return std::max<Index>(1, static_cast<Index>(rate_Hz / (kSamplesPerPeriod * edge_Hz)));
}

const VectorXd* Find(const YardstickRecord& record, const std::string& channel) {
  const auto found = std::find_if(record.channels.begin(), record.channels.end(),
                                  [&](const YardstickRecord::Channel& other) { return other.name == channel; });
  return found == record.channels.end() ? nullptr : &found->values;
}

bool AreOneSystem(const YardstickRecord& a, const YardstickRecord& b) {
  return a.rate_Hz == b.rate_Hz && a.setting == b.setting;
}

MatrixXd Centred(const MatrixXd& values) { return values.rowwise() - values.colwise().mean(); }

/// From inputs to unlike ones, each over its deviation.
MatrixXd PrincipalInputs(const std::vector<const YardstickRecord*>& records) {
  constexpr double kLeastPower = 1e-4;
  const Index inputs = records.front()->inputs.cols();
  if (inputs == 0) return MatrixXd(0, 0);
  MatrixXd power = MatrixXd::Zero(inputs, inputs);
  double samples = 0;
  for (const YardstickRecord* record : records) {
    const MatrixXd centred = Centred(record->inputs);
    power += centred.transpose() * centred;
    samples += static_cast<double>(centred.rows());
  }
  // Heights and forces alike.
  const VectorXd scale =
      (power.diagonal() / samples).unaryExpr([](double square) { return square > 0 ? 1 / std::sqrt(square) : 0; });
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(scale.asDiagonal() * (power / samples) * scale.asDiagonal());
  MatrixXd out(inputs, inputs);
  Index count = 0;
  for (Index i = inputs - 1; i >= 0 && pairs.values[i] > kLeastPower * pairs.values[inputs - 1]; --i)
    out.col(count++) = scale.cwiseProduct(pairs.vectors.col(i)) / std::sqrt(pairs.values[i]);
  return out.leftCols(count);
}

ArxRecord RecordOf(const YardstickRecord& record, const VectorXd& values, const MatrixXd& principal, double scale,
                   Index stride) {
  const auto strided = Eigen::seqN(0, (values.size() + stride - 1) / stride, stride);
  return {.inputs = record.inputs(strided, Eigen::all).eval() * principal, .output = values(strided) / scale};
}

/// The first samples, as many as there is room for.
void Shorten(std::vector<ArxRecord>& records) {
  Index room = kMostSamples;
  for (ArxRecord& record : records) {
    const Index count = std::min(room, record.output.size());
    record.inputs = record.inputs.topRows(count).eval();
    record.output = record.output.head(count).eval();
    room -= count;
  }
}

/// The linear model of a channel at a rate.
struct LinearModel {
  MatrixXd principal;
  double scale = 1;
  Index stride = 1;
  std::optional<Arx> arx;
};

LinearModel FitLinear(const std::vector<YardstickRecord>& fitted, const std::string& channel,
                      const YardstickRecord& judged) {
  std::vector<const YardstickRecord*> records;
  for (const YardstickRecord& record : fitted)
    if (Find(record, channel) && AreOneSystem(record, judged) && record.inputs.cols() == judged.inputs.cols())
      records.push_back(&record);
  LinearModel model;
  if (records.empty()) return model;
  model.principal = PrincipalInputs(records);
  const VectorXd& first = *Find(*records.front(), channel);
  model.scale = std::sqrt((first.array() - first.mean()).square().mean());
  model.stride = StrideOf(first, judged.rate_Hz);
  if (!(model.scale > 0)) return model;
  std::vector<ArxRecord> samples;
  for (const YardstickRecord* record : records)
    samples.push_back(RecordOf(*record, *Find(*record, channel), model.principal, model.scale, model.stride));
  Shorten(samples);
  model.arx = FitArx(samples, kHighestOrder);
  return model;
}

void AddLinear(const LinearModel& model, const YardstickRecord& judged, const VectorXd& values, Yardstick& yardstick) {
  constexpr double kSegment_s = 4;
  if (!model.arx) return;
  const ArxRecord record = RecordOf(judged, values, model.principal, model.scale, model.stride);
  if (record.output.size() <= model.arx->order) return;
  const auto error = [&](const VectorXd& modelled) {
    const double percent = ErrorOf({&record, 1}, {&modelled, 1});
    return std::isfinite(percent) ? std::optional(percent) : std::nullopt;
  };
  yardstick.order = model.arx->order;
  yardstick.one_step_nmse_percent = error(model.arx->OneStep(record));
  // Worse than a constant: what was fitted for one step ahead drifts or swings off, which says nothing of the data.
  const std::optional<double> simulated = error(model.arx->FreeRun(record));
  if (simulated && *simulated < 100) yardstick.nmse_percent = simulated;
  yardstick.coherence = LinearShare(
      record, static_cast<Index>(std::lround(kSegment_s * judged.rate_Hz / static_cast<double>(model.stride))));
}

bool AreRepeats(const YardstickRecord& a, const YardstickRecord& b) {
  constexpr double kAlike = 1e-3;
  if (!AreOneSystem(a, b) || a.inputs.rows() != b.inputs.rows() || a.inputs.cols() != b.inputs.cols()) return false;
  const double power = Centred(a.inputs).squaredNorm();
  return power > 0 && Centred(a.inputs - b.inputs).squaredNorm() < kAlike * power;
}

void AddRepeats(const std::vector<YardstickRecord>& records, const YardstickRecord& judged, const std::string& channel,
                const VectorXd& values, Yardstick& yardstick) {
  double sum = 0;
  int count = 0;
  for (const YardstickRecord& record : records) {
    const VectorXd* other = Find(record, channel);
    if (record.name == judged.name || !other || !AreRepeats(record, judged)) continue;
    const VectorXd apart = *other - values;
    sum += record.has_means ? apart.squaredNorm() : Centred(apart).squaredNorm();
    ++count;
  }
  if (count > 0) yardstick.repeat_nmse_percent = 100 * sum / (2 * count) / Centred(values).squaredNorm();
}

}  // namespace

std::optional<double> Yardstick::Allowed_percent() const {
  if (nmse_percent && repeat_nmse_percent) return std::min(*nmse_percent, *repeat_nmse_percent);
  return nmse_percent ? nmse_percent : repeat_nmse_percent;
}

void AddYardsticks(const std::vector<YardstickRecord>& fitted, const std::vector<YardstickRecord>& judged,
                   std::span<HistoryMisfit> misfits) {
  struct Known {
    std::string channel;
    const YardstickRecord* record;
    LinearModel model;
  };
  std::vector<Known> models;
  std::vector<YardstickRecord> all = fitted;
  for (const YardstickRecord& record : judged)
    if (std::none_of(fitted.begin(), fitted.end(), [&](const auto& other) { return other.name == record.name; }))
      all.push_back(record);
  std::size_t at = 0;
  for (const YardstickRecord& record : judged)
    for (const YardstickRecord::Channel& channel : record.channels) {
      auto known = std::find_if(models.begin(), models.end(), [&](const Known& one) {
        return one.channel == channel.name && AreOneSystem(*one.record, record);
      });
      if (known == models.end())
        known = models.insert(models.end(), {channel.name, &record, FitLinear(fitted, channel.name, record)});
      AddLinear(known->model, record, channel.values, misfits[at].yardstick);
      AddRepeats(all, record, channel.name, channel.values, misfits[at].yardstick);
      ++at;
    }
}

}  // namespace fourpost
