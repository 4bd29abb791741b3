#pragma once

#include <cstddef>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/files/recorded_table.h"
#include "analysis/files/sha256.h"
#include "analysis/process/work_hooks.h"
#include "analysis/text/diagnostics.h"
#include "identify/experiments/subject.h"
#include "identify/residuals/error_share.h"
#include "identify/residuals/residual_block.h"
#include "identify/study_file/left_out_recording.h"
#include "vehicles/engine/engine.h"

namespace fourpost {

class AuditedVehicle;
struct FitResult;
struct ParameterSpread;

/// A file that a study names for an experiment.
struct ExperimentFile {
  enum class Use {
    /// A recording that is fitted; the study cannot do without it.
    kFitted,
    /// A recording that the fit does not see; a study stands without it.
    kValidation,
    /// Anything else.
    kOther,
  };
  std::filesystem::path path;
  /// Of the study.
  int line = 0;
  Use use = Use::kFitted;
};

/// What an experiment adds to the results of a fit or of `fourpost response STUDY`.
struct ExperimentResults {
  /// Tables for the terminal: of what was fitted, and of what a fit has not seen.
  std::string text = {};
  std::string unseen_text = {};
  /// Keys of result.json; lists of several experiments are joined.
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  /// Squares of the errors of all that was fitted, for the verdict.
  std::vector<ErrorShare> shares = {};
  /// `warnings` of result.json.
  Diagnostics findings = {};
  /// Names in the folder of the results, and what they hold.
  std::vector<std::pair<std::string, std::string>> files = {};
  /// False where an interruption left some recordings out.
  bool is_whole = true;
};

/// A recording that a fitted vehicle is to predict.
struct PredictionRequest {
  std::filesystem::path recording;
  /// The folder of the fit.
  std::filesystem::path run;
  /// Empty: Engine::kAuto.
  std::optional<Engine> engine = {};
  /// How the posts moved, see ReadPostShape; empty: to be found.
  std::string mode = {};
  /// One-step predictions of a Kalman filter as well, and where its noise is estimated; empty: as the fit held it.
  bool has_kalman = false;
  std::filesystem::path noise_from = {};
  /// How far the fitted parameters may be off, for bands; null where the run does not say.
  const ParameterSpread* spread = nullptr;
  /// Of a control that parameters follow.
  std::optional<double> setting = {};
  /// From where the vehicle is let go, see ParseRelease(), and when; empty: as the study states of its first history.
  std::string release = {};
  std::optional<double> start_s = {};
  /// Whether the results' files are wanted, which may take longer than the rest.
  bool has_files = false;
};

/// Refuses a release or a start, of experiments that have neither.
void RefuseRelease(const PredictionRequest& request);

/// One kind of test on a rig: as a study describes it, after Load() with its recordings. A new kind is a class of its
/// own and an entry in ExperimentKinds() of experiment_kinds.cpp. Not to be changed while its residuals are evaluated.
class Experiment {
 public:
  virtual ~Experiment() = default;
  virtual std::unique_ptr<Experiment> Clone() const = 0;

  virtual std::vector<ExperimentFile> Files() const = 0;

  /// Forgets recordings that the fit does not see; before Load().
  virtual void LeaveOutValidation() {}

  /// Settings of the study's control that the recordings to fit state.
  virtual std::vector<double> Settings() const { return {}; }

  /// Reads the recordings without a vehicle, for the sake of their faults.
  virtual void CheckFiles(Diagnostics&) const {}

  /// Reads the recordings and maps them to the vehicle. Adds every fault to `diagnostics`. Those of recordings for
  /// validation are warnings; these recordings are left out.
  virtual void Load(const Subject& subject, Diagnostics& diagnostics) = 0;
  const std::vector<LeftOutRecording>& left_out() const { return left_out_; }

  /// What the residuals depend on: recordings as the fit sees them, and settings.
  virtual void AddTo(Sha256& data, Sha256& settings) const = 0;

  /// Nothing where nothing is fitted. Throws FaultyInput when the vehicle cannot be assembled or held.
  virtual std::optional<ResidualBlock> Residuals(const Subject& subject) const = 0;
  /// The same before Prepare(), by a cost that needs no preparation.
  virtual std::optional<ResidualBlock> UnpreparedResiduals(const Subject& subject) const { return Residuals(subject); }
  /// Whether the residuals are weighed by noise, so that a fit has standard deviations.
  virtual bool HasDeviations() const { return true; }
  /// Whether its residuals are of steady motions, which are costly to find where friction yields elastically.
  virtual bool IsOfSteadyMotions() const { return false; }
  /// Whether forces are fitted, which give masses and rates their scale.
  virtual bool MeasuresForce() const = 0;

  /// Whether its residuals follow points that parameters move; else the points stay where the file has them.
  virtual bool FollowsPoints() const { return false; }

  /// Once before a fit, at the values of the vehicle's file. Throws FaultyInput.
  virtual void Prepare(const Subject&, const WorkHooks&) {}
  /// Plausibility of the recordings, as warnings; posts that certainly move otherwise than stated as `wrong_posts`.
  virtual void Check(const Subject&, Severity wrong_posts, Diagnostics&) const { (void)wrong_posts; }
  /// Its recordings for an audit of the rig, which needs no fit.
  virtual void AddRecordings(AuditedVehicle&) const {}
  /// Whether they are such that an audit is worth while.
  virtual bool IsAudited() const { return false; }
  /// Plausibility after a fit that was not interrupted, as warnings.
  virtual void CheckFit(const Subject&, const FitResult&, Diagnostics&) const {}

  enum class Geometry { kGood, kCorrectionDue, kInterrupted };
  /// Whether the full geometry differs from the model that was fitted so far that the fit has to go on from there,
  /// after Correct().
  virtual Geometry CheckGeometry(const Subject&, const std::vector<double>& values, const WorkHooks&) {
    (void)values;
    return Geometry::kGood;
  }
  virtual void Correct() {}
  /// As another one of the same study was by its last Correct(), with what its Prepare() found.
  virtual void CorrectAs(const Experiment&) {}

  virtual ExperimentResults Results(const Subject& subject, const FitResult& fit) const = 0;

  /// The vehicle as its file has it. Nothing where it was interrupted before there was anything.
  virtual std::optional<ExperimentResults> Respond(const Subject& subject, std::optional<Engine> engine,
                                                   const WorkHooks& hooks) const = 0;

  /// Of what kind they are, and how a table of one is known: "stepped sines, with a column 'frequency_Hz'"; empty of an
  /// experiment that predicts none.
  virtual std::string_view Recordings() const = 0;
  /// Whether such a table is a recording of this kind.
  virtual bool Reads(const RecordedTable& table) const = 0;
  /// How the vehicle predicts another recording of this kind. Nothing where it was interrupted. Throws FaultyInput.
  virtual std::optional<ExperimentResults> Predict(const Subject& subject, const PredictionRequest& request,
                                                   const WorkHooks& hooks) const = 0;

 protected:
  Experiment() = default;
  Experiment(const Experiment&) = default;
  Experiment& operator=(const Experiment&) = default;

  std::vector<LeftOutRecording> left_out_;
};

/// The experiments of a study, in the order in which their residuals stand.
class Experiments {
 public:
  template <typename Pointer, typename Value>
  struct Iterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = Value;
    using difference_type = std::ptrdiff_t;
    using pointer = Value*;
    using reference = Value&;

    Pointer at;
    Value& operator*() const { return **at; }
    Iterator& operator++() {
      ++at;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };
  auto begin() { return Iterator<std::unique_ptr<Experiment>*, Experiment>{all_.data()}; }
  auto end() { return Iterator<std::unique_ptr<Experiment>*, Experiment>{all_.data() + all_.size()}; }
  auto begin() const { return Iterator<const std::unique_ptr<Experiment>*, const Experiment>{all_.data()}; }
  auto end() const { return Iterator<const std::unique_ptr<Experiment>*, const Experiment>{all_.data() + all_.size()}; }

  Experiments() = default;
  Experiments(const Experiments& other) {
    for (const Experiment& one : other) Add(one.Clone());
  }
  Experiments(Experiments&&) = default;
  Experiments& operator=(Experiments other) noexcept {
    all_ = std::move(other.all_);
    return *this;
  }
  ~Experiments() = default;

  void Add(std::unique_ptr<Experiment> one) { all_.push_back(std::move(one)); }

  /// That of a kind; null where there is none.
  template <typename Kind>
  Kind* Find() {
    for (const auto& one : all_)
      if (auto* found = dynamic_cast<Kind*>(one.get())) return found;
    return nullptr;
  }
  template <typename Kind>
  const Kind* Find() const {
    return const_cast<Experiments*>(this)->Find<Kind>();
  }

 private:
  std::vector<std::unique_ptr<Experiment>> all_;
};

/// As `validation_left_out` lists it.
nlohmann::ordered_json LeftOutJson(const LeftOutRecording& recording);

/// Adds the keys of `part` to `whole`, lists behind those that are there.
void AddKeys(const nlohmann::ordered_json& part, nlohmann::ordered_json& whole);

/// Text, findings and files behind those that are there, and keys by AddKeys().
void AddResults(ExperimentResults part, ExperimentResults& whole);

}  // namespace fourpost
