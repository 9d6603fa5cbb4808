# Tests that folders depend on each other in one direction only, and that every lab is complete.
# Run: cmake -D root=<project> -P architecture_test.cmake
set(failures "")

# forbid(<folder> <include regex>...): no file below the folder may include a header that fits.
function(forbid folder)
  file(GLOB_RECURSE files "${root}/${folder}/*.hpp" "${root}/${folder}/*.cpp")
  forbid_in("${files}" ${ARGN})
  set(failures "${failures}" PARENT_SCOPE)
endfunction()

# forbid_in(<files> <include regex>...)
function(forbid_in files)
  foreach(file IN LISTS files)
    foreach(pattern IN LISTS ARGN)
      file(STRINGS "${file}" hits REGEX "^[ \t]*#[ \t]*include[ \t]+[<\"]${pattern}")
      if(hits)
        cmake_path(RELATIVE_PATH file BASE_DIRECTORY "${root}" OUTPUT_VARIABLE shown)
        list(APPEND failures "${shown} includes ${pattern}")
      endif()
    endforeach()
  endforeach()
  set(failures "${failures}" PARENT_SCOPE)
endfunction()

# demand(<file> <regex>): the file must have a line that fits.
function(demand file regex)
  set(hits "")
  if(EXISTS "${root}/${file}")
    file(STRINGS "${root}/${file}" hits REGEX "${regex}")
  endif()
  if(NOT hits)
    list(APPEND failures "${file} lacks '${regex}'")
  endif()
  set(failures "${failures}" PARENT_SCOPE)
endfunction()

# These are the allowed includes. A file reaches its own lab's contract by name, without a folder.
forbid(common "render/" "labs/" "solutions/" "tests/" "GL/" "EGL/" "stb" "catch" "benchmark/")
forbid(render "labs/" "solutions/" "tests/" "catch")
forbid(solutions "render/" "labs/" "solutions/" "tests/" "GL/" "catch" "boost/")
forbid(labs "labs/" "solutions/" "tests/" "GL/" "EGL/" "stb" "catch" "boost/" "benchmark/" "[.][.]/")
forbid(tests "labs/" "solutions/")

# Other engines may be included only behind the labs' peers.hpp.
set(engines "bt[A-Z]" "bullet/" "Bullet" "LinearMath/" "ode/" "fcl/" "embree" "rtcore" "CGAL/")
foreach(folder IN ITEMS common render solutions tests)
  forbid(${folder} ${engines})
endforeach()
file(GLOB_RECURSE files "${root}/labs/*.hpp" "${root}/labs/*.cpp")
list(FILTER files EXCLUDE REGEX "/peers[a-z_]*[.]cpp$")
forbid_in("${files}" ${engines})

# An answer that draws could not be graded if no graphics is installed.
file(GLOB labs RELATIVE "${root}/labs" "${root}/labs/[0-9]*_*")
foreach(folder IN LISTS labs)
  string(REGEX REPLACE "^[0-9]+_" "" name "${folder}")
  foreach(file IN ITEMS labs/${folder}/${name}.cpp labs/${folder}/${name}.hpp)
    if(EXISTS "${root}/${file}")
      file(STRINGS "${root}/${file}" hits REGEX "#[ \t]*include[ \t]+\"render/")
      if(hits)
        list(APPEND failures "${file} includes render/")
      endif()
    endif()
  endforeach()
endforeach()

# Every lab must be complete and listed. A hand-out ships without solutions.
foreach(folder IN LISTS labs)
  string(REGEX REPLACE "^[0-9]+_" "" name "${folder}")
  set(paths labs/${folder}/CMakeLists.txt labs/${folder}/README.md labs/${folder}/hints.md
    labs/${folder}/${name}.hpp labs/${folder}/${name}.cpp labs/${folder}/scene.cpp
    labs/${folder}/chart.cpp tests/${name})
  if(EXISTS "${root}/solutions")
    list(APPEND paths solutions/${folder}/${name}.cpp solutions/${folder}/mistakes.cmake
      solutions/${folder}/mistakes/nan.cpp)
    file(GLOB answers "${root}/solutions/${folder}/*.cpp")
    list(LENGTH answers count)
    if(count LESS 2)
      list(APPEND failures "solutions/${folder} lacks a second right answer")
    endif()
    set(mistakes "")
    if(EXISTS "${root}/solutions/${folder}/mistakes.cmake")
      file(STRINGS "${root}/solutions/${folder}/mistakes.cmake" mistakes REGEX "^ *add_mutant")
    endif()
    list(LENGTH mistakes count)
    if(count LESS 8)
      list(APPEND failures "solutions/${folder}/mistakes.cmake has fewer than eight mistakes")
    endif()
  endif()
  foreach(path IN LISTS paths)
    if(NOT EXISTS "${root}/${path}")
      list(APPEND failures "missing ${path}")
    endif()
  endforeach()
  demand(labs/CMakeLists.txt "^ *${folder}\\)?$")
  demand(labs/${folder}/CMakeLists.txt "add_lab\\(${name}[ )]")
endforeach()

# The labs on particles must not know rigid bodies.
foreach(name IN ITEMS 3_discrete_particle_cylinder 4_continuous_particle_cylinder)
  forbid(labs/${name} "common/attitude" "common/coning" "common/rigid_body")
  forbid(solutions/${name} "common/attitude" "common/coning" "common/rigid_body")
endforeach()

if(failures)
  list(JOIN failures "\n  " text)
  message(FATAL_ERROR "architecture:\n  ${text}")
endif()
