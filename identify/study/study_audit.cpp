#include "identify/study/study_audit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/text/short_number.h"
#include "identify/experiments/audited_vehicle.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/four_post.h"
#include "identify/experiments/four_post/study_recording.h"
#include "identify/experiments/four_post/wheelpan_lint.h"
#include "identify/experiments/time_history/time_histories.h"
#include "identify/study/audit_text.h"
#include "identify/study/findings.h"
#include "identify/study_file/channel_source_text.h"
#include "identify/study_file/thousandfold.h"

namespace fourpost {
namespace {

using Kind = RigFault::Kind;
using Where = RigFault::Where;

constexpr double kMilli = 1e3;

/// What is left over, over its noise, when no fault that is known explains it.
constexpr double kContradiction = 2;

/// `is_unit`: one unit is so many times the other.
struct KnownFactor {
  double factor;
  const char* words;
  bool is_unit = true;
};
constexpr std::array kKnownFactors = {
    KnownFactor{9.80665, "g instead of m/s^2"}, KnownFactor{25.4, "inches instead of mm"},
    KnownFactor{4.4482216, "pounds instead of N"}, KnownFactor{1000, "a prefix of a thousand"},
    KnownFactor{2, "peak to peak for amplitude, or a sum for a mean", false}};

/// Of recorded over true, or its reciprocal; null where it is none of a unit.
const KnownFactor* KnownOf(double factor) {
  // Sensors that are right but for their unit are off by some per cent: a strut of the Land Rover's by 2 %.
  constexpr double kNear = 0.03;
  for (const KnownFactor& known : kKnownFactors)
    for (const double one : {known.factor, 1 / known.factor})
      if (std::abs(factor / one - 1) < kNear) return &known;
  return nullptr;
}

/// Recorded over true.
double FactorOf(double size) { return 1 / (1 + size); }

/// "'a_cg' reads 1.03 times the true value"
std::string Words(const RigFault& fault, double size) {
  switch (fault.kind) {
    case Kind::kScale: return "'" + fault.name + "' reads " + ShortNumber(FactorOf(size), 4) + " times the true value";
    case Kind::kDelay:
      return "'" + fault.name + "' comes " + ShortNumber(std::abs(size) * kMilli, 2) + " ms " +
             (size > 0 ? "late" : "early");
    case Kind::kPlace:
      return "'" + fault.name + "' sits " + ShortNumber(std::abs(size), 2) + " m further along " +
             (size > 0 ? "+" : "-") + AxisName(fault.axis);
    case Kind::kWheelpan:
      return "'" + fault.name + "' feels " + ShortNumber(std::abs(size), 2) + " kg " + (size > 0 ? "more" : "less") +
             " than the wheelpan in the vehicle file";
    case Kind::kExchange: return fault.name + " are exchanged";
    case Kind::kOther: return "'" + fault.name + "' measures something else";
  }
  return "";
}

/// "wheelpan of 'F_tyre': about 14.0 kg (standard deviation 0.2 kg), 10 kg in the vehicle file"
std::string WheelpanWords(const Suspicion& suspicion) {
  const double kg = suspicion.wheelpan_kg + suspicion.size;
  return "wheelpan of '" + suspicion.fault.name + "': about " + MassText(kg, suspicion.sd) + ", " +
         ShortNumber(suspicion.wheelpan_kg, 3) + " kg in the vehicle file";
}

std::string RivalWords(const Suspicion& suspicion) {
  constexpr std::size_t kMost = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, suspicion.rivals.size()); ++i)
    text += ", or " + Words(suspicion.rivals[i].fault, suspicion.rivals[i].size);
  return text;
}

const Finding& KindOf(const RigFault& fault, double size) {
  switch (fault.kind) {
    case Kind::kExchange: return kRigExchanged;
    case Kind::kOther: return kRigForeign;
    case Kind::kDelay: return fault.where == Where::kPosts ? kRigPostsDelay : kRigDelay;
    case Kind::kPlace: return kRigPlace;
    case Kind::kWheelpan: return kRigWheelpan;
    case Kind::kScale: break;
  }
  if (fault.where == Where::kClock) return kRigClock;
  if (fault.where == Where::kWeight) return kRigLoads;
  const double factor = FactorOf(size);
  if (std::abs(factor + 1) < 0.1) return kRigSign;
  if (KnownOf(factor) != nullptr) return kRigUnit;
  return fault.where == Where::kPosts ? kRigPostsScale : kRigScale;
}

bool IsError(const RigFault& fault, double size) { return KindOf(fault, size).severity() == Severity::kError; }

/// Beyond doubt: twenty standard deviations, and nothing else comes near but what is an error as well. Without a force,
/// the sign of a strut explains what those of all accelerometers explain, and one of the two is wrong.
bool IsCertain(const Suspicion& suspicion) {
  constexpr double kBeyondDoubt = 400;
  return std::all_of(suspicion.rivals.begin(), suspicion.rivals.end(),
                     [](const Suspicion::Rival& rival) { return IsError(rival.fault, rival.size); }) &&
         suspicion.score > kBeyondDoubt && suspicion.next_score < 0.8 * suspicion.score;
}

/// Null of a device, a post, or a channel that the study does not have.
const ChannelSource* SourceOf(const LoadedStudy& study, const std::string& sensor) {
  const auto named = [&](const std::vector<std::pair<std::string, ChannelSource>>& channels) -> const ChannelSource* {
    const auto found =
        std::find_if(channels.begin(), channels.end(), [&](const auto& one) { return one.first == sensor; });
    return found == channels.end() ? nullptr : &found->second;
  };
  const FourPost* const sines = study.study.experiments.Find<FourPost>();
  if (sines != nullptr)
    if (const ChannelSource* const source = named(sines->plan.channels)) return source;
  const TimeHistories* const histories = study.study.experiments.Find<TimeHistories>();
  if (histories != nullptr)
    for (const StudyHistory& history : histories->plan.histories)
      if (const ChannelSource* const source = named(history.channels)) return source;
  return nullptr;
}

int LineOf(const LoadedStudy& study, const Suspicion& suspicion) {
  const ChannelSource* const source = SourceOf(study, suspicion.fault.name.substr(0, suspicion.fault.name.find(' ')));
  return source == nullptr ? 0 : source->line;
}

/// What to write for another sign or a delay.
std::string Correction(const LoadedStudy& study, const Suspicion& suspicion) {
  const bool is_delay = suspicion.fault.kind == Kind::kDelay;
  const double delay_s = 1e-3 * AtDigits(kMilli * suspicion.size, 2);
  const ChannelSource* const found = SourceOf(study, suspicion.fault.name);
  if (found == nullptr)
    return is_delay ? "`delay: " + ShortNumber(kMilli * delay_s, 2) +
                          " ms` at each of these channels, or under 'with' at their file"
                    : std::string("`sign: -1` at each of these channels");
  ChannelSource source = *found;
  for (SourceChannel& channel : source.channels) {
    if (is_delay) channel.delay_s += delay_s;
    else channel.factor = -channel.factor;
  }
  return "'" + suspicion.fault.name + ": " + SourceText(source) + "'";
}

/// Where channels of stepped sines and histories stand; empty where a table of responses is among them, which takes no
/// unit from the study.
std::vector<std::filesystem::path> RecordedFiles(const LoadedStudy& study) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const auto& recording) {
    files.push_back(recording.file);
    for (const OtherFile& other : recording.preparation.others) files.push_back(other.path);
  };
  if (const FourPost* const sines = study.study.experiments.Find<FourPost>())
    for (const StudyRecording& recording : sines->plan.recordings) {
      if (!IsOverTime(recording)) return {};
      add(recording);
    }
  if (const TimeHistories* const histories = study.study.experiments.Find<TimeHistories>())
    for (const StudyHistory& history : histories->plan.histories) add(history);
  return files;
}

/// What to write where readings are a unit's factor from the truth.
std::string UnitCorrection(const LoadedStudy& study, const Suspicion& suspicion) {
  const double factor = FactorOf(suspicion.size);
  const KnownFactor* const known = KnownOf(factor);
  const ChannelSource* const found = SourceOf(study, suspicion.fault.name);
  const std::vector<std::filesystem::path> files = RecordedFiles(study);
  if (found != nullptr && known->is_unit && !files.empty()) {
    const double times = std::abs(factor) > 1 ? 1 / known->factor : known->factor;
    if (const auto source = WithUnitOfTimes(*found, times, files))
      return "'" + suspicion.fault.name + ": " + SourceText(*source) + "'";
  }
  return "the unit or the scale of what was recorded";
}

std::string Sure(const Suspicion& suspicion) {
  const std::string sure = ShortNumber(std::sqrt(suspicion.score), 2) + " sd, ";
  if (!(suspicion.next_score > 0)) return sure + "nothing else explains it";
  return sure + "the next best explanation " + ShortNumber(std::sqrt(suspicion.next_score), 2) + " sd";
}

/// What an audit calls the instruments that a calibration is of.
std::string GroupName(const std::string& calibrated) {
  if (calibrated == "load_cells") return "load cells";
  return calibrated;
}

/// The checks of the recordings say the same, with the same mass.
bool HasWheelpanFinding(const Diagnostics& found) {
  return std::any_of(found.items().begin(), found.items().end(), [](const Diagnostic& finding) {
    return finding.id == kWheelpanForgotten.id() || finding.id == kWheelpanTakenOut.id();
  });
}

/// Whether the study states a calibration that allows for it: the fit then knows.
bool IsStated(const LoadedStudy& study, const Suspicion& suspicion) {
  // As far as a calibration may be off without a warning.
  constexpr double kAllowed = 2.5;
  const RigFault& fault = suspicion.fault;
  const std::string group = fault.name.starts_with("all ") ? fault.name.substr(4) : fault.name;
  return std::any_of(
      study.study.calibrations.begin(), study.study.calibrations.end(), [&](const Calibration& calibration) {
        const bool is_kind = (fault.kind == Kind::kScale && calibration.kind == Calibration::Kind::kGain) ||
                             (fault.kind == Kind::kDelay && calibration.kind == Calibration::Kind::kDelay);
        return is_kind && GroupName(calibration.of) == group &&
               std::abs(CountedSize(fault, suspicion.size)) <= kAllowed * calibration.sd;
      });
}

/// What is left over says more of noise that nobody knows than its usual share.
AuditSubject WithLessNoise(AuditSubject subject, double share) {
  constexpr double kLeast = 0.3;
  for (AuditedRun& run : subject.runs)
    if (!run.is_noise_known) run.motion_sd *= std::max(kLeast, share);
  return subject;
}

}  // namespace

std::optional<Audit> AuditStudy(const LoadedStudy& study) {
  const Experiments& experiments = study.study.experiments;
  if (std::none_of(experiments.begin(), experiments.end(), [](const Experiment& one) { return one.IsAudited(); }))
    return std::nullopt;
  AuditedVehicle audited(study.MakeSubject());
  for (const Experiment& experiment : experiments) experiment.AddRecordings(audited);
  Audit audit = AuditRig(audited.audited());
  if (audit.is_noise_known || !audit.is_redundant || audit.misfit >= 1) return audit;
  return AuditRig(WithLessNoise(audited.audited(), audit.misfit));
}

void ReportAudit(const LoadedStudy& study, const Audit& audit, Severity certain, Diagnostics& diagnostics) {
  for (const Suspicion& suspicion : audit.suspicions) {
    if (IsStated(study, suspicion)) continue;
    const Finding& kind = KindOf(suspicion.fault, suspicion.size);
    const Place place{.file = study.study.file.string(), .line = LineOf(study, suspicion)};
    const bool is_wheelpan = suspicion.fault.kind == Kind::kWheelpan;
    if (is_wheelpan && HasWheelpanFinding(diagnostics)) continue;
    std::vector<std::string> words = {is_wheelpan ? WheelpanWords(suspicion) : Words(suspicion.fault, suspicion.size),
                                      RivalWords(suspicion), Sure(suspicion)};
    if (&kind == &kRigUnit) {
      words.emplace_back(KnownOf(FactorOf(suspicion.size))->words);
      words.push_back(UnitCorrection(study, suspicion));
    }
    if (&kind == &kRigSign || &kind == &kRigDelay) words.push_back(Correction(study, suspicion));
    if (IsError(suspicion.fault, suspicion.size) && (certain == Severity::kWarning || !IsCertain(suspicion)))
      diagnostics.ReportAsWarning(kind, place, words);
    else diagnostics.Report(kind, place, words);
  }
  if (audit.is_noise_known && audit.misfit > kContradiction)
    diagnostics.Report(kRigContradiction, {.file = study.study.file.string()}, {ShortNumber(audit.misfit, 2)});
}

bool ContradictsAnAudit(const Diagnostic& finding) {
  return finding.id == kPostsMoveOtherwise.id() || finding.id == kRigAmplitude.id() ||
         finding.id == kSineThousandfold.id();
}

std::string NoAuditText(const LoadedStudy& study, const Diagnostics& findings) {
  const std::vector<Diagnostic>& all = findings.items();
  if (const auto found = std::find_if(all.begin(), all.end(), ContradictsAnAudit); found != all.end())
    return "no audit of the rig: it takes amplitudes and motions of posts as stated, and they are not; correct [" +
           found->id + "] first\n";
  const TimeHistories* const histories = study.study.experiments.Find<TimeHistories>();
  std::string unfit;
  for (std::size_t h = 0; histories != nullptr && h < histories->fitted.size(); ++h) {
    const MeasuredHistory& history = histories->fitted[h];
    const double measured_s = static_cast<double>(history.LongestMeasured().count) / history.rate_Hz;
    unfit += (unfit.empty() ? "'" : ", '") + history.name + "' " +
             (history.release ? "begins with a release" : "has " + ShortNumber(measured_s, 2) + " s without a gap");
  }
  if (unfit.empty())
    return "no audit of the rig: it compares channels of stepped sines and of time histories, and this study fits "
           "neither; look at each file by `fourpost info FILE`\n";
  return "no audit of the rig: it needs eight seconds without a gap in which posts move, or stepped sines: " + unfit +
         "; record such a motion\n";
}

}  // namespace fourpost
