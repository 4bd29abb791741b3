#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a batch: its plan, its units, and the workers that run them. Those below the first four are
// reported by the Python package `fourpost_batch`, whose findings.py has the same words.
namespace fourpost {

inline const Finding kBatchWithoutPlan{"batch-without-plan", Severity::kError, "no plan is given",
                                       "name a file of units to run, see docs/batch.md"};
inline const Finding kBatchWithoutOutput{"batch-without-output", Severity::kError, "no folder for the results is given",
                                         "name one by -o, or see the units alone by --list"};
inline const Finding kBatchWithoutPackage{"batch-without-package", Severity::kError,
                                          "the Python package of this command is not in '{}'",
                                          "build or install the program with it, see docs/batch.md"};
inline const Finding kBatchWithoutPython{"batch-without-python", Severity::kError, "'{}' does not start: {}",
                                         "install python3, or name one by the variable FOURPOST_PYTHON"};

// Packages of Python.

inline const Finding kBatchLacksPackage{"batch-lacks-package", Severity::kError,
                                        "this needs {}, which {} does not have", "install it: {}"};

// The plan.

inline const Finding kBatchPlanMalformed{"batch-plan-malformed", Severity::kError, "not a plan: {}",
                                         "see docs/batch.md for its keys"};
inline const Finding kBatchKeyUnknown{"batch-key-unknown", Severity::kError, "unknown key '{}'{}",
                                      "the keys here are {}"};
inline const Finding kBatchKeyMissing{"batch-key-missing", Severity::kError, "'{}' is missing", "{}"};
inline const Finding kBatchValueWrong{"batch-value-wrong", Severity::kError, "'{}' cannot be {}", "{}"};
inline const Finding kBatchFileMissing{"batch-file-missing", Severity::kError, "no file '{}'{}",
                                       "paths are relative to the plan's folder"};
inline const Finding kBatchFileRefused{"batch-file-refused", Severity::kError, "'{}' cannot be read: {}",
                                       "see what `fourpost info` says of it"};
inline const Finding kBatchRecordingUnlike{"batch-recording-unlike", Severity::kError,
                                           "the study of '{}' and its vehicle name none of the channels of '{}'",
                                           "give a recording in the layout of those that are fitted; this one has {}"};
inline const Finding kBatchFileChanges{"batch-file-changes", Severity::kError, "'{}' changes while the batch reads it",
                                       "run the batch again"};
inline const Finding kBatchNameTwice{"batch-name-twice", Severity::kError, "two units have the name '{}'",
                                     "give entries names of their own by 'name'"};
inline const Finding kBatchRunUnknown{"batch-run-unknown", Severity::kError, "no fit of this plan has the name '{}'{}",
                                      "name one of {}, or a folder of a fit by 'run'"};
inline const Finding kBatchRunOfOtherVersion{"batch-run-of-other-version", Severity::kError,
                                             "'{}' is a fit of fourpost {}, and this is {}",
                                             "fit again, best as an entry of 'fits'"};
inline const Finding kBatchEmpty{"batch-empty", Severity::kError, "the plan has no units", "add 'fits' for example"};

// Where units run.

inline const Finding kBatchPlaceUnknown{"batch-place-unknown", Severity::kError, "'{}' is not a place to run units{}",
                                        "write one of local, dask://HOST:PORT, dask:FILE, slurm, launcher"};
inline const Finding kBatchSchedulerAway{"batch-scheduler-away", Severity::kError,
                                         "the scheduler {} does not answer: {}",
                                         "start it and run the batch again; results so far are kept"};
inline const Finding kBatchSlurmRefuses{
    "batch-slurm-refuses", Severity::kError, "Slurm refuses the array: {}",
    "correct the options of --slurm and run the batch again; results so far are kept"};
inline const Finding kBatchNoWorkers{"batch-no-workers", Severity::kError, "no worker of {} takes units",
                                     "start workers of this build of fourpost and run the batch again"};
inline const Finding kBatchLauncherUnknown{"batch-launcher-unknown", Severity::kError,
                                           "nothing says which of how many workers this is",
                                           "start it by mpirun or srun, or set FOURPOST_BATCH_SHARE to 0/8 to 7/8"};

// Workers and units.

inline const Finding kBatchWorkerOfOtherBuild{"batch-worker-of-other-build", Severity::kWarning,
                                              "the worker {} is refused: it has {}, and the plan is of {}",
                                              "install the same build there"};
inline const Finding kBatchWorkerLacksFiles{"batch-worker-lacks-files", Severity::kWarning,
                                            "the worker {} does not see {}",
                                            "let it share the folder of the batch, or run with --ship"};
inline const Finding kBatchWorkerLacksProgram{"batch-worker-lacks-program", Severity::kWarning,
                                              "the worker {} has no program fourpost ({})",
                                              "install it, or name it by the variable FOURPOST_PROGRAM"};
inline const Finding kBatchWorkerDiskFull{"batch-worker-disk-full", Severity::kWarning,
                                          "the worker {} cannot write to its disk: {}",
                                          "free space in its TMPDIR; its units run elsewhere or later"};
inline const Finding kBatchUnitLost{"batch-unit-lost", Severity::kError, "no result for {}: {}",
                                    "run the batch again; results so far are kept"};
inline const Finding kBatchUnitFailed{"batch-unit-failed", Severity::kError, "{} ended with code {}: {}",
                                      "correct the input and run the batch again"};
inline const Finding kBatchUnitDefect{
    "batch-unit-defect", Severity::kError, "{} met a defect of fourpost: {}",
    "report it with the input and {}, which keeps its output; another build runs it again"};
inline const Finding kBatchUnitBlocked{"batch-unit-blocked", Severity::kError, "{} cannot run, as '{}' has no fit",
                                       "see what is said of that one"};

// The folder.

inline const Finding kBatchFolderOther{"batch-folder-other", Severity::kError,
                                       "holds files that are not those of a batch", "name an empty or a new folder"};
inline const Finding kBatchCannotWrite{"batch-cannot-write", Severity::kError, "cannot write: {}",
                                       "free space and run the batch again; results so far are kept"};
inline const Finding kBatchResultDamaged{"batch-result-damaged", Severity::kWarning,
                                         "{} results were altered on disk and are computed again",
                                         "check the disk if that was nobody's intention"};

}  // namespace fourpost
