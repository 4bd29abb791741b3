#pragma once

#include <filesystem>
#include <string>

namespace fourpost {

/// Of a file that is not there: ", did you mean 'car/stepped_sine.csv'?" to end a message with, the file or folder
/// beside it whose name is nearest; empty when none is near.
std::string DidYouMeanFile(const std::filesystem::path& missing);

}  // namespace fourpost
