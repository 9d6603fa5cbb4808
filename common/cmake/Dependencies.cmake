# Finds what is installed and gives each dependency one name; nothing is downloaded.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)

find_package(Catch2 3 QUIET)
if(NOT Catch2_FOUND)
  find_package(Catch2 2.13 REQUIRED)
endif()
message(STATUS "Catch2 ${Catch2_VERSION}")

# Exact references and oracles of the tests.
find_package(Boost 1.74 REQUIRED)

# Timings of the charts and of the renderer.
find_package(benchmark REQUIRED)
find_package(Threads REQUIRED)

# Glue of the tests: checks of the mistakes, of the command and of the architecture.
find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)

# PNG: stb writes the file, ISA-L packs it.
find_path(STB_INCLUDE_DIR stb_image_write.h PATH_SUFFIXES stb REQUIRED)
find_path(ISAL_INCLUDE_DIR isa-l/igzip_lib.h REQUIRED)
find_library(ISAL_LIBRARY isal REQUIRED)

# Off-screen GL. Both libraries are opened at run time, so only their headers count here.
find_path(GLCOREARB_INCLUDE_DIR GL/glcorearb.h)
find_path(OSMESA_INCLUDE_DIR GL/osmesa.h)
find_path(EGL_INCLUDE_DIR EGL/egl.h)
set(render_backends "")
if(TUMBLE_OSMESA AND GLCOREARB_INCLUDE_DIR AND OSMESA_INCLUDE_DIR)
  list(APPEND render_backends osmesa)
endif()
if(TUMBLE_EGL AND GLCOREARB_INCLUDE_DIR AND EGL_INCLUDE_DIR)
  list(APPEND render_backends egl)
endif()
if(render_backends)
  message(STATUS "Off-screen GL: ${render_backends}")
else()
  message(STATUS "Off-screen GL: none, so no pictures (install libosmesa6-dev or libegl-dev)")
endif()
