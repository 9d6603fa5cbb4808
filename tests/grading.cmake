# Hand-out and grading. A stand-in for the judge proves all that is around it within seconds; what
# builds takes minutes and says so in its name.
foreach(part IN ITEMS handout intake points proof running sandbox gradescope slurm)
  add_kit_script(grading ${part} Python3::Interpreter -B
    "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" ${part})
  set_tests_properties("kit/grading/${part}" PROPERTIES TIMEOUT 600
    SKIP_REGULAR_EXPRESSION "OK .skipped=")
endforeach()
add_kit_script(grading "a student begins with the handout" Python3::Interpreter -B
  "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" handout_student)
set_tests_properties("kit/grading/a student begins with the handout" PROPERTIES TIMEOUT 2400)
# By hand, on a calm machine, until they take less of it: grading_test.py attack, judged, judged_class.
