# felt_layer(NAME SOURCES ... [HEADERS ...] [TESTS ...] [BENCHES ...] [DEPENDS layers...] [LIBRARIES ...])
#
# One layer = one static library felt_NAME, installed as feltline::NAME. Its tests are linked
# against that layer alone, so that a forbidden dependency does not link.
#   DEPENDS          layers of the house that this layer's headers may include (tests/layers checks)
#   LIBRARIES        libraries that its headers show
#   PRIVATE_LIBRARIES  libraries that only its sources use
#   TEST_LIBRARIES   what only its tests and benchmarks link
#
# felt_room(LAYER NAME ...): the same for a room, the folder LAYER/NAME: target felt_LAYER_NAME.
# A room may include what its layer may, and never another room.
include(GNUInstallDirs)

function(felt_layer name)
  cmake_parse_arguments(ARG "" ""
    "SOURCES;HEADERS;TESTS;BENCHES;DEPENDS;LIBRARIES;PRIVATE_LIBRARIES;TEST_LIBRARIES" ${ARGN})
  set(target felt_${name})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
    felt_quick_library(${target})
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:felt_flags> ${ARG_PRIVATE_LIBRARIES})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(feltline::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_sources(${target} ${scope} FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src
    FILES ${ARG_HEADERS})
  list(TRANSFORM ARG_DEPENDS PREPEND felt_)
  target_link_libraries(${target} ${scope} ${ARG_DEPENDS} ${ARG_LIBRARIES})
  install(TARGETS ${target} EXPORT feltline-targets
    FILE_SET HEADERS COMPONENT dev
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
  # packaging.cmake writes from these what users of the installed library must find and link.
  set_property(GLOBAL APPEND PROPERTY FELT_LAYERS ${name})
  set_property(GLOBAL APPEND PROPERTY FELT_LIBRARIES ${ARG_LIBRARIES} ${ARG_PRIVATE_LIBRARIES})

  if(FELT_TESTS AND ARG_TESTS)
    felt_test(${name}_test SOURCES ${ARG_TESTS} LIBRARIES ${target} ${ARG_TEST_LIBRARIES})
  endif()
  if(FELT_BENCHMARKS AND ARG_BENCHES)
    find_package(benchmark REQUIRED)
    add_executable(${name}_bench ${ARG_BENCHES})
    target_link_libraries(${name}_bench PRIVATE felt_flags ${target} ${ARG_TEST_LIBRARIES}
      benchmark::benchmark_main)
  endif()
endfunction()

function(felt_room layer name)
  felt_layer(${layer}_${name} ${ARGN})
endfunction()

# felt_test(NAME SOURCES ... LIBRARIES ...): a GoogleTest program, each case its own CTest entry.
function(felt_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  include(GoogleTest)
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE felt_flags ${ARG_LIBRARIES} GTest::gmock GTest::gtest_main
    rapidcheck)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  set(is_desktop FALSE)
  if("felt_desktop_test_main" IN_LIST ARG_LIBRARIES)
    set(is_desktop TRUE)
  endif()
  felt_quick_test(${name} ${is_desktop})
  gtest_discover_tests(${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 300)
endfunction()
