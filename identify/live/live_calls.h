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

/// Room: the bytes of a reduced vehicle. The number of its parameters.
int live_open(std::size_t bytes);

/// Room: values of all parameters, SI. 1 where the vehicle is hysteretic, else 0.
int live_set(std::size_t count);

/// Room: share of each post, then the frequencies [Hz], then as many amplitudes [m]. Answer: for each sensor, then for
/// each coordinate, real part, imaginary part and mean at each frequency. The number of both.
int live_response(std::size_t posts, std::size_t frequencies);

/// Answer: for each mode kind (see Mode::Kind), frequency [Hz], damping ratio, real and imaginary part of the pole,
/// then those of the shape, two for each coordinate. The number of modes.
int live_modes();
}
