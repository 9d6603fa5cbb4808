"""The command ./tumble: drives CMake, CTest and the labs' programs, and explains what they say."""
