# Flags are set in INTERFACE targets, so none is set globally or twice.
#   base_flags     language, include root, sanitizers: what every target needs
#   project_flags  our own code: strict warnings, which are errors if TUMBLE_WERROR
#   answer_flags   a student's file and its substitutes: warnings, never errors
add_library(base_flags INTERFACE)
target_compile_features(base_flags INTERFACE cxx_std_20)
target_include_directories(base_flags INTERFACE "${PROJECT_SOURCE_DIR}")
set(CMAKE_CXX_EXTENSIONS OFF)
# A formula is rounded as it is written, on every machine. Nothing here reads errno or traps, which
# would keep the compiler from computing many roots at a time.
target_compile_options(base_flags INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)
# Small matrices compute their results at once, see common/eager_operators.hpp.
target_compile_options(base_flags INTERFACE "-DEIGEN_MATRIX_PLUGIN=<common/eager_members.hpp>")
# With this, Eigen does not include the headers of a processor's vector instructions, which are a
# quarter of a precompiled header. Its types keep the layout that packaged libraries were built
# with. (These are options, so that the grader also compiles students' files with them.)
target_compile_options(base_flags INTERFACE
  -DEIGEN_DONT_VECTORIZE -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MAX_STATIC_ALIGN_BYTES=16)
# Under the sanitizers Eigen would keep a note before each block of memory, and find none before a
# block that a library without them hands over. The system's blocks are aligned by 16 bytes as it is.
target_compile_options(base_flags INTERFACE -DEIGEN_MALLOC_ALREADY_ALIGNED=1)
if(TUMBLE_NATIVE)
  target_compile_options(base_flags INTERFACE -march=native)
endif()
# While asserts are on, an index beyond a vector's end is an error that says so.
target_compile_definitions(base_flags INTERFACE $<$<CONFIG:Debug>:_GLIBCXX_ASSERTIONS>)
if(TUMBLE_SHARED)
  target_compile_options(base_flags INTERFACE -fPIC)  # all share precompiled headers
endif()
if(TUMBLE_SHARED OR TUMBLE_GRADE)
  # A vector that is never set is then wrong in every run. (-ftrivial-auto-var-init=pattern would do
  # the same for any number, but with it GCC 12 computes wrongly with vector registers.)
  target_compile_options(base_flags INTERFACE -DEIGEN_INITIALIZE_MATRICES_BY_NAN)
endif()
if(TUMBLE_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_compile_options(base_flags INTERFACE ${sanitizers})
  target_link_options(base_flags INTERFACE ${sanitizers})
endif()

# A faster linker shortens the student's loop. If there is none, the system's linker is used.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=lld TUMBLE_HAVE_LLD)
if(TUMBLE_HAVE_LLD)
  target_link_options(base_flags INTERFACE -fuse-ld=lld)
endif()

add_library(project_flags INTERFACE)
target_link_libraries(project_flags INTERFACE base_flags)
target_compile_options(project_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion -Wold-style-cast
  $<$<BOOL:${TUMBLE_WERROR}>:-Werror>)

# A stub names every parameter of the contract and uses none of them.
add_library(answer_flags INTERFACE)
target_link_libraries(answer_flags INTERFACE base_flags)
# (-Wpedantic changes what GCC predefines, so a precompiled header fits all of its users or none.)
# The last ones name mistakes of students: a number cut to a whole one, a condition tested twice.
target_compile_options(answer_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wno-unused-parameter -Wfloat-conversion
  $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond> $<$<CXX_COMPILER_ID:GNU>:-Wlogical-op>)
