#include <cmath>

#include <Eigen/Geometry>

#include "analysis/text/number.h"
#include "vehicles/templates/axle_writer.h"

namespace fourpost {
namespace {

/// Two digits, three where the first is a one.
double TwoDigits(double value) {
  const double size = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::round(value / size) * size;
}

std::string InMm(double metres) { return FormatNumber(std::round(metres * 1e3)) + " mm"; }

}  // namespace

void AxleWriter::Struts() { StrutOf("spring_top", "spring_bottom", CarrierOf("spring_bottom")); }

void AxleWriter::StrutOf(std::string_view top, std::string_view bottom, std::string_view part) {
  const std::string on_body = Frame("body", top);
  CoilAndDamper(on_body, Frame(part, bottom));
  AntiRollBar();
  Tyre();
  Sensors();
}

void AxleWriter::CoilAndDamper(const std::string& top, const std::string& bottom) {
  const std::string rate = "k_" + points_.axle;
  const std::string law = guess_.known.spring ? guess_.known.spring->tags : "<linear stiffness=\"$" + rate + "\"/>";
  text_ += "  <fp:spring name=\"" + Name(points_.kind->spring) + "\" parent=\"" + top + "\" child=\"" + bottom +
           "\">\n    " + law + "\n  </fp:spring>\n";
  if (!points_.kind->Find("damper_top") || !points_.Has("damper_top")) {
    Damper(top, bottom);
    Stops(top, bottom);
  } else {
    const std::string damper_top = Frame("body", "damper_top");
    const std::string damper_bottom = Frame(CarrierOf("damper_bottom"), "damper_bottom");
    Damper(damper_top, damper_bottom);
    // A model states stops with the spring.
    if (guess_.known.spring) Stops(top, bottom);
    else Stops(damper_top, damper_bottom);
  }
  AddRates();
}

void AxleWriter::Damper(const std::string& top, const std::string& bottom) {
  damper_top_ = top;
  damper_bottom_ = bottom;
  const std::string c = "c_" + points_.axle;
  const std::string law = guess_.known.damper ? guess_.known.damper->tags
                                              : "<bilinear bump=\"$" + c + "_bump\" rebound=\"$" + c + "_rebound\"/>";
  text_ += "  <fp:damper name=\"" + Name("damper") + "\" parent=\"" + top + "\" child=\"" + bottom + "\">\n    " + law +
           "\n  </fp:damper>\n";
}

void AxleWriter::Friction(std::string_view name, const std::string& top, const std::string& bottom,
                          const ParameterText& force) {
  text_ += "  <fp:damper name=\"" + Name(name) + "\" parent=\"" + top + "\" child=\"" + bottom +
           "\">\n    <linear rate=\"0 N*s/m\"/>\n    <friction force=\"$" + force.name +
           "\" speed=\"2 mm/s\"/>\n  </fp:damper>\n";
  Add(force);
}

void AxleWriter::Stops(const std::string& top, const std::string& bottom) {
  // A model without stops has none.
  if (guess_.known.spring && !guess_.known.stops) return;
  const std::string law = guess_.known.stops
                              ? guess_.known.stops->tags
                              : "<bump gap=\"" + InMm(0.06 * guess_.damper_ratio) +
                                    "\" stiffness=\"50 N/mm\" cubic=\"0.5 N/mm^3\"/>\n    <rebound gap=\"" +
                                    InMm(0.07 * guess_.damper_ratio) + "\" stiffness=\"200 N/mm\"/>";
  text_ += "  <fp:stop name=\"" + Name("stops") + "\" parent=\"" + top + "\" child=\"" + bottom + "\">\n    " + law +
           "\n  </fp:stop>\n";
}

void AxleWriter::AddRates() {
  const KnownAxle& known = guess_.known;
  for (const auto* law : {&known.spring, &known.damper})
    for (const ParameterText& parameter : *law ? (*law)->parameters : std::vector<ParameterText>()) Add(parameter);
  if (!known.spring) AddSpringRate();
  if (!known.damper) AddDamperRates();
}

void AxleWriter::AddSpringRate() {
  const double k = TwoDigits(guess_.spring_rate * 1e-3);
  Add(ParameterText{.name = "k_" + points_.axle,
                    .value = k,
                    .lower = TwoDigits(0.5 * k),
                    .upper = TwoDigits(2 * k),
                    .precision = 0.01,
                    .unit = "N/mm",
                    .source = "estimate, one spring: a ride frequency of " +
                              std::string(points_.axle == "front" ? "1.2" : "1.4") + " Hz at a motion ratio of " +
                              FormatNumber(std::round(guess_.spring_ratio * 100), -2) +
                              "; passenger cars have 1 to 1.5 Hz (Gillespie 1992)"});
}

void AxleWriter::AddDamperRates() {
  const std::string c = "c_" + points_.axle;
  const double rate = guess_.damper_rate;
  const auto damper = [&](const char* direction, double share) {
    const double value = TwoDigits(share * rate);
    Add(ParameterText{.name = c + "_" + direction,
                      .value = value,
                      .lower = TwoDigits(0.3 * value),
                      .upper = TwoDigits(3 * value),
                      .precision = 1,
                      .unit = "N*s/m",
                      .source = "estimate, one damper: a damping ratio of 0.3, twice as much in rebound as in bump"});
  };
  damper("bump", 2.0 / 3);
  damper("rebound", 4.0 / 3);
}

void AxleWriter::AntiRollBar() {
  if (!points_.kind->Find("bar_end") || !points_.Has("bar_end")) return;
  const std::string end = Frame("body", "bar_end");
  const std::string link = Frame(CarrierOf("drop_link"), "drop_link");
  const auto right = [](std::string name) { return name.replace(name.size() - 4, 4, "right"); };
  text_ += "  <fp:antiroll name=\"" + Name("bar", false) + "\" stiffness=\"$k_" + points_.axle +
           "_bar\">\n    <left parent=\"" + end + "\" child=\"" + link + "\"/>\n    <right parent=\"" + right(end) +
           "\" child=\"" + right(link) + "\"/>\n  </fp:antiroll>\n";
  if (guess_.known.bar_rate) return Add(*guess_.known.bar_rate);
  Add(ParameterText{.name = "k_" + points_.axle + "_bar",
                    .value = points_.axle == "front" ? 12.0 : 6.0,
                    .lower = 0,
                    .upper = 60,
                    .precision = 0.01,
                    .unit = "N/mm",
                    .source = "estimate: at one drop link, torsional rate over the square of the bar's arm"});
}

double AxleWriter::Radius() const {
  if (!points_.Has("wheel_axis")) return height_;
  const Eigen::Vector3d axis = (points_.At("wheel_axis") - points_.At("wheel_centre")).normalized();
  return height_ / std::hypot(axis.x(), axis.y());
}

void AxleWriter::Tyre() {
  const std::string part = points_.kind->is_beam ? "axle" : "wheel";
  const std::string kt = "kt_" + points_.axle;
  text_ += "  <fp:tyre name=\"" + Name("tyre") + "\" link=\"" + Full(part) + "\" xyz=\"" +
           XyzText(points_.At("wheel_centre") - parts_.find(part)->second.origin) + "\" radius=\"" +
           FormatNumber(std::round(Radius() * 1e9), -9) + " m\" stiffness=\"$" + kt + "\" damping=\"" +
           FormatNumber(guess_.known.tyre_damping.value_or(100)) +
           " N*s/m\"\n           lateral=\"120 kN/m\" longitudinal=\"5 kN/m\" lateral_damping=\"500 "
           "N*s/m\" longitudinal_damping=\"300 N*s/m\"/>\n  <fp:post name=\"" +
           Name("post") + "\" under=\"" + Name("tyre") + "\"/>\n";
  if (guess_.known.tyre_rate) return Add(*guess_.known.tyre_rate);
  Add(ParameterText{.name = kt,
                    .value = 200,
                    .lower = 120,
                    .upper = 350,
                    .precision = 0.1,
                    .unit = "N/mm",
                    .source = "estimate, one tyre: 150 to 250 N/mm are usual of passenger cars"});
}

void AxleWriter::Sensors() {
  const Eigen::Vector3d& centre = points_.At("wheel_centre");
  const auto accelerometer = [&](const std::string& name, const std::string& link, const Eigen::Vector3d& xyz) {
    return "  <fp:sensor name=\"" + name + "\" type=\"accelerometer\" link=\"" + link + "\" xyz=\"" + XyzText(xyz) +
           "\"/>\n";
  };
  text_ += accelerometer("a_body_" + points_.axle + "_left", "body", {centre.x(), 0.6 * centre.y(), centre.z() + 0.3});
  const std::string part = points_.kind->is_beam ? "axle" : "wheel";
  text_ +=
      accelerometer("a_" + part + "_" + points_.axle + "_left", Full(part), centre - parts_.find(part)->second.origin);
  text_ += "  <fp:sensor name=\"s_damper_" + points_.axle + "_left\" type=\"strut\" parent=\"" + damper_top_ +
           "\" child=\"" + damper_bottom_ + "\"/>\n";
  text_ +=
      "  <fp:sensor name=\"F_post_" + points_.axle + "_left\" type=\"load_cell\" tyre=\"" + Name("tyre") + "\"/>\n";
}

}  // namespace fourpost
