#include "identify/choice/car_metrics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Eigenvalues>

#include "identify/choice/findings.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/engine/history_solver.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/posts/road.h"
#include "vehicles/random_response/random_vehicle.h"
#include "vehicles/ride/named_modes.h"
#include "vehicles/ride/suspension.h"
#include "vehicles/ride_metrics/history_ride.h"
#include "vehicles/ride_metrics/road_ride.h"
#include "vehicles/ride_metrics/spectral_ride.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr const char* kComfort = "comfort";
constexpr const char* kGrip = "grip";
constexpr const char* kDampingEnd = ".damping";
/// Of the history's road: the car has settled after its beginning.
constexpr double kSettling_s = 3;
constexpr double kHistoryRate_Hz = 500;

bool EndsWithAnyOf(const std::string& name, std::initializer_list<std::string_view> ends) {
  return std::any_of(ends.begin(), ends.end(), [&](std::string_view end) { return name.ends_with(end); });
}

/// Metrics whose decrease is no gain, or none by itself.
bool IsCost(const std::string& name) {
  return !EndsWithAnyOf(name, {".least_load", ".remaining", ".mean_heave", kDampingEnd});
}

/// What a metric is shown in.
std::string ShownIn(const NamedMetric& metric) {
  if (metric.unit == "m") return "mm";
  if (metric.unit == "rad") return "deg";
  if (metric.unit == "1") return "%";
  return ParseUnit(metric.unit) ? metric.unit : "";
}

Metric Described(const NamedMetric& metric) {
  const std::optional<Unit> unit = ParseUnit(metric.unit);
  return {.name = metric.name,
          .dimension = unit ? unit->dimension : kDimensionless,
          .unit = ShownIn(metric),
          .odd_unit = unit ? "" : metric.unit,
          .is_cost = IsCost(metric.name),
          .words = unit || metric.unit.empty() ? "" : "in " + metric.unit};
}

/// Over all points of the chassis with a vertical weighting.
double ComfortOf(const RideMetrics& ride) {
  double square = 0;
  double count = 0;
  for (const RideMetrics::Comfort& point : ride.comfort) {
    if (point.weighting != Weighting::kWk) continue;
    square += point.weighted.rms * point.weighted.rms;
    ++count;
  }
  return std::sqrt(square / count);
}

/// The smallest rate of all motions must hold: a passive vehicle without a negative rate is stable (Kelvin, Tait and
/// Chetaev).
void RequireStable(const CondensedModel& model) {
  const Eigen::VectorXd rates =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(model.stiffness, Eigen::EigenvaluesOnly).eigenvalues();
  // Rounding of a motion that nothing holds.
  constexpr double kRounding = 1e-9;
  if (rates.size() > 0 && rates[0] < -kRounding * rates[rates.size() - 1])
    throw std::runtime_error("it is unstable: a motion has the rate " + std::to_string(rates[0]));
}

}  // namespace

/// The metrics of the car's list, from a ride and a model.
class MetricList {
 public:
  MetricList(const std::vector<Metric>& metrics, const SettingsFile& settings) : metrics_(metrics) {
    const auto use = [&](std::size_t metric) {
      has_modes_ = has_modes_ || metrics[metric].name.ends_with(kDampingEnd);
    };
    for (const Objective& objective : settings.objectives) use(objective.metric);
    for (const MetricLimit& limit : settings.limits) use(limit.metric);
  }

  /// Of one road.
  Eigen::RowVectorXd Of(const RideMetrics& ride) const {
    Eigen::RowVectorXd values = Eigen::RowVectorXd::Constant(static_cast<Index>(metrics_.size()), std::nan(""));
    const std::vector<NamedMetric> named = NamedMetrics(ride);
    std::size_t next = 0;
    for (std::size_t i = 0; i < metrics_.size() && !metrics_[i].name.ends_with(kDampingEnd); ++i) {
      if (metrics_[i].name == kComfort || metrics_[i].name == kGrip) {
        values[static_cast<Index>(i)] = metrics_[i].name == kComfort ? ComfortOf(ride) : ride.variation;
        continue;
      }
      // Both lists have one order; this one has gaps.
      while (next < named.size() && named[next].name != metrics_[i].name) ++next;
      if (next == named.size()) break;
      values[static_cast<Index>(i)] = named[next].value;
    }
    return values;
  }

  bool has_modes() const { return has_modes_; }

  /// Damping ratios, the same on every road.
  void AddModes(const std::vector<Mode>& modes, Eigen::MatrixXd& values) const {
    for (std::size_t i = 0; i < metrics_.size(); ++i)
      for (const Mode& mode : modes)
        if (metrics_[i].name == mode.name + kDampingEnd)
          values.col(static_cast<Index>(i)).setConstant(mode.damping_ratio);
  }

 private:
  const std::vector<Metric>& metrics_;
  bool has_modes_ = false;
};

/// What is prepared once for the spectra of all settings.
class CarMetrics::SpectralCar {
 public:
  SpectralCar(const CarMetrics& car, const SettingsFile& settings)
      : list_(car.metrics_, settings),
        condensed_(car.instruments_.vehicle),
        pose_(DesignKinematics(car.instruments_.vehicle)),
        suspension_(SuspensionOf(car.instruments_.vehicle, pose_, car.vehicle_.ParameterValues())),
        grid_(GridOf(car, settings)),
        ride_(car.instruments_, grid_, settings.duration_s) {
    const RoadTracks tracks = RoadTracksOf(car.vehicle_);
    for (const ChoiceRoad& road : settings.roads)
      roads_.push_back(RoadSpectra(tracks, *RoadRoughness(road.road_class), road.speed, grid_));
  }

  std::vector<RideMetrics> RidesAt(std::span<const double> parameters, const CondensedModel& model) const {
    RequireStable(model);
    const RandomVehicle vehicle(model, grid_);
    std::vector<RideMetrics> rides;
    for (const PostSpectra& road : roads_) {
      const RandomResponse response = vehicle.Solve(road);
      if (!response.converged) throw std::runtime_error("its statistical linearisation does not converge");
      rides.push_back(ride_.MetricsOf(model, parameters, response, road));
    }
    return rides;
  }

  CondensedModel ModelAt(std::span<const double> parameters) const { return condensed_.At(parameters); }

  Eigen::MatrixXd At(std::span<const double> parameters, std::size_t metrics) const {
    const CondensedModel model = ModelAt(parameters);
    const std::vector<RideMetrics> rides = RidesAt(parameters, model);
    Eigen::MatrixXd values(static_cast<Index>(rides.size()), static_cast<Index>(metrics));
    for (std::size_t road = 0; road < rides.size(); ++road)
      values.row(static_cast<Index>(road)) = list_.Of(rides[road]);
    if (list_.has_modes()) list_.AddModes(ModesAt(model, parameters), values);
    return values;
  }

  RideSpectra SpectraAt(std::span<const double> parameters, std::size_t road) const {
    const RandomVehicle vehicle(ModelAt(parameters), grid_);
    return SpectraOf(ride_.instruments(), grid_, vehicle.Solve(roads_[road]));
  }

  std::vector<Mode> ModesAt(const CondensedModel& model, std::span<const double> parameters) const {
    return NamedModes(condensed_.vehicle(), pose_, suspension_, model, parameters);
  }

 private:
  /// For resonances of half the least damping of the body and wheels at the fitted values.
  SpectralGrid GridOf(const CarMetrics& car, const SettingsFile& settings) const {
    const double least =
        LeastDampingWithin(condensed_.At(car.vehicle_.ParameterValues()), settings.lower_Hz, settings.upper_Hz);
    constexpr double kSofter = 0.5;
    constexpr double kLeast = 0.01;
    const double length = RoadTracksOf(car.vehicle_).length();
    double delay = 0;
    for (const ChoiceRoad& road : settings.roads) delay = std::max(delay, length / road.speed);
    return SpectralGrid::For(settings.lower_Hz, settings.upper_Hz, delay, std::max(kLeast, kSofter * least));
  }

  MetricList list_;
  CondensedVehicle condensed_;
  Kinematics pose_;
  Suspension suspension_;
  SpectralGrid grid_;
  SpectralRide ride_;
  std::vector<PostSpectra> roads_;
};

/// The same for time histories.
class CarMetrics::HistoryCar {
 public:
  HistoryCar(const CarMetrics& car, const SettingsFile& settings, TimeEngine engine)
      : list_(car.metrics_, settings),
        instruments_(car.instruments_),
        engine_(engine),
        duration_s_(settings.duration_s) {
    for (std::size_t i = 0; i < settings.roads.size(); ++i) {
      const RandomRoad road{.roughness_m3 = *RoadRoughness(settings.roads[i].road_class),
                            .speed = settings.roads[i].speed,
                            .lower_Hz = settings.lower_Hz,
                            .upper_Hz = settings.upper_Hz,
                            .duration_s = duration_s_ + 2 * kSettling_s,
                            .seed = settings.seed + i};
      roads_.push_back(road.MotionOf(car.vehicle_));
    }
  }

  Eigen::MatrixXd At(std::span<const double> parameters, std::size_t metrics) const {
    Eigen::MatrixXd values(static_cast<Index>(roads_.size()), static_cast<Index>(metrics));
    const std::vector<double> at(parameters.begin(), parameters.end());
    HistorySolver solver(instruments_.vehicle, at);
    RequireStable(solver.model());
    const TimeGrid grid{kSettling_s, kSettling_s + duration_s_, kHistoryRate_Hz, kSettling_s};
    for (std::size_t road = 0; road < roads_.size(); ++road) {
      SolvedHistory solved =
          solver.Solve(roads_[road], grid,
                       {.engine = engine_ == TimeEngine::kReduced ? Engine::kReduced : Engine::kFull, .compared = 0});
      solved.history.DropFirst(grid.lead_count());
      values.row(static_cast<Index>(road)) =
          list_.Of(RideOfHistory(instruments_, solver.model(), parameters, solved.history));
    }
    return values;
  }

 private:
  MetricList list_;
  const RideInstruments& instruments_;
  TimeEngine engine_;
  double duration_s_;
  std::vector<PostMotion> roads_;
};

CarMetrics::CarMetrics(const Vehicle& vehicle) : vehicle_(vehicle), instruments_(InstrumentRide(vehicle)) {
  if (vehicle.posts.empty()) Refuse(kCarWithoutPosts, {vehicle.file});
  metrics_ = {{.name = kComfort,
               .dimension = kAcceleration,
               .unit = "m/s^2",
               .is_cost = true,
               .words = "vertical accelerations of the chassis, weighted by Wk, root mean square over points"},
              {.name = kGrip,
               .dimension = kDimensionless,
               .unit = "%",
               .is_cost = true,
               .words = "variation of all tyre loads, rms over static"}};
  SettingsFile settings;
  settings.roads = {{.name = "B", .road_class = "B", .speed = 20}};
  const std::vector<double> values = vehicle.ParameterValues();
  const SpectralCar car(*this, settings);
  const CondensedModel model = car.ModelAt(values);
  try {
    const RideMetrics ride = car.RidesAt(values, model).front();
    if (!std::isfinite(ComfortOf(ride))) metrics_.erase(metrics_.begin());
    for (const NamedMetric& named : NamedMetrics(ride))
      if (std::isfinite(named.value)) metrics_.push_back(Described(named));
  } catch (const std::runtime_error& error) {
    Refuse(kPresentWithoutRide, {vehicle.file}, {error.what()});
  }
  for (const Mode& mode : car.ModesAt(model, values))
    if (!mode.name.empty() && (mode.kind == Mode::Kind::kOscillating || mode.kind == Mode::Kind::kOverdamped))
      metrics_.push_back({.name = mode.name + kDampingEnd,
                          .dimension = kDimensionless,
                          .unit = "",
                          .is_cost = false,
                          .words = "damping ratio of the mode"});
}

std::shared_ptr<const CarMetrics::SpectralCar> CarMetrics::MakeSpectral(const SettingsFile& settings) const {
  return std::make_shared<SpectralCar>(*this, settings);
}

MetricsOf CarMetrics::Spectra(const SettingsFile& settings) const {
  return [car = MakeSpectral(settings), count = metrics_.size()](std::span<const double> parameters) {
    return car->At(parameters, count);
  };
}

MetricsOf CarMetrics::Histories(const SettingsFile& settings, TimeEngine engine) const {
  return [car = std::make_shared<const HistoryCar>(*this, settings, engine),
          count = metrics_.size()](std::span<const double> parameters) { return car->At(parameters, count); };
}

Eigen::MatrixXd CarMetrics::DamperSpeeds(const SettingsFile& settings, std::span<const double> parameters) const {
  const std::shared_ptr<const SpectralCar> car = MakeSpectral(settings);
  const std::vector<RideMetrics> rides = car->RidesAt(parameters, car->ModelAt(parameters));
  Eigen::MatrixXd speeds(static_cast<Index>(rides.size()), static_cast<Index>(vehicle_.dampers.size()));
  for (std::size_t road = 0; road < rides.size(); ++road)
    for (std::size_t d = 0; d < rides[road].struts.size(); ++d)
      speeds(static_cast<Index>(road), static_cast<Index>(d)) = rides[road].struts[d].speed_95;
  return speeds;
}

RideSpectra CarMetrics::SpectraAt(const SettingsFile& settings, std::span<const double> parameters) const {
  const auto heaviest = std::max_element(settings.roads.begin(), settings.roads.end(),
                                         [](const ChoiceRoad& a, const ChoiceRoad& b) { return a.weight < b.weight; });
  return MakeSpectral(settings)->SpectraAt(parameters, static_cast<std::size_t>(heaviest - settings.roads.begin()));
}

}  // namespace fourpost
