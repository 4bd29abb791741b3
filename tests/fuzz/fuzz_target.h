#pragma once

#include <string>

namespace fourpost {

// What is fuzzed, a function for each kind of file that a user gives or that fourpost wrote and reads again. Any bytes
// may come; each function throws std::logic_error, or what it does not expect, for a defect of fourpost.

/// As a vehicle file. What can be read must read back after a change of its parameters and with its defaults written
/// out, and its multibody system must be built and told of, or refused by a finding.
void FuzzVehicle(const std::string& bytes);

/// As a MAT file of versions 4 to 7: HDF5 is not ours to mend.
void FuzzMat(const std::string& bytes);

/// As a recording in text, by each of its readers.
void FuzzTable(const std::string& bytes);

/// As a recording of a measurement system, each by the reader of one format; see FuzzRecording(). HDF5 is not ours.
void FuzzRpc(const std::string& bytes);
void FuzzUniversal(const std::string& bytes);
void FuzzTdms(const std::string& bytes);
void FuzzMdf(const std::string& bytes);
void FuzzLvm(const std::string& bytes);

/// As a file of a curve, of a spring, a damper and a bushing. What can be read rises from point to point.
void FuzzCurve(const std::string& bytes);

/// As files of a model of Project Chrono, behind a byte 0x1E each: vehicle.json, chassis.json, wishbones.json,
/// leaf.json, wheel.json and tyre.json, those of tests/data/chrono where they are empty. What can be read is written as
/// a vehicle that can be read, or refused by a finding.
void FuzzChrono(const std::string& bytes);

/// As a study beside a vehicle and a recording, which are read with it.
void FuzzStudy(const std::string& bytes);

/// As the files of a fit's folder: result.json and, behind a byte 0x1E each, response.csv, history.csv, motion.csv,
/// validation.csv, bench.csv and study.yaml. Their report and their comparison must be pages.
void FuzzResult(const std::string& bytes);

/// As archive.sqlite. What it answers must be what was put in, or nothing.
void FuzzArchive(const std::string& bytes);

/// Throws std::logic_error unless the claim holds.
void Require(bool condition, const std::string& claim, const std::string& details = "");

}  // namespace fourpost
