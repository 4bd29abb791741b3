#include "vehicles/reader/damper_text.h"

#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost::damper_text_test {
namespace {

using testing::HasSubstr;

TEST(DamperText, HasNumbersInPlaceOfParameters) {
  const Vehicle car = ShippedVehicle("quarter_car");
  std::vector<double> values = car.ParameterValues();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (car.parameters[i].name == "c_bump") values[i] = 1234.5;
  const std::string text = DamperText(car, "damper", values);
  EXPECT_THAT(text, HasSubstr(R"(<fp:damper name="damper" parent="strut_top" child="strut_bottom")"));
  EXPECT_THAT(text, HasSubstr(R"(<bilinear bump="1234.5 N*s/m" rebound="1500 N*s/m"/>)"));
}

// It reads where it is pasted, as the same law.
TEST(DamperText, MayBePasted) {
  const Vehicle car = ShippedVehicle("quarter_car");
  const std::string element = DamperText(car, "damper", car.ParameterValues());
  std::string text = car.text;
  const std::size_t begin = text.find("<fp:damper");
  const std::size_t end = text.find("</fp:damper>") + 12;
  text.replace(begin, end - begin, element);
  for (const char* name : {"c_bump", "c_rebound"}) {
    const std::size_t parameter = text.find("<fp:parameter name=\"" + std::string(name));
    text.erase(parameter, text.find("/>", parameter) + 2 - parameter);
  }
  Diagnostics diagnostics;
  const std::optional<Vehicle> pasted = ReadVehicleText(text, car.file, diagnostics);
  ASSERT_TRUE(pasted) << diagnostics.Format();
  EXPECT_EQ(pasted->dampers[0].law.At(pasted->ParameterValues()), car.dampers[0].law.At(car.ParameterValues()));
}

TEST(DamperText, RefusesAWrongNumberOfValues) {
  const Vehicle car = ShippedVehicle("quarter_car");
  EXPECT_THROW(DamperText(car, "damper", std::vector<double>(1)), std::invalid_argument);
  EXPECT_EQ(DamperText(car, "other", car.ParameterValues()), "");
}

}  // namespace
}  // namespace fourpost::damper_text_test
