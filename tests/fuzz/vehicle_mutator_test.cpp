// The mutator of vehicle files, without libFuzzer.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include "tests/temporary_folder.h"

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

/// libFuzzer's own: here it leaves the bytes as they are.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) { return size; }

namespace fourpost::vehicle_mutator_test {
namespace {

std::string Mutated(const std::string& text, std::size_t most, unsigned seed) {
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  bytes.resize(std::max(most, text.size()));
  const std::size_t size = LLVMFuzzerCustomMutator(bytes.data(), text.size(), most, seed);
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)};
}

TEST(VehicleMutator, ChangesVehiclesAndLeavesThemXml) {
  constexpr unsigned kSeeds = 200;
  const std::string car = ReadText(std::string(FOURPOST_SOURCE_DIR) + "/urdf/quarter_car.urdf");
  std::set<std::string> made;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    const std::string text = Mutated(car, 4 * car.size(), seed);
    tinyxml2::XMLDocument document;
    EXPECT_EQ(document.Parse(text.c_str(), text.size()), tinyxml2::XML_SUCCESS) << text;
    made.insert(text);
  }
  // Every fourth is left to libFuzzer.
  EXPECT_GT(made.size(), kSeeds / 2);
}

TEST(VehicleMutator, LeavesWhatIsNotXmlOrGrowsTooLargeToLibFuzzer) {
  EXPECT_EQ(Mutated("<robot", 100, 1), "<robot");
  EXPECT_LE(Mutated("<robot/>", 8, 1).size(), 8u);
}

}  // namespace
}  // namespace fourpost::vehicle_mutator_test
