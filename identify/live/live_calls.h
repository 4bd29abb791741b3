#pragma once

#include <cstddef>

// A LiveVehicle as a page calls it: plain C functions that WebAssembly exports, with one vehicle to an instance. What a
// call reads the page puts into the room before; what it answers it reads from live_answer() before the next call.
// Calls that may be refused return -1 then, and live_fault() has the reason.
extern "C" {

/// Room for so many bytes, aligned for doubles; what was in it is lost.
void* live_room(std::size_t bytes);
const double* live_answer();
/// Ends with a zero byte.
const char* live_fault();

/// Room: the bytes of a reduced vehicle (reduced_bytes.h), then those of its ride instruments (ride_bytes.h), which may
/// be none. The number of its parameters.
int live_open(std::size_t vehicle_bytes, std::size_t ride_bytes);

/// Room: values of all parameters, SI. 1 where the vehicle is hysteretic, else 0.
int live_set(std::size_t count);

/// Room: share of each post, then the frequencies [Hz], then as many amplitudes [m]. Answer: for each sensor, then for
/// each coordinate, real part, imaginary part and mean at each frequency. The number of both.
int live_response(std::size_t posts, std::size_t frequencies);

/// Answer: for each mode kind (see Mode::Kind), frequency [Hz], damping ratio, real and imaginary part of the pole,
/// then those of the shape, two for each coordinate. The number of modes.
int live_modes();

/// Room: roughness [m^3] and speed [m/s] of a road, and its band's bounds [Hz]. Of a vehicle with ride instruments.
/// Answer: 1 where the ride converged, else 0, the error of its grid, and the share of time of the stop that is in
/// contact most; of each point the weighted rms [m/s^2]; of each tyre the load variation and the share of time off the
/// ground; of each damper the rms of its travel [m]; then the frequencies [Hz], and of each point the weighted density [(m/s^2)^2/Hz]
/// at them. The number of frequencies.
int live_ride();
}
