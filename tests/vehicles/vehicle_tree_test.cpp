#include "small_vehicle.h"
