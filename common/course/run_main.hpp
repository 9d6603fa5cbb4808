#pragma once

#include <exception>
#include <iostream>

namespace common {

/// Runs a program's body. An exception becomes one line on stderr and exit code 1.
template <typename Body>
int run_main(const Body& body) {
  try {
    body();
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}

}  // namespace common
