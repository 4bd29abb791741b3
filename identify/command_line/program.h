#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include "identify/command_line/commands.h"

namespace fourpost {

/// All commands with their options, what was given for them, and what then is to be run. Help, completion of shells and
/// the manual page are made of the same descriptions.
class Program {
 public:
  Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  CLI::App& app() { return app_; }
  /// Of the program where `topic` is empty, else of a command, of all findings, or of the finding of this id. Throws
  /// FaultyInput for another topic.
  std::string HelpOn(const std::string& topic) const;
  /// Once the words have been parsed: runs the command given, see commands.h.
  int RunCommand() const { return run_(); }

 private:
  CLI::App* Add(const char* name, const char* help, const char* examples, std::function<int()> run);
  void AddInit();
  void AddInfo();
  void AddFrf();
  void AddCheck();
  void AddParams();
  void AddResponse();
  void AddModes();
  void AddSettle();
  void AddKinematics();
  void AddExport();
  void AddView();
  void AddSimulate();
  void AddRide();
  void AddFit();
  void AddPredict();
  void AddReport();
  void AddCompare();
  void AddRank();
  void AddDraws();
  void AddSuggest();
  void AddChoose();
  void AddPlan();
  void AddBatch();
  void AddCompletion();
  void AddMan();
  void AddHelp();

  CLI::App app_{"fourpost identifies vehicle suspension models from rig tests.", "fourpost"};
  std::function<int()> run_;
  InitCommand init_;
  InfoCommand info_;
  FrfCommand frf_;
  CheckCommand check_;
  ParamsCommand params_;
  ResponseCommand response_;
  ModesCommand modes_;
  SettleCommand settle_;
  KinematicsCommand kinematics_;
  ExportCommand export_;
  ViewCommand view_;
  SimulateCommand simulate_;
  RideCommand ride_;
  FitCommand fit_;
  PredictCommand predict_;
  ReportCommand report_;
  CompareCommand compare_;
  RankCommand rank_;
  DrawsCommand draws_;
  SuggestCommand suggest_;
  ChooseCommand choose_;
  PlanCommand plan_;
  BatchCommand batch_;
  std::string shell_;
  std::string topic_;
};

}  // namespace fourpost
