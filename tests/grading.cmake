# Hand-out and grading. A stand-in for the judge proves all that is around it within seconds; what
# builds takes minutes and says so in its name.
foreach(part IN ITEMS handout intake points proof running gradescope slurm)
  add_kit_script(grading ${part} Python3::Interpreter -B
    "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" ${part})
  set_tests_properties("kit/grading/${part}" PROPERTIES TIMEOUT 600
    SKIP_REGULAR_EXPRESSION "OK .skipped=")
endforeach()
add_kit_script(grading "a student begins with the handout" Python3::Interpreter -B
  "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" handout_student)
set_tests_properties("kit/grading/a student begins with the handout" PROPERTIES TIMEOUT 2400)
add_kit_script(grading "no attack earns or leaves anything" Python3::Interpreter -B
  "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" attack)
set_tests_properties("kit/grading/no attack earns or leaves anything" PROPERTIES TIMEOUT 1200)
add_kit_script(grading "a class gets what is due" Python3::Interpreter -B
  "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" judged_class)
set_tests_properties("kit/grading/a class gets what is due" PROPERTIES TIMEOUT 2400
  SKIP_REGULAR_EXPRESSION "OK .skipped=")
add_kit_script(grading "every lab is judged" Python3::Interpreter -B
  "${CMAKE_CURRENT_SOURCE_DIR}/grading_test.py" judged)
set_tests_properties("kit/grading/every lab is judged" PROPERTIES TIMEOUT 2400)
