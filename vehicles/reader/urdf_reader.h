#pragma once

#include <filesystem>
#include <string>

#include "vehicles/description/vehicle.h"
#include "vehicles/reader/urdf_tree.h"
#include "vehicles/tags/file_faults.h"

namespace fourpost {

/// The mesh file of an attribute `filename`: an absolute path; relative ones start at the folder of the vehicle file.
std::filesystem::path MeshPath(const std::filesystem::path& vehicle_file, const std::string& filename);

/// Reports unreadable meshes, and warns of missing ones.
void CheckMeshes(const UrdfTree& tree, FileFaults& faults);

/// Fills the vehicle's links and joints with the result of urdfdom for the file's text. Messages of urdfdom are
/// reported; nothing is printed. The text must have passed the checks of tags and tree.
void ReadUrdf(const std::string& text, const UrdfTree& tree, Vehicle& vehicle, FileFaults& faults);

}  // namespace fourpost
