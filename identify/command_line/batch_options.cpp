#include "identify/command_line/batch_options.h"

namespace fourpost {

void AddOptions(CLI::App& subcommand, BatchCommand& command) {
  CLI::Option* plan = subcommand.add_option("PLAN", command.plan,
                                            "Plan of fits, predictions, coverage, comparisons and choices (.yaml)");
  CLI::Option* output = subcommand.add_option("-o,--output", command.output,
                                              "Folder for results; what it holds already is not computed again");
  subcommand
      .add_option("--on", command.on,
                  "Where units run: local; dask://HOST:PORT, or dask:FILE of a scheduler; slurm; launcher, as one of "
                  "the workers that mpirun or srun start")
      ->capture_default_str();
  subcommand
      .add_option("--workers", command.workers,
                  "Units at a time: processes here (0: one per processor), tasks of a Slurm array (0: 100)")
      ->check(CLI::Range(0, 100000));
  subcommand
      .add_option("--tries", command.tries, "Give a unit up that lost its worker, or met a full disk, so many times")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  subcommand.add_option("--slurm", command.slurm, "Options for sbatch, such as \"-p long -t 2:00:00\"");
  subcommand.add_flag("--ship", command.ship, "Send the files of all units to Dask workers that do not see the folder");
  CLI::Option* list = subcommand.add_flag("--list", command.list, "List the units and which have results; run none");
  subcommand
      .add_flag("--unpack", command.unpack, "Write the files of each result into runs/NAME of the folder as well")
      ->excludes(list);
  subcommand.add_option("--task", command.task, "Run one task of a Slurm array, by a file that --on slurm wrote")
      ->excludes(plan)
      ->excludes(output)
      ->excludes(list);
  subcommand.add_flag("--json", command.json, "Print JSON instead of a table");
}

}  // namespace fourpost
