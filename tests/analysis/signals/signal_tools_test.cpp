// Against what scipy makes of the same signals, see reference/signal_tools.py.
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/files/csv.h"
#include "analysis/signals/deviation.h"
#include "analysis/signals/low_pass.h"
#include "analysis/signals/spectrum.h"

namespace fourpost::signal_tools_test {
namespace {

constexpr double kRate_Hz = 500;
/// Of numbers of size 1 after some thousand operations.
constexpr double kRounding = 1e-12;

class SignalTools : public testing::Test {
 protected:
  SignalTools() {
    Diagnostics diagnostics;
    const std::filesystem::path file = "tests/analysis/reference/signal_tools.csv";
    const auto table = ReadCsv(FOURPOST_SOURCE_DIR / file, diagnostics);
    for (std::size_t row = 0; table && row < table->rows(); ++row)
      reference_[table->Text(row, 0)].push_back(*table->Number(row, 2));
  }

  void Expect(const std::string& quantity, const std::vector<double>& values, double tolerance = kRounding) {
    const std::vector<double>& expected = reference_.at(quantity);
    ASSERT_EQ(values.size(), expected.size()) << quantity;
    for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(values[k], expected[k], tolerance) << quantity << k;
  }

  const std::vector<double>& x() { return reference_.at("x"); }
  const std::vector<double>& y() { return reference_.at("y"); }

  std::map<std::string, std::vector<double>> reference_;
};

TEST_F(SignalTools, HaveADeviation) { Expect("deviation", {DeviationOf(x())}); }

TEST_F(SignalTools, FilterCausally) {
  std::vector<double> causal = x();
  LowPass(4, 30, kRate_Hz).Apply(causal);
  Expect("causal", causal);
}

TEST_F(SignalTools, HavePowerOverFrequency) {
  const Spectrum spectrum = WelchSpectrum(x(), y(), kRate_Hz, 128);
  Expect("frequency", spectrum.frequency_Hz);
  Expect("density", spectrum.first);
  std::vector<double> real;
  std::vector<double> imaginary;
  for (const std::complex<double>& value : spectrum.cross) {
    real.push_back(value.real());
    imaginary.push_back(value.imag());
  }
  Expect("cross_real", real);
  Expect("cross_imag", imaginary);
  // Quotients of numbers down to 1e-6.
  Expect("coherence", spectrum.Coherence(), 1e-9);
  EXPECT_THROW(WelchSpectrum(x(), y(), kRate_Hz, 513), std::invalid_argument);
  EXPECT_THROW(WelchSpectrum(x(), std::vector<double>(3), kRate_Hz, 128), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::signal_tools_test
