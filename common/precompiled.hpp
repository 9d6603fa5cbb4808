#pragma once

// The headers that a save must not parse again. There are only headers here: GCC does not keep in a
// precompiled header what templates become for given types, so an example of use would be compiled
// at every save. No file includes this one; see common/cmake/AddLab.cmake.
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/course/not_implemented.hpp"
#include "common/types.hpp"
