# felt_folder(PATH [FLAT] [APART] [QT] [SOURCES generated...] [DEPENDS folders...] [LIBRARIES ...]
#             [PRIVATE_LIBRARIES ...] [TEST_LIBRARIES ...])
#
# Declares the targets of the folder PATH (a/b) and of the folders below it:
#   *.cc, *.h    the static library felt_a_b, installed as feltline::a_b with those headers that
#                src/felt/API.md lists
#   *_test.cc    the GoogleTest program a_b_test, linked only with this library, so that a
#                forbidden dependency does not link
#   *_bench.cc   the Google Benchmark program a_b_bench
#   testing/     helpers for tests and benchmarks only; its sources become felt_a_b_testing
#   make_*.cc    separate programs, which the caller declares
#
#   FLAT               excludes the folders below PATH, which are declared separately
#   APART              not part of the umbrella target feltline::feltline, because of its licence or of what it needs
#   QT                 a folder of the desktop program: not installed, linked with Qt
#   SOURCES            generated sources
#   DEPENDS            folders to link besides those of tests/checks/layers/rules.txt
#   LIBRARIES          libraries that its headers include
#   PRIVATE_LIBRARIES  libraries that only its sources use
#   TEST_LIBRARIES     libraries that only its tests and benchmarks use
include(GNUInstallDirs)

# Sets FELT_MAY_INCLUDE_layer: the layers that the rules allow the layer to include. felt_folder links them.
set(felt_rules ${PROJECT_SOURCE_DIR}/tests/checks/layers/rules.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${felt_rules})
file(STRINGS ${felt_rules} felt_rule_lines REGEX "^layer ")
foreach(line IN LISTS felt_rule_lines)
  string(REGEX MATCHALL "[a-z_]+" words "${line}")
  list(POP_FRONT words _ layer)
  set(FELT_MAY_INCLUDE_${layer} ${words})
endforeach()

# Sets FELT_PUBLIC_HEADERS: the headers that are installed.
set(felt_api ${PROJECT_SOURCE_DIR}/src/felt/API.md)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${felt_api})
file(STRINGS ${felt_api} FELT_PUBLIC_HEADERS REGEX "^\\* .*\\.h\\)")
list(TRANSFORM FELT_PUBLIC_HEADERS REPLACE "^[^(]*\\(([^)]*)\\).*" "${PROJECT_SOURCE_DIR}/src/felt/\\1")

function(felt_folder path)
  cmake_parse_arguments(ARG "FLAT;APART;QT" ""
    "SOURCES;DEPENDS;LIBRARIES;PRIVATE_LIBRARIES;TEST_LIBRARIES" ${ARGN})
  string(REPLACE "/" "_" name ${FELT_FOLDER_PREFIX}${path})
  string(REGEX REPLACE "/.*" "" layer ${path})
  set(target felt_${name})
  set(recurse GLOB_RECURSE)
  if(ARG_FLAT)
    set(recurse GLOB)
  endif()
  file(${recurse} files CONFIGURE_DEPENDS ${path}/*.cc ${path}/*.h)
  set(tests ${files})
  list(FILTER tests INCLUDE REGEX "_test\\.cc$")
  set(benches ${files})
  list(FILTER benches INCLUDE REGEX "_bench\\.cc$")
  list(FILTER files EXCLUDE REGEX "_(test|bench)\\.cc$|/make_[a-z_]+\\.cc$")
  set(testing ${files})
  list(FILTER testing INCLUDE REGEX "/testing/.*\\.cc$")
  list(FILTER files EXCLUDE REGEX "/testing/")
  set(headers ${files})
  list(FILTER headers INCLUDE REGEX "\\.h$")
  list(FILTER files EXCLUDE REGEX "\\.h$")

  add_library(${target} STATIC ${files} ${ARG_SOURCES})
  list(APPEND ARG_DEPENDS ${FELT_MAY_INCLUDE_${layer}})
  list(TRANSFORM ARG_DEPENDS PREPEND felt_)
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} ${ARG_LIBRARIES}
    PRIVATE $<BUILD_INTERFACE:felt_flags> ${ARG_PRIVATE_LIBRARIES})
  if(ARG_QT)
    felt_qt_folder(${target} ${headers})
    set(test_main felt_desktop_test_main)
  else()
    felt_library_folder(${target} ${name} ${headers})
    # packaging.cmake generates the package files from these lists.
    if(NOT ARG_APART)
      set_property(GLOBAL APPEND PROPERTY FELT_LAYERS ${name})
      set_property(GLOBAL APPEND PROPERTY FELT_LIBRARIES ${ARG_LIBRARIES} ${ARG_PRIVATE_LIBRARIES})
    endif()
    # With those of the folders that it links.
    set(libraries ${ARG_LIBRARIES} ${ARG_PRIVATE_LIBRARIES})
    foreach(folder IN LISTS ARG_DEPENDS)
      string(REGEX REPLACE "^felt_" "" folder ${folder})
      get_property(of_folder GLOBAL PROPERTY FELT_LIBRARIES_OF_${folder})
      list(APPEND libraries ${of_folder})
    endforeach()
    list(REMOVE_DUPLICATES libraries)
    set_property(GLOBAL PROPERTY FELT_LIBRARIES_OF_${name} ${libraries})
    set_property(GLOBAL APPEND PROPERTY FELT_COMPONENTS ${name})
  endif()

  set(test_libraries ${target} ${ARG_TEST_LIBRARIES})
  if(testing AND (FELT_TESTS OR FELT_BENCHMARKS))
    add_library(${target}_testing STATIC EXCLUDE_FROM_ALL ${testing})
    felt_quick_library(${target}_testing)
    target_link_libraries(${target}_testing PUBLIC ${target} PRIVATE felt_flags)
    list(PREPEND test_libraries ${target}_testing)
  endif()
  # tests/checks/new_tool links the tests of the panels again, with a new tool.
  if(FELT_TESTS AND tests)
    set(needed "")
    if(NOT FELT_FOLDER_TESTS AND NOT name STREQUAL "desktop_panels")
      set(needed ON_DEMAND)
    endif()
    felt_test(${name}_test ${needed} SOURCES ${tests} LIBRARIES ${test_libraries} ${test_main})
  endif()
  if(FELT_BENCHMARKS AND benches)
    find_package(benchmark REQUIRED)
    add_executable(${name}_bench EXCLUDE_FROM_ALL ${benches})
    add_dependencies(benchmarks ${name}_bench)
    target_link_libraries(${name}_bench PRIVATE felt_flags ${test_libraries}
      benchmark::benchmark_main)
  endif()
endfunction()

# Adds the properties of a folder of the library: its alias, its public headers, and its installation.
function(felt_library_folder target name)
  add_library(feltline::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  felt_quick_library(${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  set(public "")
  foreach(header IN LISTS ARGN)
    if(header IN_LIST FELT_PUBLIC_HEADERS)
      list(APPEND public ${header})
    endif()
  endforeach()
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${public})
  install(TARGETS ${target} EXPORT feltline-targets
    FILE_SET HEADERS COMPONENT dev
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
endfunction()

# Adds the properties of a folder of the desktop program.
function(felt_qt_folder target)
  target_sources(${target} PRIVATE ${ARGN})
  set_target_properties(${target} PROPERTIES AUTOMOC ON)
  felt_quick_room(${target})
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/apps)
  target_compile_definitions(${target} PUBLIC FELT_VERSION="${PROJECT_VERSION}"
    QT_NO_KEYWORDS QT_NO_CAST_FROM_BYTEARRAY)
  target_link_libraries(${target} PUBLIC Qt6::Widgets)
endfunction()

# felt_add_tests(NAME [LABELS ...]): adds the test cases of a GoogleTest program. Each is a separate CTest
# test, NAME.0 to NAME.3 are tests of a quarter of the cases each if FELT_TESTS_TOGETHER is on.
function(felt_add_tests name)
  cmake_parse_arguments(ARG "" "" "LABELS" ${ARGN})
  if(NOT FELT_TESTS_TOGETHER)
    include(GoogleTest)
    gtest_discover_tests(${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} DISCOVERY_TIMEOUT 60
      PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 300)
    return()
  endif()
  foreach(part RANGE 3)
    add_test(NAME ${name}.${part} COMMAND ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(${name}.${part} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 1200
      ENVIRONMENT "GTEST_TOTAL_SHARDS=4;GTEST_SHARD_INDEX=${part}")
  endforeach()
endfunction()

# felt_test(NAME [ON_DEMAND] SOURCES ... LIBRARIES ...): declares a GoogleTest program and adds its tests. With
# ON_DEMAND, it is built only where it is named, and its tests do not run.
function(felt_test name)
  cmake_parse_arguments(ARG "ON_DEMAND" "" "SOURCES;LIBRARIES" ${ARGN})
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE felt_flags ${ARG_LIBRARIES} GTest::gmock GTest::gtest_main
    rapidcheck)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  set(is_desktop FALSE)
  if("felt_desktop_test_main" IN_LIST ARG_LIBRARIES)
    set(is_desktop TRUE)
  endif()
  felt_quick_test(${name} ${is_desktop})
  if(ARG_ON_DEMAND)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  else()
    felt_add_tests(${name})
  endif()
endfunction()
