#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <fourpost/diagnostics.h>
#include <fourpost/vehicle.h>

namespace fourpost::api {

/// How a motion is computed. kReduced: kinematics linearised about static equilibrium, all laws exact. kFull: the full
/// geometry. kAuto: the reduced model, and the full geometry where the two visibly differ. kTimeIntegration: time
/// integration of the full geometry to steady state, for stepped sines only. The others answer these by harmonic
/// balance, with the forces of the elements evaluated over time (AFT; docs/theory.md).
enum class Engine { kAuto, kReduced, kFull, kTimeIntegration };

/// A stepped sine on the posts.
struct SteppedSine {
  /// Positive, in the order of the sweep.
  std::vector<double> frequency_Hz;
  /// Amplitude of the reference post [m], positive: one per frequency, or one for all. Of a pattern that is the front
  /// left post, or the front one of a planar car; of given shares a post with share 1.
  std::vector<double> amplitude_m;
  /// "heave" or "bounce", "pitch", "roll", "warp", or shares of posts, "FL=1,FR=-1".
  std::string posts = "heave";
  /// Of posts without a stroke in the vehicle file, from end to end [m].
  double stroke_m = 0.15;
};

/// How `fourpost response` moves the posts: the reference post at most 12 mm, 0.15 m/s and 6 m/s^2, at these
/// frequencies; without any at 40 from 0.5 to 30 Hz. `posts` as in SteppedSine. Throws Error.
SteppedSine UsualSine(const Vehicle& vehicle, const std::string& posts = "heave",
                      const std::vector<double>& frequency_Hz = {});

/// The response of a sensor, one value per frequency. A signal of phasor X is x(t) = Re(X exp(i 2 pi f t)): a channel
/// that lags the post has a negative phase. Axes are those of ISO 8855 (x forward, y left, z up); extension and rebound
/// are positive, and so is more load on a tyre.
struct ChannelResponse {
  std::string sensor;
  std::string unit;
  /// First harmonic over that of the reference post, complex: over its acceleration for accelerometers, else over its
  /// displacement. NaN where no steady motion was found.
  Eigen::VectorXcd frf;
  /// Mean reading, less that at rest, and amplitude of the second harmonic, both in `unit`.
  Eigen::VectorXd mean;
  Eigen::VectorXd second_harmonic;
};

struct Response {
  std::vector<double> frequency_Hz;
  std::vector<ChannelResponse> channels;
  /// The one that answered.
  Engine engine = Engine::kReduced;
  /// Largest error of linear kinematics, as far as kAuto could estimate it.
  std::optional<double> kinematics_error_dB;
  std::optional<double> kinematics_error_deg;

  /// Throws Error (code `name-unknown`) for a sensor that the vehicle does not have.
  const ChannelResponse& At(const std::string& sensor) const;
};

/// The steady response of a vehicle. Throws Error: kInput for an excitation or a vehicle that has none, or a post that
/// would leave its stroke; kSimulation where no motion could be computed. `stop`: asked often, from the calling thread;
/// true leaves the rest of the frequencies without a value.
Response Respond(const Vehicle& vehicle, const SteppedSine& excitation, Engine engine = Engine::kAuto,
                 const std::function<bool()>& stop = {});

/// Values of some parameters, one car a row; all others have the vehicle's.
struct ParameterTable {
  std::vector<std::string> parameters;
  /// SI; a column for each of `parameters`.
  Eigen::MatrixXd values;
};

/// The response of a row, or why it has none.
struct RowResponse {
  std::optional<Response> response;
  std::string why;
};

struct BatchOptions {
  /// kReduced takes the geometry of the vehicle once for all rows.
  Engine engine = Engine::kReduced;
  /// 0: one per processor. No influence on the result.
  int threads = 0;
  /// True leaves the rest of the rows without a response; asked often, from several threads at once.
  std::function<bool()> stop = {};
};

/// The steady responses of many cars, one per row: those of Respond() at these values, to the last bit. Throws Error of
/// kInput for names, values and an excitation that cannot be used; a row whose car has no response says so alone.
std::vector<RowResponse> RespondAt(const Vehicle& vehicle, const ParameterTable& table, const SteppedSine& excitation,
                                   const BatchOptions& options = {});

}  // namespace fourpost::api
