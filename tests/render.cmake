# Tests of the renderer, its timings, and its gallery for the eye.
#   render_gallery     draws a large picture of everything: build/…/gallery.png
#   render_benchmark   is a program, see its head
if(TARGET render_scene)
  add_library(render_gallery_scene STATIC render_gallery.cpp)
  target_link_libraries(render_gallery_scene PUBLIC render_scene PRIVATE project_flags)
  add_kit_tests(render_scene "render_scene;render_camera;render_film" render_scene
    render_gallery_scene render_picture)

  add_executable(render_gallery_program render_gallery_program.cpp)
  target_link_libraries(render_gallery_program PRIVATE render_gallery_scene project_flags)
  add_kit_script(render_determinism "threads and backends change no byte"
    "${python}" -B "${CMAKE_CURRENT_LIST_DIR}/render_determinism_test.py"
    "$<TARGET_FILE:render_gallery_program>")
  add_custom_target(render_gallery
    COMMAND render_gallery_program "${CMAKE_BINARY_DIR}/gallery.png" 1920 1080 report
    COMMENT "Drawing ${CMAKE_BINARY_DIR}/gallery.png" VERBATIM)

  add_executable(render_benchmark render_benchmark.cpp render_yardstick.cpp)
  target_include_directories(render_benchmark SYSTEM PRIVATE "${STB_INCLUDE_DIR}")
  target_link_libraries(render_benchmark
    PRIVATE render_gallery_scene render_picture benchmark::benchmark project_flags)

  # Leaks that the checker may find in the GL library are not ours to repair.
  get_property(all_tests DIRECTORY PROPERTY TESTS)
  list(FILTER all_tests INCLUDE REGEX "^kit/render_")
  set_property(TEST ${all_tests} APPEND PROPERTY
    ENVIRONMENT "LSAN_OPTIONS=suppressions=${CMAKE_CURRENT_LIST_DIR}/render_leaks.txt")
endif()
