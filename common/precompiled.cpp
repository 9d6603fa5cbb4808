// Carries the precompiled headers; see common/cmake/AddLab.cmake.
