#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "analysis/files/recording/recording_file.h"

namespace fourpost {

/// Opens an HDF5 file: datasets of real numbers with one dimension, and the columns of those with two, whose longer
/// side is time. Names are those of the datasets, or the attribute "names", "channels" or "columns"; units the
/// attribute "unit" or "units"; the step the attribute "dt", "wf_increment" or "delta_t" in s or "sample_rate",
/// "sampling_rate", "rate" or "fs" in Hz; else the times are a dataset "time" or "t" of the same group and length. The
/// HDF5 library runs in a process of its own, where what it cannot stand is a fault of the file. Throws RecordingFault.
std::unique_ptr<RecordingFile> OpenHdf5(const std::filesystem::path& file);

bool IsHdf5(std::string_view head);

/// Whether MATLAB wrote it, or a program that writes as it does: its variables have the attribute MATLAB_class.
bool IsOfMatlab(const std::filesystem::path& file);

}  // namespace fourpost
