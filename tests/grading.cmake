# Hand-out and grading. A stand-in for the judge proves all that is around it within seconds.
function(add_grading_test name part)
  add_kit_script(grading "${name}" Python3::Interpreter -B
    "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" ${part})
  set_tests_properties("kit/grading/${name}" PROPERTIES
    SKIP_REGULAR_EXPRESSION "OK .skipped=" ${ARGN})
endfunction()

foreach(part IN ITEMS handout intake points proof running sandbox gradescope slurm)
  add_grading_test(${part} ${part})
endforeach()

# These build, which takes minutes. The judge's programs are built in one folder.
add_grading_test("a student begins with the handout" handout_student TIMEOUT 2400)
add_grading_test("no attack earns or leaves anything" attack TIMEOUT 2400 RESOURCE_LOCK judge)
add_grading_test("the judge knows right from wrong" judged TIMEOUT 3600 PROCESSORS 2
  RESOURCE_LOCK judge)

# By hand: grading_test.py judged_class, and all mistakes of a lab, see judged_test.py.
