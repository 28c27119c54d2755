// What looking costs: the forecast of a scene's probes.
#pragma once

#include "forecast.h"
#include "world.h"

/// Adds seconds["output"]: one sample of each probe of the world as it stands, timed with its
/// writing to a scratch record in the system's folder for such, as often as the probe samples. Tips
/// and reactions cost next to nothing and are left out; a crystal counts with the points and the
/// contour that it has now. Where no scratch record can be written nothing is added.
void forecast_output(const World &, Forecast &);
