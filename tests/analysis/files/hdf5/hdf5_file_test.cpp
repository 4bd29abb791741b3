#include "analysis/files/hdf5/hdf5_file.h"

#include <hdf5.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/hdf5/findings.h"
#include "analysis/files/recorded_table.h"
#include "analysis/files/recording/findings.h"
#include "tests/analysis/files/byte_writer.h"
#include "tests/findings.h"

namespace fourpost::hdf5_file_test {
namespace {

using ::testing::ElementsAre;

/// A file that is written dataset by dataset.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& file)
      : file_(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  ~Writer() { H5Fclose(file_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void Group(const std::string& path) {
    H5Gclose(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }

  void Add(const std::string& path, const std::vector<hsize_t>& sides, const std::vector<double>& numbers,
           hid_t type = H5T_IEEE_F64LE) {
    const hid_t space = H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr);
    const hid_t set = H5Dcreate2(file_, path.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    H5Dclose(set);
    H5Sclose(space);
  }

  /// Of fixed length, or of any.
  void Text(const std::string& path, const std::string& name, const std::vector<std::string>& texts,
            bool is_variable = false) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, is_variable ? H5T_VARIABLE : 16);
    std::string fixed;
    std::vector<const char*> pointers;
    for (const std::string& text : texts) fixed += Padded(text, 16);
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    Attribute(path, name, type, type, texts.size(),
              is_variable ? static_cast<const void*>(pointers.data()) : fixed.data());
    H5Tclose(type);
  }
  void Number(const std::string& path, const std::string& name, double number) {
    Attribute(path, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 1, &number);
  }

 private:
  void Attribute(const std::string& path, const std::string& name, hid_t type, hid_t memory, hsize_t count,
                 const void* data) {
    const hid_t object = H5Oopen(file_, path.c_str(), H5P_DEFAULT);
    const hid_t space = count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr);
    const hid_t attribute = H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, memory, data);
    H5Aclose(attribute);
    H5Sclose(space);
    H5Oclose(object);
  }

  hid_t file_;
};

class Hdf5File : public ::testing::Test {
 protected:
  Recording Read() const { return OpenGood(path_)->ReadAll(); }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "run.h5";
};

TEST_F(Hdf5File, DatasetsHaveNamesUnitsRatesAndTimes) {
  {
    Writer file(path_);
    file.Group("/run");
    file.Add("/run/force", {3}, {1.5, 2.5, -3}, H5T_IEEE_F32BE);
    file.Text("/run/force", "unit", {"kN"});
    file.Number("/run/force", "sample_rate", 500);
    file.Add("/run/time", {2}, {0, 100});
    file.Text("/run/time", "units", {"ms"}, true);
    file.Add("/run/z", {2}, {7, 8}, H5T_STD_I16LE);
  }
  const Recording recording = Read();
  ASSERT_EQ(recording.channels.size(), 2);
  EXPECT_EQ(recording.channels[0].name, "force");
  EXPECT_EQ(recording.channels[0].group, "run");
  EXPECT_EQ(recording.channels[0].unit, "kN");
  EXPECT_EQ(recording.channels[0].step_s, 0.002);
  EXPECT_THAT(recording.channels[0].values, ElementsAre(1.5, 2.5, -3));
  EXPECT_THAT(recording.channels[1].values, ElementsAre(7, 8));
  EXPECT_THAT(recording.channels[1].times_s, ElementsAre(0, 0.1));
}

TEST_F(Hdf5File, ColumnsOfAMatrixAreChannelsAlongItsLongerSide) {
  for (const bool transposed : {false, true}) {
    {
      Writer file(path_);
      if (transposed) file.Add("/data", {2, 3}, {1, 2, 3, 10, 20, 30});
      else file.Add("/data", {3, 2}, {1, 10, 2, 20, 3, 30});
      file.Text("/data", "names", {"F", "z"}, transposed);
      file.Text("/data", "units", {"N", "mm"});
      file.Number("/data", "dt", 0.01);
    }
    const Recording recording = Read();
    ASSERT_EQ(recording.channels.size(), 2);
    EXPECT_EQ(recording.channels[1].name, "z");
    EXPECT_EQ(recording.channels[1].unit, "mm");
    EXPECT_THAT(recording.channels[0].values, ElementsAre(1, 2, 3));
    EXPECT_THAT(recording.channels[1].values, ElementsAre(10, 20, 30));
  }
}

TEST_F(Hdf5File, OfMatlabIsReadAsAMatFileWhateverItsName) {
  {
    Writer file(path_);
    file.Add("/F", {1, 3}, {1, 2, 3});
    file.Text("/F", "MATLAB_class", {"double"});
  }
  EXPECT_TRUE(IsOfMatlab(path_));
  Diagnostics diagnostics;
  const std::optional<RecordedTable> table = ReadRecordedTable(path_, diagnostics);
  ASSERT_TRUE(table) << diagnostics.Format();
  EXPECT_EQ(table->recording(), nullptr);
  EXPECT_EQ(table->Number(2, 0), 3);
}

TEST_F(Hdf5File, ThatIsDamagedIsRefused) {
  {
    Writer file(path_);
    file.Add("/F", {1000}, std::vector<double>(1000, 1.5));
  }
  const std::string whole = ReadText(path_);
  EXPECT_THAT(FaultsOfBytes(whole.substr(0, 600)), testing::Property(&Diagnostics::HasErrors, true));
  EXPECT_THAT(FaultsOfBytes(std::string("\x89HDF\r\n\x1A\n").append(500, 'x')),
              testing::Property(&Diagnostics::HasErrors, true));
}

TEST_F(Hdf5File, WithoutNumbersIsRefused) {
  { Writer(path_).Group("/run"); }
  Diagnostics diagnostics;
  EXPECT_FALSE(OpenRecording(path_, diagnostics));
  EXPECT_THAT(diagnostics, ReportsOnly(kRecordingNoChannel, 0, {"HDF5"}));
}

}  // namespace
}  // namespace fourpost::hdf5_file_test
