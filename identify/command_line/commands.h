#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/measured_response/measured_response.h"
#include "analysis/text/diagnostics.h"
#include "identify/choice/run_choice.h"
#include "identify/plan/plan.h"
#include "identify/run/fit_run.h"
#include "identify/run/run_draws.h"
#include "identify/run/run_suggestions.h"
#include "vehicles/engine/steady_response.h"
#include "vehicles/requests/amplitude_limits.h"
#include "vehicles/requests/sweep.h"

namespace fourpost {

/// `fourpost init DIR`
struct InitCommand {
  std::filesystem::path folder;
  /// Recordings and the vehicle of a study to draft; empty: the starter study is written.
  std::vector<std::filesystem::path> from;
  std::filesystem::path vehicle;
  /// Units of channels in place of what the files have; and what is wrong with the options.
  std::vector<StatedUnit> units;
  /// Channels of posts, in place of what names say.
  std::vector<PostChannel> posts;
  Diagnostics faults;
  /// "front=macpherson"; empty: no vehicle is made of hard points.
  std::vector<std::string> suspension;
  /// Table of hard points; empty: plausible ones.
  std::filesystem::path points;
  /// "front=760kg"; empty: not known.
  std::vector<std::string> load;
  /// JSON file of a vehicle of Project Chrono; empty: none is read.
  std::filesystem::path chrono;
  /// Those of its tyres: one, or front and rear.
  std::vector<std::filesystem::path> tyres;
  /// Write over a vehicle that is there.
  bool replace = false;
  bool json = false;
};

/// `fourpost info FILE...`
struct InfoCommand {
  std::vector<std::filesystem::path> files;
  bool json = false;
};

/// `fourpost frf FILE...`
struct FrfCommand {
  ResponseRequest request;
  /// Empty: nothing is written.
  std::filesystem::path output;
  bool json = false;
  /// What is wrong with the values of options.
  Diagnostics faults;
};

/// `fourpost params MODEL`
struct ParamsCommand {
  std::filesystem::path model;
  bool json = false;
};

/// `fourpost check MODEL`
struct CheckCommand {
  std::filesystem::path model;
  bool json = false;
  /// "name=value"
  std::vector<std::string> set;
  /// Print the file with its defaults filled in, in place of the report.
  bool resolved = false;
};

/// `fourpost response MODEL` or `fourpost response STUDY`
struct ResponseCommand {
  /// A vehicle file or a study.
  std::filesystem::path input;
  bool json = false;
  /// Empty: kAuto.
  std::optional<Engine> engine;
  /// Empty: nothing is written.
  std::filesystem::path output;
  /// Of a vehicle.
  SweepText sweep;
  /// Of a vehicle: "name=value".
  std::vector<std::string> set;
  /// Options given that only a vehicle takes.
  std::vector<std::string> vehicle_options;
};

/// `fourpost modes MODEL`
struct ModesCommand {
  std::filesystem::path model;
  bool json = false;
  /// "name=value"
  std::vector<std::string> set;
  /// "name" or "name=first:last:count"
  std::vector<std::string> vary;
  /// Empty: nothing is written.
  std::filesystem::path output;
};

/// `fourpost kinematics MODEL`
struct KinematicsCommand {
  std::filesystem::path model;
  bool json = false;
  /// "name=value"
  std::vector<std::string> set;
  /// "80mm" or "-60mm:80mm"; empty: to the stops.
  std::string travel;
  std::string step = "10mm";
  /// Empty: nothing is written.
  std::filesystem::path output;
};

/// `fourpost settle MODEL`
struct SettleCommand {
  std::filesystem::path model;
  bool json = false;
  /// "name=value"
  std::vector<std::string> set;
  /// In the file at rest springs leave their preloads to equilibrium.
  bool equilibrium = false;
  /// "preload" or "free_length"; empty: the vehicle moves to its pose at rest.
  std::string hold;
  /// Empty: nothing is written.
  std::filesystem::path output;
};

/// `fourpost export MODEL` or `fourpost export RUN`
struct ExportCommand {
  /// A vehicle file, or the folder of a fit.
  std::filesystem::path input;
  /// "name=value"
  std::vector<std::string> set;
  bool json = false;
  /// Empty: nothing is written.
  std::filesystem::path output;
};

/// `fourpost view MODEL`
struct ViewCommand {
  /// A vehicle file, or the folder of a fit.
  std::filesystem::path input;
  /// Modes and frequencies of the posts.
  SweepText sweep;
  /// "name=value"
  std::vector<std::string> set;
  /// Empty: the file's name with another ending, in this folder.
  std::filesystem::path output;
  bool json = false;
};

/// `fourpost simulate MODEL`; SI.
struct SimulateCommand {
  enum class Motion { kSweep, kSine, kStep, kRandom, kRoad, kRecording };

  std::filesystem::path model;
  Motion motion = Motion::kSweep;
  /// Of a sweep, a sine (alike), or the band of a random motion or road.
  double first_Hz = 0.5;
  double last_Hz = 30;
  bool linear_sweep = false;
  /// Of a sweep or sine.
  LimitText limits;
  /// Of a step, or rms of a random motion.
  double height_m = 0;
  double rise_s = 0.05;
  std::string road_class;
  /// Of the vehicle.
  double speed = 0;
  std::filesystem::path recording;
  /// See ReadPostShape.
  std::string mode = "heave";
  /// In place of the motion's own.
  std::optional<double> duration_s;
  double rate_Hz = 500;
  /// All when empty.
  std::vector<std::string> channels;
  /// "name=value".
  std::vector<std::string> set;
  std::optional<double> filter_Hz;
  int filter_order = 4;
  double noise = 0;
  std::uint64_t seed = 1;
  std::string stroke;
  /// Of each channel's rms.
  double error = 1e-3;
  Engine engine = Engine::kAuto;
  /// stdout when empty.
  std::filesystem::path output;
  /// None when empty.
  std::filesystem::path chart;
  bool json = false;
  /// What is wrong with the values of options.
  Diagnostics faults;
};

/// `fourpost ride MODEL` or `fourpost ride RUN`
struct RideCommand {
  /// The vehicle, or the folder of a fit, and how its posts move unless on roads.
  SimulateCommand drive;
  /// Classes and speeds; empty: another motion.
  std::vector<std::string> roads;
  std::vector<std::string> speeds;
  /// Roads by time histories too.
  bool over_time = false;
  /// "name=link:x,y,z"
  std::vector<std::string> points;
  /// "point=Wb"
  std::vector<std::string> weightings;
  /// Empty: nothing is written.
  std::filesystem::path output;
  bool json = false;
};

/// `fourpost fit STUDY -o DIR`
struct FitCommand : FitRequest {
  FitCommand() { name_missing = true; }

  bool json = false;
  /// Add to the vehicle what lowers BIC, step by step.
  bool grow = false;
  /// Keep a page of how it gets on.
  bool watch = false;
};

/// `fourpost predict RUN --recording FILE`
struct PredictCommand {
  /// The folder of a fit.
  std::filesystem::path run;
  std::filesystem::path recording;
  /// Of a stepped sine, see ReadPostShape; empty: the pattern that fits best.
  std::string mode;
  /// "250 kg", and "X,Y,Z" in metres where it is; empty: none.
  std::string add_mass;
  std::string at;
  /// A Kalman filter's one-step predictions as well; its noise estimated on this recording, empty: as the fit held it.
  bool kalman = false;
  std::filesystem::path noise_from;
  /// Of the study's control.
  std::optional<double> setting;
  /// See ParseRelease(), and when; empty: as the study.
  std::string release;
  std::optional<double> start_s;
  /// Of a time history; empty: kAuto.
  std::optional<Engine> engine;
  Diagnostics faults = {};
  bool json = false;
  /// Empty: nothing is written.
  std::filesystem::path output;
};

/// `fourpost report RUN...`
struct ReportCommand {
  /// Folders of fits; several: a page that compares them.
  std::vector<std::filesystem::path> runs;
  /// report.html in the run's folder when empty; of several runs always given.
  std::filesystem::path output;
  bool json = false;
};

/// `fourpost compare STUDY --methods a,b --runs N --seed S`
struct CompareCommand {
  std::filesystem::path study;
  std::vector<std::string> methods = {"dvhde", "thesis", "de", "simplex", "gb"};
  int runs = 20;
  std::uint64_t seed = 1;
  /// 0: one per processor.
  int threads = 0;
  /// At most, of each run; empty: what the study says.
  std::optional<std::int64_t> evaluations;
  /// How far above the best of all runs counts as solved, "0.01 %"; empty: 1 %.
  std::string near_best;
  /// Of evaluations, shared by all runs; empty: nothing is kept.
  std::filesystem::path archive;
  /// Report processor time.
  bool time = false;
  /// HTML file; empty: none is written.
  std::filesystem::path output;
  bool json = false;
};

/// `fourpost draws RUN`
struct DrawsCommand : DrawRequest {
  /// CSV on stdout when empty.
  std::filesystem::path output;
  bool json = false;
};

/// `fourpost suggest RUN`
struct SuggestCommand : SuggestRequest {
  /// Number of a suggestion to write into `output`; 0: none.
  std::size_t apply = 0;
  std::filesystem::path output;
  bool json = false;
  /// List those that do not lower BIC as well.
  bool all = false;
};

/// `fourpost choose RUN --settings FILE`
struct ChooseCommand : RunChoiceRequest {
  /// Empty: nothing is written.
  std::filesystem::path output;
  bool json = false;
};

/// `fourpost plan RUN`
struct PlanCommand : PlanRequest {
  std::string time;
  /// Empty: nothing is written.
  std::filesystem::path output;
  bool json = false;
};

/// `fourpost batch PLAN -o DIR`; what its values may be is known to the Python package that runs it.
struct BatchCommand {
  std::filesystem::path plan;
  std::filesystem::path output;
  std::string on = "local";
  /// 0: as many as there are processors, or as the other side has.
  int workers = 0;
  int tries = 10;
  std::string slurm;
  bool ship = false;
  bool list = false;
  bool unpack = false;
  /// A file that `--on slurm` wrote; empty: the plan is run.
  std::filesystem::path task;
  bool json = false;
};

/// `fourpost rank RUN...`
struct RankCommand {
  /// Folders of fits.
  std::vector<std::filesystem::path> runs;
  bool json = false;
};

// Each prints its result on stdout, all else on stderr, and returns an ExitCode. They throw FaultyInput for a user's
// file or option that cannot be used, OutputError for a result that cannot be written.

int Run(const InitCommand& command);
int Run(const InfoCommand& command);
int Run(const FrfCommand& command);
int Run(const ParamsCommand& command);
int Run(const CheckCommand& command);
int Run(const ResponseCommand& command);
int Run(const SimulateCommand& command);
int Run(const RideCommand& command);
int Run(const ModesCommand& command);
int Run(const KinematicsCommand& command);
int Run(const SettleCommand& command);
int Run(const ExportCommand& command);
int Run(const ViewCommand& command);
int Run(const FitCommand& command);
int Run(const PredictCommand& command);
int Run(const ReportCommand& command);
int Run(const CompareCommand& command);
int Run(const RankCommand& command);
int Run(const DrawsCommand& command);
int Run(const SuggestCommand& command);
int Run(const ChooseCommand& command);
int Run(const PlanCommand& command);
int Run(const BatchCommand& command);

}  // namespace fourpost
