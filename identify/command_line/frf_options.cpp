#include "identify/command_line/frf_options.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "analysis/signals/frequency_grid.h"
#include "analysis/text/units.h"
#include "identify/command_line/common_options.h"
#include "identify/command_line/post_option.h"
#include "identify/command_line/unit_option.h"
#include "vehicles/requests/option_quantity.h"

namespace fourpost {
namespace {

/// In the order of ExcitationKind, then what lets the program choose.
constexpr std::array<std::string_view, 5> kKinds = {"stepped", "sweep", "random", "multisine", "auto"};

std::optional<ExcitationKind> KindNamed(const std::string& text) {
  for (std::size_t kind = 0; kind + 1 < kKinds.size(); ++kind)
    if (text == kKinds[kind]) return static_cast<ExcitationKind>(kind);
  return std::nullopt;
}

/// "pots.csv", "pots.csv=3ms", "run=2.csv", "run=2.csv=3ms": what follows the last sign is a delay if it is a time, or
/// if a file of the name before it exists, whose delay then is at fault.
void AddBeside(const std::string& text, FrfCommand& command) {
  OtherFile other{.path = text};
  if (const std::size_t sign = text.rfind('='); sign != std::string::npos) {
    Diagnostics faults;
    const std::optional<double> delay_s = ReadQuantity(text.substr(sign + 1), kTime, "--with", faults);
    const std::filesystem::path before = text.substr(0, sign);
    if (delay_s) other = {.path = before, .delay_s = *delay_s};
    else if (!std::filesystem::exists(text) && std::filesystem::exists(before)) command.faults.Add(faults);
  }
  command.request.preparation.times.others.push_back(std::move(other));
}

AcquisitionFilter& FilterOf(FrfCommand& command) {
  if (!command.request.filter) command.request.filter.emplace();
  return *command.request.filter;
}

void AddFilter(CLI::App& app, FrfCommand& command) {
  CLI::Option* filter = app.add_option_function<std::string>(
      "--filter",
      [&command](const std::string& text) {
        if (const auto cutoff_Hz = ReadQuantity(text, kFrequency, "--filter", command.faults))
          FilterOf(command).cutoff_Hz = *cutoff_Hz;
      },
      "Cut-off frequency of the Butterworth low-pass that all channels have passed: it is taken off the posts' "
      "amplitudes and off harmonics");
  app.add_option_function<int>(
         "--order", [&command](int order) { FilterOf(command).order = order; }, "Order of that filter (default 4)")
      ->check(CLI::Range(1, 16))
      ->needs(filter);
}

/// Even times, and bridges over gaps.
void AddTimes(CLI::App& app, FrfCommand& command) {
  TimePreparation& times = command.request.preparation.times;
  app.add_option_function<std::string>(
      "--bridge",
      [&](const std::string& text) {
        if (const auto longest_s = ReadQuantity(text, kTime, "--bridge", command.faults)) times.bridge_s = *longest_s;
      },
      "Longest gap, of rows or of single fields, that is bridged by interpolation, e.g. 50ms (default: none)");
  app.add_option_function<std::string>(
      "--resample",
      [&](const std::string& text) { times.rate_Hz = ReadQuantity(text, kFrequency, "--resample", command.faults); },
      "Rate of even times that all channels are interpolated at, for recordings with jitter, e.g. 500Hz");
}

}  // namespace

void AddOptions(CLI::App& subcommand, FrfCommand& command) {
  subcommand
      .add_option("FILE", command.request.files,
                  "Time histories of one motion, with names and units (text, MAT, RPC III, UFF, TDMS, MDF, LVM, HDF5)")
      ->required();
  AddPostOption(
      subcommand, command.request.posts, command.faults,
      "channels named post_FL, FL and the like, or with words that mean a post, as 'Zyl VL' and 'actuator rear'");
  AddUnitOption(subcommand, command.request.preparation.units, command.faults);
  subcommand
      .add_option_function<std::vector<std::string>>(
          "--with",
          [&command](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) AddBeside(text, command);
          },
          "File of another recorder with channels of the same time, FILE or, where its clock is ahead, FILE=3ms; once "
          "for each file")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  AddTimes(subcommand, command);
  subcommand.add_option("--reference", command.request.reference,
                        "Post that responses are relative to (default: the first that moves most)");
  subcommand
      .add_option_function<std::string>(
          "--kind", [&command](const std::string& text) { command.request.kind = KindNamed(text); },
          "How the posts moved; auto finds it in their motion")
      ->check(OneOf("--kind", kKinds))
      ->default_str("auto");
  AddFilter(subcommand, command);
  subcommand.add_option_function<std::string>(
      "--frequencies",
      [&command](const std::string& text) {
        if (auto frequencies = ParseFrequencies(text, "--frequencies", command.faults))
          command.request.frequencies_Hz = *std::move(frequencies);
      },
      "Frequencies of the response, 0.5Hz:30Hz:64, 0.5Hz:30Hz:0.1Hz or a list (default: of sweeps and random motions "
      "64 "
      "in the band of the posts; of stepped sines those of the dwells that are found; state them where dwells are "
      "missed)");
  subcommand.add_option("-o,--output", command.output,
                        "Folder for each pattern's recording (heave.csv, heave.uff) and picture (heave.svg), "
                        "recordings.yaml, the part of a study that takes them, and frf.json");
  subcommand.add_flag("--json", command.json, "Print frf.json instead of tables");
}

}  // namespace fourpost
