# Tests of hand-out and grading. A stand-in for the judge proves all code around it within seconds.
function(add_grading_test name part)
  add_kit_script(grading "${name}" "${python}" -B
    "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" ${part})
  set_tests_properties("kit/grading/${name}" PROPERTIES
    SKIP_REGULAR_EXPRESSION "OK .skipped=" ${ARGN})
endfunction()

foreach(part IN ITEMS compiling crossings handout intake points proof running sandbox gradescope)
  add_grading_test(${part} ${part})
endforeach()

# These build, or start a cluster, which takes minutes. The judge's programs share one build folder.
function(add_long_grading_test name part)
  add_grading_test("${name}" ${part} TIMEOUT 3600 ${ARGN})
  set_property(TEST "kit/grading/${name}" PROPERTY LABELS kit long)
endfunction()
add_long_grading_test("slurm" slurm)
add_long_grading_test("a student begins with the handout" handout_student)
add_long_grading_test("no attack earns or leaves anything" attack RESOURCE_LOCK judge)
add_long_grading_test("the judge knows right from wrong" judged PROCESSORS 2 RESOURCE_LOCK judge)
add_long_grading_test("a small class gets what is due" judged_class PROCESSORS 2 RESOURCE_LOCK judge)

# Run this by hand: all mistakes of a lab, see judged_test.py.
