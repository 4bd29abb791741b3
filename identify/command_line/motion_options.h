#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "analysis/text/units.h"
#include "identify/command_line/commands.h"

namespace fourpost {

/// Adds options whose values carry units; what cannot be read joins the command's faults.
class QuantityOptions {
 public:
  QuantityOptions(CLI::App& app, Diagnostics& faults) : app_(app), faults_(faults) {}

  CLI::Option* Add(const char* name, const Dimension& dimension, const char* help, std::function<void(double)> take);
  CLI::Option* AddShare(const char* name, const char* help, double& share);

 private:
  CLI::App& app_;
  Diagnostics& faults_;
};

/// The options of which one says what the posts do, in a group of their own.
struct MotionOptions {
  CLI::Option_group* group;
  CLI::Option* sweep;
  CLI::Option* sine;
  CLI::Option* step;
  CLI::Option* random;
  CLI::Option* recording;
};

/// Without roads; exactly one of the group is required.
MotionOptions AddMotions(CLI::App& app, SimulateCommand& command);

/// --road and --speed, one of each.
void AddRoad(const MotionOptions& motions, CLI::App& app, SimulateCommand& command);
/// --road and --speed, lists of both.
void AddRoads(const MotionOptions& motions, CLI::App& app, RideCommand& command);

/// What belongs to some of the motions only; after the roads.
void AddMotionDetails(CLI::App& app, SimulateCommand& command, const MotionOptions& motions);

}  // namespace fourpost
