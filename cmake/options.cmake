# The options of the build, and the flags of every target of the project.
option(FELT_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(FELT_FOLDER_TESTS "With FELT_TESTS: also the tests beside the code, not only those in tests/" ON)
option(FELT_BENCHMARKS "Build the benchmarks" OFF)
option(FELT_FUZZERS "Build the libFuzzer targets (clang only)" OFF)
option(FELT_PROGRAMS "Build the programs" ${PROJECT_IS_TOP_LEVEL})
option(FELT_FITTER_ONLY "Build only the fitter: the layers base, geometry and stroke, which need only tl-expected" OFF)
option(FELT_SOLIDS "Build the layer solid, `feltline inflate` and the solid view (needs CGAL, which is under the GPL)" ${PROJECT_IS_TOP_LEVEL})
if(PROJECT_IS_TOP_LEVEL)
  set(felt_python_default AUTO)
else()
  set(felt_python_default OFF)
endif()
set(FELT_PYTHON ${felt_python_default} CACHE STRING "Build the Python package: ON, OFF or AUTO (if pybind11 is there)")
option(FELT_WEB_TESTS "Add the tests of the npm package and the page, which ./dev npm and ./dev web build (./dev test -L web)" OFF)
option(FELT_WERROR "Warnings are errors" OFF)
option(FELT_QUICK_BUILD "Precompiled headers, several sources as one (quick.cmake)" ${PROJECT_IS_TOP_LEVEL})
set(FELT_SANITIZE "" CACHE STRING "Sanitizers: address,undefined | thread | (empty)")
option(FELT_TESTS_TOGETHER "Run the test cases of a program in few processes instead of one each" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
# -O3 in release, because the inner loops of the fitter are written for the vectoriser.
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
set(FELT_DEBUG_INFO "-g1" CACHE STRING "Debug information of RelWithDebInfo: -g, -g1 or -g0")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 ${FELT_DEBUG_INFO}")

find_program(FELT_CCACHE ccache)
if(FELT_CCACHE AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${FELT_CCACHE})
endif()

# Flags for every target of the project, but not for programs that use the library.
add_library(felt_flags INTERFACE)
# -ffp-contract=off, because a fused multiply-add rounds differently, and the same samples must produce
# the same bytes on every machine (R7, ARCHITECTURE.md#determinism).
target_compile_options(felt_flags INTERFACE
  -ffp-contract=off
  -ffunction-sections  # tests/devices/rt/check_tick_symbols.sh follows calls from section to section
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wold-style-cast -Wnon-virtual-dtor
  -Wdouble-promotion
  # Checks which thread may call which function: src/felt/rt/thread_roles.h.
  $<$<CXX_COMPILER_ID:Clang>:-Wthread-safety>
  # g++ 12 warns at -O3 about "literal" + std::string, in its own header: gcc.gnu.org/PR105651.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
# g++ 12 does not treat system headers as such in precompiled headers, so it warns about its own strings. A
# build without precompiled headers keeps these warnings.
if(FELT_QUICK_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(felt_flags INTERFACE -Wno-array-bounds -Wno-stringop-overread
    -Wno-stringop-overflow
    # When several sources compile as one, g++ treats their unnamed namespaces as if a header defined them.
    -Wno-subobject-linkage)
endif()
# No -Werror for g++ with sanitizers, because they confuse the bounds analysis of g++ 12.
if(FELT_WERROR AND NOT (FELT_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU"))
  target_compile_options(felt_flags INTERFACE -Werror)
endif()
target_include_directories(felt_flags INTERFACE ${PROJECT_SOURCE_DIR}/src)

# For code that is too slow, or that fails on purpose, with sanitizers; g++ and clang name theirs differently.
if(FELT_SANITIZE MATCHES "address|thread")
  target_compile_definitions(felt_flags INTERFACE FELT_SANITIZED)
endif()
if(FELT_SANITIZE)
  target_compile_options(felt_flags INTERFACE
    -fsanitize=${FELT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  # Not the checks of null, alignment and size that UndefinedBehaviorSanitizer puts before every access:
  # AddressSanitizer reports nearly all of these accesses, and compiling takes a sixth less time.
  if(FELT_SANITIZE MATCHES "address.*undefined")
    target_compile_options(felt_flags INTERFACE -fno-sanitize=null,alignment,object-size)
  endif()
  target_link_options(felt_flags INTERFACE -fsanitize=${FELT_SANITIZE})
endif()
