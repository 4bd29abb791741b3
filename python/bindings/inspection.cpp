#include <fourpost/frf.h>
#include <fourpost/info.h>

#include "python/bindings/bindings.h"
#include "python/bindings/calls.h"

namespace fourpost::python {
namespace {

py::tuple Describe(const std::filesystem::path& file) {
  const api::Info info = Computed([&](const Stop&) { return api::Describe(file); });
  return py::make_tuple(info.json, info.text, FindingsOf(info.warnings));
}

py::tuple TupleOf(const api::MeasuredChannel& channel) {
  return py::make_tuple(channel.name, channel.unit, channel.frf, channel.gain_sd, channel.phase_sd_rad, channel.mean,
                        channel.mean_sd, channel.second_harmonic, channel.coherence);
}

py::tuple TupleOf(const api::MeasuredPattern& pattern) {
  py::list channels;
  for (const api::MeasuredChannel& channel : pattern.channels) channels.append(TupleOf(channel));
  return py::make_tuple(pattern.name, pattern.posts, pattern.reference, pattern.off_pattern, pattern.frequency_Hz,
                        pattern.amplitude_m, pattern.repeats, channels);
}

py::tuple MeasureFrf(const std::vector<std::filesystem::path>& files, const std::map<std::string, std::string>& posts,
                     const std::string& reference, const std::string& kind,
                     const std::optional<std::pair<int, double>>& filter, const std::vector<double>& frequency_Hz,
                     const std::vector<std::pair<std::filesystem::path, double>>& beside,
                     const std::filesystem::path& output) {
  api::FrfOptions options{.posts = posts,
                          .reference = reference,
                          .kind = kind,
                          .frequency_Hz = frequency_Hz,
                          .beside = beside,
                          .output = output};
  if (filter) options.filter = api::LowPass{filter->first, filter->second};
  const api::FrfMeasurement found = Computed([&](const Stop&) { return api::MeasureFrf(files, options); });
  py::list patterns;
  for (const api::MeasuredPattern& pattern : found.patterns) patterns.append(TupleOf(pattern));
  return py::make_tuple(found.kind, found.rate_Hz, found.duration_s, patterns, found.left_out, found.json, found.text,
                        found.study_section, FindingsOf(found.warnings));
}

}  // namespace

void BindInspection(py::module_& module) {
  module.def("describe", &Describe);
  module.def("measure_frf", &MeasureFrf);
}

}  // namespace fourpost::python
