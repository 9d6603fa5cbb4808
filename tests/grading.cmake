# Hand-out and grading. A stand-in for the judge proves all that is around it within seconds; what
# builds takes minutes and says so in its name.
foreach(part IN ITEMS handout intake points proof running gradescope slurm)
  add_kit_script(grading ${part} Python3::Interpreter -B
    "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" ${part})
  set_tests_properties("kit/grading/${part}" PROPERTIES TIMEOUT 600
    SKIP_REGULAR_EXPRESSION "OK .skipped=")
endforeach()
# Where no box works here, or Slurm is missing, the test says so and is skipped.
foreach(test IN ITEMS "a student begins with the handout:handout_student"
    "no attack earns or leaves anything:attack" "every lab is judged:judged"
    "a class gets what is due:judged_class")
  string(REPLACE ":" ";" test "${test}")
  list(POP_FRONT test name)
  add_kit_script(grading "${name}" Python3::Interpreter -B
    "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" ${test})
  set_tests_properties("kit/grading/${name}" PROPERTIES TIMEOUT 2400
    SKIP_REGULAR_EXPRESSION "OK .skipped=")
endforeach()
