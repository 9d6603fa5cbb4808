# add_lab(<name> [USES <room>...])
#
# Declares the lab in the current folder, labs/<N>_<name>/. Its tests, scene and chart are compiled
# once, against the contract <name>.hpp alone. They are linked with one answer after the other:
#   <name>_student_{test,scene,chart}     the student's <name>.cpp in this folder
#   <name>_reference_{test,scene,chart}   solutions/<N>_<name>/<name>.cpp
#   <name>_<other>_{test,scene,chart}     solutions/<N>_<name>/<other>.cpp, a right answer, too
# If TUMBLE_PROOF, the tests are also linked with what else is in solutions/<N>_<name>/:
#   mistakes/nan.cpp   returns NaN everywhere, and throws std::domain_error("not a number") if the
#                      contract has no number: every test fails
#   mistakes.cmake     the bank of mistakes if TUMBLE_MISTAKES, see add_mutant
# If TUMBLE_GRADE, there are none of these, but only what judges files that are handed in, see
# _add_judge. CTest names are <N>_<name>/<answer>/<step>/<case>; labels are student, stub, right,
# nan and mistake. USES names the rooms of common/ that contract, answers and tests include, see
# common/CMakeLists.txt. The first build of a lab takes no other rooms. A hand-out may ship without
# the solutions folder. If a lab has peers.cpp, its chart can be drawn against other engines:
# <name>_peers is that file and peers_<engine>.cpp of each that is installed.
function(add_lab name)
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME folder)
  set(solutions "${PROJECT_SOURCE_DIR}/solutions/${folder}")

  add_library(${name}_contract INTERFACE)
  target_include_directories(${name}_contract INTERFACE "${CMAKE_CURRENT_SOURCE_DIR}")
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES")
  list(TRANSFORM arg_USES PREPEND common_ OUTPUT_VARIABLE used)
  target_link_libraries(${name}_contract INTERFACE common_headers ${used})

  file(GLOB test_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/${name}/*.cpp")
  _read_cases(cases ${test_sources})
  list(JOIN cases "\n" lines)
  file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/cases.txt" CONTENT "${lines}\n")
  _add_program(${name}_test "${test_sources}" test_support)
  if(NOT TUMBLE_PROOF)  # a first build, for which two processors wait, ends sooner
    set_target_properties(${name}_test PROPERTIES UNITY_BUILD_BATCH_SIZE 4)
  endif()
  set(tests test)
  if(TUMBLE_SHARED)
    set(tests tests)
    _add_tests()
  endif()
  if(TUMBLE_GRADE OR (TUMBLE_PROOF AND NOT TUMBLE_SHARED))
    _add_judge()
  endif()
  if(TUMBLE_GRADE)
    return()
  endif()
  if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/peers.cpp")
    _add_peers()
  endif()
  if(TUMBLE_PICTURES)
    _add_program(${name}_scene scene.cpp render_scene common)
    set(peers_of_lab "")
    if(TARGET ${name}_peers)
      set(peers_of_lab ${name}_peers)
    endif()
    _add_program(${name}_chart chart.cpp render_chart common ${peers_of_lab})
  endif()

  _add_answer(student "${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp" answer_flags PICTURES)
  _add_cases(student student)
  if(TUMBLE_SHARED)
    _add_closer_look(debug -O0 -g)
    _add_closer_look(sanitized -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all)
  endif()
  if(NOT EXISTS "${solutions}")
    return()
  endif()
  file(GLOB others CONFIGURE_DEPENDS "${solutions}/*.cpp")
  list(REMOVE_ITEM others "${solutions}/${name}.cpp")
  list(TRANSFORM others REPLACE "^.*/(.*)[.]cpp$" "\\1" OUTPUT_VARIABLE answers)
  list(PREPEND answers reference)
  list(PREPEND others "${solutions}/${name}.cpp")
  foreach(answer source IN ZIP_LISTS answers others)
    _add_answer(${answer} "${source}" project_flags PICTURES)
  endforeach()
  if(NOT TUMBLE_PROOF)
    return()
  endif()

  foreach(answer IN LISTS answers)
    _add_cases(${answer} right)
    _add_seeds(${answer})
  endforeach()
  _add_stub_cases()
  _add_answer(nan "${solutions}/mistakes/nan.cpp" answer_flags)
  _add_cases(nan nan)
  set_tests_properties(${nan_tests} PROPERTIES PASS_REGULAR_EXPRESSION
    "[|] error +not finite;[|] got +an exception( of another type)?: not a number"
    FAIL_REGULAR_EXPRESSION "All tests passed")
  if(TUMBLE_MISTAKES)
    _add_mistakes()
  endif()
endfunction()

# add_mutant(<name> <mistake> <step> <find> <replace> <words> [OF <answer>])
#
# Adds the reference with one mistake in it: <find>, which it must contain, is replaced. A test of
# <step> must fail. The likely mistake that its tests name must contain <words>, and they may name
# no other. If <words> is empty, the mistake has no fingerprint and the tests must name none. With
# OF the mistake is made in another right answer, <answer>.cpp, because a trick that the reference
# does not use has mistakes of its own. Only what the mistake can reach is compiled again, together
# with that of other mistakes, see only_affected.py and batch.py.
function(add_mutant name mistake step find replace words)
  cmake_parse_arguments(PARSE_ARGV 6 arg "" "OF" "")
  if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "add_mutant(${name} ${mistake}): only [OF <answer>] may follow the six arguments, not: ${ARGN}")
  endif()
  set(answer "${name}")
  if(arg_OF)
    set(answer "${arg_OF}")
  endif()
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME folder)
  set(file "${PROJECT_SOURCE_DIR}/solutions/${folder}/${answer}.cpp")
  file(READ "${file}" right)
  string(REPLACE "${find}" "${replace}" wrong "${right}")
  if(wrong STREQUAL right)
    message(FATAL_ERROR "add_mutant(${name} ${mistake}): '${find}' is not in ${file}: change it to text of that file")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(GLOB before "${CMAKE_CURRENT_BINARY_DIR}/whole/${answer}/*/*.cpp")
  list(LENGTH before count)
  math(EXPR batch "${count} / 12")  # of so many, which take seconds to compile
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/whole/${answer}/${batch}/${mistake}.cpp" "${wrong}")

  set(program ${name}_mistake_${mistake}_test)
  add_executable(${program} "${CMAKE_CURRENT_BINARY_DIR}/mistakes/${answer}/${mistake}.o"
    "${CMAKE_CURRENT_BINARY_DIR}/${answer}_weak.o")
  set_target_properties(${program} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(${program} PRIVATE test_main ${name}_tests ${name}_contract)
  target_link_options(${program} PRIVATE LINKER:--gc-sections)
  add_test(NAME "${folder}/mistake/${step}/${mistake}" COMMAND "${python}" -B
    "${PROJECT_SOURCE_DIR}/tests/mistake_test.py" $<TARGET_FILE:${program}> ${step} "${words}")
  set_tests_properties("${folder}/mistake/${step}/${mistake}" PROPERTIES LABELS mistake TIMEOUT 120)
endfunction()

# Adds the bank of mistakes, and the right answers that supply what a mistake cannot reach.
function(_add_mistakes)
  file(REMOVE_RECURSE "${CMAKE_CURRENT_BINARY_DIR}/whole")
  include("${solutions}/mistakes.cmake")
  file(GLOB answers RELATIVE "${CMAKE_CURRENT_BINARY_DIR}/whole" "${CMAKE_CURRENT_BINARY_DIR}/whole/*")
  foreach(answer IN LISTS answers)
    set(right ${name}_${answer})
    if(answer STREQUAL name)
      set(right ${name}_reference)
    endif()
    # Only the lab's own names: a name that the answer only uses would be null if it were weak, too.
    set(weak "${CMAKE_CURRENT_BINARY_DIR}/${answer}_weak.o")
    add_custom_command(OUTPUT "${weak}"
      COMMAND ${CMAKE_OBJCOPY} --wildcard "--weaken-symbol=_ZN3lab*" "--weaken-symbol=_ZNK3lab*"
              $<TARGET_OBJECTS:${right}> "${weak}"
      DEPENDS ${right} $<TARGET_OBJECTS:${right}> COMMENT "Weakening ${right}")
    file(GLOB batches LIST_DIRECTORIES TRUE "${CMAKE_CURRENT_BINARY_DIR}/whole/${answer}/*")
    foreach(batch IN LISTS batches)
      _add_batch(${answer} ${right} "${batch}")
    endforeach()
  endforeach()
endfunction()

# Compiles mistakes together, and makes an object of each again.
function(_add_batch answer right folder)
  cmake_path(GET folder FILENAME number)
  set(script "${python}" -B "${PROJECT_SOURCE_DIR}/common/cmake/batch.py")
  set(out "${CMAKE_CURRENT_BINARY_DIR}/mistakes/${answer}")
  execute_process(COMMAND ${script} write "${CMAKE_CURRENT_SOURCE_DIR}/${name}.hpp"
    "${solutions}/${answer}.cpp" "${folder}" "${out}/batch_${number}.cpp" COMMAND_ERROR_IS_FATAL ANY)
  set(batch ${name}_mistakes_in_${answer}_${number})
  add_library(${batch} OBJECT "${out}/batch_${number}.cpp")
  target_link_libraries(${batch} PRIVATE ${name}_contract answer_flags)
  target_compile_options(${batch} PRIVATE -w -ffunction-sections)  # a mistake may be worth a warning
  target_precompile_headers(${batch} REUSE_FROM precompiled)
  file(GLOB mistakes RELATIVE "${folder}" "${folder}/*.cpp")
  list(TRANSFORM mistakes REPLACE "[.]cpp$" "")
  list(TRANSFORM mistakes REPLACE "(.+)" "${out}/\\1.o" OUTPUT_VARIABLE objects)
  add_custom_command(OUTPUT ${objects}
    COMMAND ${script} split "${CMAKE_NM}" "${CMAKE_OBJCOPY}" $<TARGET_OBJECTS:${right}>
            $<TARGET_OBJECTS:${batch}> "${out}" ${mistakes}
    DEPENDS ${right} ${batch} $<TARGET_OBJECTS:${right}> $<TARGET_OBJECTS:${batch}>
            "${PROJECT_SOURCE_DIR}/common/cmake/batch.py"
    COMMENT "Taking apart ${batch}" VERBATIM)
endfunction()

# Compiles one of the lab's programs against the contract, without an implementation of it.
function(_add_program program sources)
  foreach(target IN LISTS ARGN)
    if(NOT TARGET ${target})
      message(STATUS "${program} is left out: no ${target}")
      return()
    endif()
  endforeach()
  add_library(${program} OBJECT ${sources})
  target_link_libraries(${program} PUBLIC ${name}_contract PRIVATE project_flags PUBLIC ${ARGN})
  target_precompile_headers(${program} REUSE_FROM precompiled)
endfunction()

# Links the lab's tests with all that they need once: <name>_tests is a shared library that leaves
# the contract's functions to the program. So a save compiles and links only the student's file.
function(_add_tests)
  add_library(${name}_tests SHARED)
  target_link_libraries(${name}_tests PRIVATE ${name}_test)
endfunction()

# An engine that is not installed costs only its own file; a lab has files for those it can use.
function(_add_peers)
  set(sources "")
  set(engines "")
  foreach(engine IN LISTS peers)
    if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/peers_${engine}.cpp")
      list(APPEND sources peers_${engine}.cpp)
      list(APPEND engines peer_${engine})
    endif()
  endforeach()
  add_library(${name}_peers STATIC peers.cpp ${sources})
  target_include_directories(${name}_peers PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${name}_peers PUBLIC common PRIVATE project_flags ${engines})
  set_target_properties(${name}_peers PROPERTIES UNITY_BUILD OFF)  # engines' headers do not mix
endfunction()

# _add_answer(<answer> <source> <flags> [PICTURES]) adds an implementation and its programs.
function(_add_answer answer source flags)
  set(implementation ${name}_${answer})
  add_library(${implementation} OBJECT "${source}")
  target_link_libraries(${implementation} PRIVATE ${name}_contract ${flags})
  target_precompile_headers(${implementation} REUSE_FROM precompiled)
  set_target_properties(${implementation} PROPERTIES UNITY_BUILD OFF)  # editors look for the file
  set(kinds test)
  if("PICTURES" IN_LIST ARGN)
    list(APPEND kinds scene chart)
  endif()
  foreach(kind IN LISTS kinds)
    if(TARGET ${name}_${kind})
      add_executable(${implementation}_${kind})
      if(NOT kind STREQUAL "test" AND NOT answer MATCHES "^(student|reference)$")
        set_target_properties(${implementation}_${kind} PROPERTIES EXCLUDE_FROM_ALL ON)
      endif()
      set(program ${name}_${kind})
      if(kind STREQUAL "test")
        set(program test_main ${name}_${tests})
      endif()
      target_link_libraries(${implementation}_${kind} PRIVATE ${implementation} ${program})
    endif()
  endforeach()
endfunction()

# _add_closer_look(<kind> <flag>...) adds <name>_student_<kind>_test: the student's file, compiled
# with other flags and linked with the same tests. Only the command builds it.
function(_add_closer_look kind)
  set(program ${name}_student_${kind}_test)
  add_executable(${program} EXCLUDE_FROM_ALL "${CMAKE_CURRENT_SOURCE_DIR}/${name}.cpp")
  target_compile_options(${program} PRIVATE ${ARGN})
  target_link_options(${program} PRIVATE ${ARGN})
  target_link_libraries(${program} PRIVATE ${name}_contract answer_flags test_main ${name}_tests)
  set_target_properties(${program} PROPERTIES UNITY_BUILD OFF)
endfunction()

# Links the lab's tests with an answer that asks a worker, see crossings.py. Also builds
# what an answer is linked with to run elsewhere, see solutions/grading/contract.hpp. CMake compiles
# no answer for it. build/grade/judges/<name>.json says where all of that is, and how to compile a
# student's file.
function(_add_judge)
  set(grading "${PROJECT_SOURCE_DIR}/solutions/grading")
  if(NOT EXISTS "${grading}/${name}/remote.hpp")
    message(STATUS "${folder} is not graded: no solutions/grading/${name}/remote.hpp")
    return()
  endif()
  set(crossings "${CMAKE_CURRENT_BINARY_DIR}/crossings")
  set(contract "${CMAKE_CURRENT_SOURCE_DIR}/${name}.hpp")
  # Now and not in the build, because editors and clang-tidy read these files without one.
  execute_process(COMMAND "${python}" -B "${grading}/crossings.py" "${contract}" "${crossings}"
    COMMAND_ERROR_IS_FATAL ANY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${contract}"
    "${grading}/crossings.py")
  set(includes "${grading}" "${grading}/${name}" "${crossings}")
  add_executable(${name}_judge_test EXCLUDE_FROM_ALL "${grading}/proxy.cpp" "${grading}/worker.cpp"
    "${grading}/sleep.cpp" "${crossings}/proxy.cpp")
  target_include_directories(${name}_judge_test PRIVATE ${includes})
  target_link_libraries(${name}_judge_test PRIVATE ${name}_test Catch2::Catch2WithMain project_flags)
  add_library(${name}_driver OBJECT EXCLUDE_FROM_ALL "${grading}/driver.cpp")
  target_include_directories(${name}_driver PRIVATE ${includes})
  target_link_libraries(${name}_driver PRIVATE ${name}_contract project_flags)
  set(options "$<JOIN:$<TARGET_PROPERTY:answer_flags,INTERFACE_COMPILE_OPTIONS>,$<SEMICOLON>>")
  file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/judges/${name}.json" CONTENT "{
  \"compiler\": \"${CMAKE_CXX_COMPILER}\",
  \"test\": \"$<TARGET_FILE:${name}_judge_test>\",
  \"strict\": \"${catch2_strict}\",
  \"driver\": \"$<TARGET_OBJECTS:${name}_driver>\",
  \"library\": \"$<TARGET_FILE:common>\",
  \"eigen\": \"$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>\",
  \"options\": \"${CMAKE_CXX20_STANDARD_COMPILE_OPTION};${options}\"
}\n")
endfunction()

# _read_cases(<out> <file>...) reads the test cases as a list of <step>|<name>. It reads the sources
# and never runs a program that contains a student's code.
function(_read_cases out)
  set(cases "")
  foreach(file IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    file(READ "${file}" text)
    string(REGEX MATCHALL "TEST_CASE\\([^)]*\\)" heads "${text}")
    foreach(head IN LISTS heads)
      if(NOT head MATCHES "^TEST_CASE\\(\"([A-Za-z0-9 _.-]+)\",[ \n]*\"\\[([0-9]+\\.[0-9]+)\\]\"\\)$")
        message(FATAL_ERROR "${file}: write TEST_CASE(\"letters, digits, blanks, . _ -\", \"[step]\"): ${head}")
      endif()
      list(APPEND cases "${CMAKE_MATCH_2}|${CMAKE_MATCH_1}")
    endforeach()
  endforeach()
  set(${out} "${cases}" PARENT_SCOPE)
endfunction()

# _add_cases(<answer> <label>) adds each case in a process of its own; the names go to
# <answer>_tests.
function(_add_cases answer label)
  set(names "")
  foreach(case IN LISTS cases)
    string(REPLACE "|" ";" case "${case}")
    list(POP_FRONT case step)
    set(test "${folder}/${answer}/${step}/${case}")
    add_test(NAME "${test}" COMMAND ${name}_${answer}_test "${case}" ${catch2_strict})
    # These are Catch2's own words. Exit code 0 alone would pass an answer that calls exit(0), and a
    # case that asserts nothing.
    set_tests_properties("${test}" PROPERTIES LABELS ${label} TIMEOUT ${case_seconds}
      PASS_REGULAR_EXPRESSION "All tests passed [(][1-9]")
    list(APPEND names "${test}")
  endforeach()
  set(${answer}_tests "${names}" PARENT_SCOPE)
endfunction()

# A right answer passes for every seed. The sanitizers are ten times slower and look at one seed.
function(_add_seeds answer)
  if(TUMBLE_SANITIZE)
    return()
  endif()
  list(LENGTH cases count)
  set(test "kit/other seeds/${folder} ${answer}")
  add_test(NAME "${test}" COMMAND "${python}" -B
    "${PROJECT_SOURCE_DIR}/tests/seeds_test.py" $<TARGET_FILE:${name}_${answer}_test> ${count})
  set_tests_properties("${test}" PROPERTIES LABELS "kit;long" TIMEOUT 300)
endfunction()

# The untouched stub fails every case, and says which step is not written yet.
function(_add_stub_cases)
  foreach(case IN LISTS cases)
    string(REPLACE "|" ";" case "${case}")
    list(POP_FRONT case step)
    set(test "${folder}/stub/${step}/${case}")
    add_test(NAME "${test}" COMMAND ${name}_student_test "${case}" ${catch2_strict})
    string(REPLACE "." "\\." step "${step}")
    set_tests_properties("${test}" PROPERTIES LABELS stub TIMEOUT ${case_seconds}
      PASS_REGULAR_EXPRESSION "${step} [a-z0-9_]+ is not written yet"
      FAIL_REGULAR_EXPRESSION "All tests passed")
  endforeach()
endfunction()

# The limits of a case, so that one that hangs ends.
set(case_seconds 10)
if(TUMBLE_SANITIZE)
  set(case_seconds 100)
endif()

# Our files are small and include the same big headers. A unit reads these once for several files.
add_library(precompiled OBJECT "${PROJECT_SOURCE_DIR}/common/precompiled.cpp")
target_link_libraries(precompiled PRIVATE Eigen3::Eigen project_flags)
target_precompile_headers(precompiled PRIVATE "${PROJECT_SOURCE_DIR}/common/precompiled.hpp")
