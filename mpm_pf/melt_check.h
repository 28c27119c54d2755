// Is the melt still a state? After every step, so that no run ends on one that is not.
#pragma once

#include "world.h"

/// Throws medium::NumericalError, naming field and place, if the phase field has left its bounds
/// (|phi| < 2) or a temperature is not finite. Looks only where the last step can have written.
void check_melt(const World &);
