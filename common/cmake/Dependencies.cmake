# Finds what is installed and gives each dependency one name. It downloads nothing.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)

find_package(Catch2 3 QUIET)
if(NOT Catch2_FOUND)
  find_package(Catch2 2.13 REQUIRED)
endif()
message(STATUS "Catch2 ${Catch2_VERSION}")

# These are for the exact references and for the oracles of the tests.
find_package(Boost 1.74 REQUIRED)

# This times the charts and the renderer.
find_package(benchmark REQUIRED)
find_package(Threads REQUIRED)

# This runs the checks of the mistakes, of the command and of the architecture.
find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
# A version manager's python3 is a script that takes a third of a second to find the real one, and
# some six hundred tests and steps of a build begin with it.
execute_process(COMMAND "${Python3_EXECUTABLE}" -c "import sys; print(sys.executable)"
  OUTPUT_VARIABLE python OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

# For PNG, stb writes the file and ISA-L packs it.
find_path(STB_INCLUDE_DIR stb_image_write.h PATH_SUFFIXES stb REQUIRED)
find_path(ISAL_INCLUDE_DIR isa-l/igzip_lib.h REQUIRED)
find_library(ISAL_LIBRARY isal REQUIRED)

# For off-screen GL. Both libraries are opened at run time, so only their headers count here.
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

# _add_peer(<name> <include folder> <library>...) adds peer_<name> and TUMBLE_<NAME> if all exist.
function(_add_peer name include)
  foreach(found IN LISTS include ARGN)
    if(NOT found)
      return()
    endif()
  endforeach()
  string(TOUPPER "TUMBLE_${name}" definition)
  add_library(peer_${name} INTERFACE)
  target_include_directories(peer_${name} SYSTEM INTERFACE "${include}")
  target_compile_definitions(peer_${name} INTERFACE ${definition})
  target_link_libraries(peer_${name} INTERFACE ${ARGN})
  set(peers ${peers} ${name} PARENT_SCOPE)
endfunction()

# Peers are engines against which a chart can be drawn. Each one that is installed becomes
# peer_<name>. Debian has Bullet in both precisions, and a user who needs accuracy takes double.
set(peers "")
if(TUMBLE_BULLET)
  find_path(BULLET_INCLUDE_DIR btBulletDynamicsCommon.h PATH_SUFFIXES bullet)
  foreach(precision IN ITEMS -float64 "")
    foreach(part IN ITEMS BulletDynamics BulletCollision LinearMath)
      find_library(${part}${precision}_LIBRARY ${part}${precision})
      mark_as_advanced(${part}${precision}_LIBRARY)
    endforeach()
    _add_peer(bullet "${BULLET_INCLUDE_DIR}" "${BulletDynamics${precision}_LIBRARY}"
      "${BulletCollision${precision}_LIBRARY}" "${LinearMath${precision}_LIBRARY}")
    if(TARGET peer_bullet)
      target_compile_definitions(peer_bullet INTERFACE
        $<$<BOOL:${precision}>:BT_USE_DOUBLE_PRECISION>)
      break()
    endif()
  endforeach()
endif()
if(TUMBLE_ODE)
  find_path(ODE_INCLUDE_DIR ode/ode.h)
  find_library(ODE_LIBRARY ode)
  _add_peer(ode "${ODE_INCLUDE_DIR}" "${ODE_LIBRARY}")
endif()
if(TUMBLE_FCL)
  find_path(FCL_INCLUDE_DIR fcl/geometry/bvh/BVH_model.h)
  find_library(FCL_LIBRARY fcl)
  find_library(CCD_LIBRARY ccd)
  _add_peer(fcl "${FCL_INCLUDE_DIR}" "${FCL_LIBRARY}" "${CCD_LIBRARY}")
endif()
if(TUMBLE_EMBREE)
  # Either version will do, because the peer calls the same functions in both.
  find_path(EMBREE_RTCORE_DIR rtcore.h PATH_SUFFIXES embree4 embree3)
  find_library(EMBREE_LIBRARY NAMES embree4 embree3)
  _add_peer(embree "${EMBREE_RTCORE_DIR}" "${EMBREE_LIBRARY}")
endif()
if(TUMBLE_CGAL)
  find_path(CGAL_INCLUDE_DIR CGAL/AABB_tree.h)
  find_library(GMP_LIBRARY gmp)
  find_library(MPFR_LIBRARY mpfr)
  _add_peer(cgal "${CGAL_INCLUDE_DIR}" "${MPFR_LIBRARY}" "${GMP_LIBRARY}")
  if(TARGET peer_cgal)
    # CGAL's intervals change the rounding mode, and g++ must know that.
    target_compile_options(peer_cgal INTERFACE $<$<CXX_COMPILER_ID:GNU>:-frounding-math>)
  endif()
endif()

foreach(peer IN ITEMS bullet ode fcl embree cgal)
  string(TOUPPER "TUMBLE_${peer}" wanted)
  if(${wanted} AND NOT TARGET peer_${peer})
    message(STATUS "Peer ${peer}: not found, so --peers leaves it out")
  endif()
endforeach()
