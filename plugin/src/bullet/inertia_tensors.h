#pragma once

#include "polhode/bullet/precision.h"

namespace polhode {
inline namespace POLHODE_PRECISION {

/// Whether inverse_inertia_tensor_W in lanes gives the bits of the Bullet that this process runs. Found out
/// at the first call, as turns_in_lanes.
bool inertia_tensors_in_lanes();

}  // namespace POLHODE_PRECISION
}  // namespace polhode
