# FELT_QUICK_BUILD makes builds faster in three ways. Headers that nearly every file includes are precompiled
# once per kind of target. Several sources of a target compile as one (FELT_UNITY_SOURCES). Test code, but
# not the code under test, is optimised less and has no debug information (with sanitizers: line numbers).
# Without the option, every file is compiled alone: clang-tidy needs this, and a missing #include is an error.
# A higher FELT_UNITY_SOURCES makes a full build faster (the release preset) and a build after a change slower.
set(FELT_UNITY_SOURCES 8 CACHE STRING "Sources that compile as one with FELT_QUICK_BUILD")
set(felt_std_headers <algorithm> <array> <chrono> <cmath> <cstdint> <functional> <limits> <map>
  <memory> <mutex> <optional> <random> <set> <span> <string> <string_view> <utility> <variant>
  <vector> <tl/expected.hpp>)
set(felt_test_headers <gmock/gmock.h> <gtest/gtest.h> <rapidcheck.h>)
# Does not contain <QApplication>, because that header changes the class of qApp.
set(felt_qt_headers <QAction> <QByteArray> <QDialog> <QDir> <QFile> <QImage> <QLabel>
  <QMainWindow> <QMenu> <QMouseEvent> <QObject> <QPainter> <QSettings> <QSignalBlocker> <QString>
  <QTimer> <QToolButton> <QVariant> <QVBoxLayout> <QWidget>)

# Options for test code, which need not be fast. Not -O0, because the linker may use the inline functions of
# the library from an object of the test, and at -O0 they would make the whole program slow: with sanitizers,
# single test programs took minutes. With sanitizers, test code calls functions for the checks of memory and
# leaves out the checks of pointers that compilers put before every access: compiling takes a fifth less
# time, and AddressSanitizer reports the accesses anyway. Programs call functions, too; the library keeps the checks inline.
# Last on the list of a target's libraries, because these options revoke options of felt_flags.
add_library(felt_quick_test_flags INTERFACE)
target_compile_options(felt_quick_test_flags INTERFACE -O1)
set(felt_quick_checks "")
if(FELT_SANITIZE MATCHES "address" AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set(felt_quick_checks "SHELL:-mllvm -asan-instrumentation-with-call-threshold=0")
  target_compile_options(felt_quick_test_flags INTERFACE
    -fno-sanitize=null,alignment,object-size,vptr,pointer-overflow ${felt_quick_checks})
elseif(NOT FELT_SANITIZE)
  target_compile_options(felt_quick_test_flags INTERFACE -g0)
endif()

# Links with a faster linker where it exists: in a third of the time. Not for what users get.
if(FELT_QUICK_BUILD AND CMAKE_BUILD_TYPE STREQUAL "RelWithDebInfo")
  include(CheckLinkerFlag)
  # gold complains about the symbols of clang's sanitizers.
  set(linker -fuse-ld=gold)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    set(linker -fuse-ld=lld)
  endif()
  check_linker_flag(CXX ${linker} FELT_HAS_FAST_LINKER)
  if(FELT_HAS_FAST_LINKER)
    add_link_options(${linker})
  endif()
endif()

function(felt_unity target sources)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${sources})
endfunction()

# felt_quick_headers(NAME TYPE HEADERS ... [LIBRARIES|DEFINITIONS ...]): declares a target whose
# precompiled headers others reuse. TYPE must be the type of those targets, so that the flags are the same.
function(felt_quick_headers name type)
  if(TARGET ${name})
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBRARIES;DEFINITIONS;OPTIONS" ${ARGN})
  set(source ${CMAKE_BINARY_DIR}/${name}.cc)
  if(type STREQUAL "EXECUTABLE")
    file(CONFIGURE OUTPUT ${source} CONTENT "int main() { return 0; }\n")
    add_executable(${name} ${source})
  else()
    file(CONFIGURE OUTPUT ${source} CONTENT "// Its precompiled headers are what counts.\n")
    add_library(${name} STATIC ${source})
  endif()
  target_link_libraries(${name} PRIVATE felt_flags ${ARG_LIBRARIES})
  target_compile_definitions(${name} PRIVATE ${ARG_DEFINITIONS})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

# felt_quick_library(TARGET): for a layer, or for a library that programs share.
function(felt_quick_library target)
  if(FELT_QUICK_BUILD)
    felt_quick_headers(felt_quick_library STATIC HEADERS ${felt_std_headers})
    target_precompile_headers(${target} REUSE_FROM felt_quick_library)
    felt_unity(${target} ${FELT_UNITY_SOURCES})
  endif()
endfunction()

# felt_quick_program(TARGET HEADERS...): for a program with many files, if most of them include HEADERS.
function(felt_quick_program target)
  if(FELT_QUICK_BUILD)
    target_compile_options(${target} PRIVATE ${felt_quick_checks})
    target_precompile_headers(${target} PRIVATE ${felt_std_headers} ${ARGN})
    felt_unity(${target} ${FELT_UNITY_SOURCES})
  endif()
endfunction()

# felt_quick_room(TARGET): for a folder of the desktop program.
function(felt_quick_room target)
  if(FELT_QUICK_BUILD)
    felt_quick_headers(felt_quick_room STATIC HEADERS ${felt_std_headers} ${felt_qt_headers}
      LIBRARIES Qt6::Widgets DEFINITIONS QT_NO_KEYWORDS QT_NO_CAST_FROM_BYTEARRAY)
    target_compile_options(${target} PRIVATE ${felt_quick_checks})
    target_precompile_headers(${target} REUSE_FROM felt_quick_room)
    felt_unity(${target} ${FELT_UNITY_SOURCES})
  endif()
endfunction()

# felt_quick_checker(TARGET): for a program of the tests without GoogleTest.
function(felt_quick_checker target)
  if(FELT_QUICK_BUILD)
    felt_quick_headers(felt_quick_checker EXECUTABLE HEADERS ${felt_std_headers}
      LIBRARIES felt_quick_test_flags)
    target_link_libraries(${target} PRIVATE felt_quick_test_flags)
    target_precompile_headers(${target} REUSE_FROM felt_quick_checker)
    felt_unity(${target} ${FELT_UNITY_SOURCES})
  endif()
endfunction()

# felt_quick_test(TARGET IS_DESKTOP): for a GoogleTest program.
function(felt_quick_test target is_desktop)
  if(NOT FELT_QUICK_BUILD)
    return()
  endif()
  target_link_libraries(${target} PRIVATE felt_quick_test_flags)
  felt_unity(${target} ${FELT_UNITY_SOURCES})
  if(is_desktop)
    felt_quick_headers(felt_quick_desktop_test EXECUTABLE
      HEADERS ${felt_std_headers} ${felt_test_headers} ${felt_qt_headers}
      LIBRARIES Qt6::Widgets GTest::gmock GTest::gtest_main rapidcheck felt_quick_test_flags
      DEFINITIONS QT_NO_KEYWORDS QT_NO_CAST_FROM_BYTEARRAY)
    target_precompile_headers(${target} REUSE_FROM felt_quick_desktop_test)
  else()
    felt_quick_headers(felt_quick_test EXECUTABLE HEADERS ${felt_std_headers} ${felt_test_headers}
      LIBRARIES GTest::gmock GTest::gtest_main rapidcheck felt_quick_test_flags)
    target_precompile_headers(${target} REUSE_FROM felt_quick_test)
  endif()
endfunction()
