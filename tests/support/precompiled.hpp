#pragma once

// What the tests of every lab parse. Headers alone, and no file includes it; see
// common/precompiled.hpp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "catch.hpp"
#include "common/types.hpp"
