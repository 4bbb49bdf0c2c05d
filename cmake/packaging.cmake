# Installing: headers and archives (rules in folder.cmake), the CMake package `feltline`, the
# pkg-config file, the program and the shared files. debian/ and packaging/ make packages of them.
#
# Every layer is a static archive, so a program that links it must also link the libraries that the layer
# uses. Only the two tables below define how these libraries are found. Configuring fails if a layer links
# a library that is not listed, because otherwise the installed package would not work.
include(CMakePackageConfigHelpers)

# Maps the target of a library to the line of feltlineConfig.cmake that finds it.
set(FELT_FIND_tl::expected "find_dependency(tl-expected)")
set(FELT_FIND_fmt::fmt "find_dependency(fmt)")
set(FELT_FIND_PNG::PNG "find_dependency(PNG)")
set(FELT_FIND_pugixml::pugixml "find_dependency(pugixml)")
set(FELT_FIND_pugixml "find_dependency(pugixml)")
set(FELT_FIND_simdjson::simdjson "find_dependency(simdjson)")
set(FELT_FIND_nlohmann_json::nlohmann_json "find_dependency(nlohmann_json)")
set(FELT_FIND_SQLite::SQLite3 "find_dependency(SQLite3)")
set(FELT_FIND_Threads::Threads "find_dependency(Threads)")
set(FELT_FIND_ZLIB::ZLIB "find_dependency(ZLIB)")
set(FELT_FIND_PkgConfig::AGG
    "find_dependency(PkgConfig)\npkg_check_modules(AGG REQUIRED IMPORTED_TARGET libagg)")
set(FELT_FIND_PkgConfig::LIBZIP
    "find_dependency(PkgConfig)\npkg_check_modules(LIBZIP REQUIRED IMPORTED_TARGET libzip)")

set(FELT_FIND_OpenCV::imgproc "find_library(FELT_OPENCV_IMGPROC opencv_imgproc REQUIRED)
find_library(FELT_OPENCV_CORE opencv_core REQUIRED)
if(NOT TARGET OpenCV::imgproc)
  add_library(OpenCV::imgproc INTERFACE IMPORTED)
  target_link_libraries(OpenCV::imgproc INTERFACE \${FELT_OPENCV_IMGPROC} \${FELT_OPENCV_CORE})
endif()")

# Maps the same target to its name in pkg-config. A name that starts with '-' is a linker flag. "" means
# that nothing must be linked, because the library is header-only.
set(FELT_PC_tl::expected "")
set(FELT_PC_fmt::fmt "fmt")
set(FELT_PC_PNG::PNG "libpng")
set(FELT_PC_pugixml::pugixml "pugixml")
set(FELT_PC_pugixml "pugixml")
set(FELT_PC_simdjson::simdjson "simdjson")
set(FELT_PC_nlohmann_json::nlohmann_json "")
set(FELT_PC_SQLite::SQLite3 "sqlite3")
set(FELT_PC_Threads::Threads "-pthread")
set(FELT_PC_ZLIB::ZLIB "zlib")
set(FELT_PC_OpenCV::imgproc "-lopencv_imgproc -lopencv_core")
set(FELT_PC_PkgConfig::AGG "libagg")
set(FELT_PC_PkgConfig::LIBZIP "libzip")

# The umbrella target feltline::feltline links every layer.
get_property(FELT_LAYERS GLOBAL PROPERTY FELT_LAYERS)
get_property(FELT_LIBRARIES GLOBAL PROPERTY FELT_LIBRARIES)
list(REMOVE_DUPLICATES FELT_LIBRARIES)
add_library(felt_umbrella INTERFACE)
add_library(feltline::feltline ALIAS felt_umbrella)
set_target_properties(felt_umbrella PROPERTIES EXPORT_NAME feltline)
list(TRANSFORM FELT_LAYERS PREPEND felt_ OUTPUT_VARIABLE felt_layer_targets)
target_link_libraries(felt_umbrella INTERFACE ${felt_layer_targets})
install(TARGETS felt_umbrella EXPORT feltline-targets)

set(FELT_FIND_LINES "")
set(FELT_PC_REQUIRES "")
set(FELT_PC_LIBS "")
foreach(library IN LISTS FELT_LIBRARIES)
  if(NOT DEFINED FELT_FIND_${library} OR NOT DEFINED FELT_PC_${library})
    message(FATAL_ERROR "A layer links ${library}: say in cmake/packaging.cmake how users of the "
                        "installed library find it")
  endif()
  if(FELT_PC_${library} MATCHES "^-")
    string(APPEND FELT_PC_LIBS " ${FELT_PC_${library}}")
  elseif(FELT_PC_${library})
    list(APPEND FELT_PC_REQUIRES ${FELT_PC_${library}})
  endif()
endforeach()
list(JOIN FELT_PC_REQUIRES " " FELT_PC_REQUIRES)
# A program that names its layers as components needs only the libraries of those.
get_property(felt_components GLOBAL PROPERTY FELT_COMPONENTS)
set_property(GLOBAL PROPERTY FELT_LIBRARIES_OF_feltline ${FELT_LIBRARIES})
foreach(component IN LISTS felt_components ITEMS feltline)
  get_property(libraries GLOBAL PROPERTY FELT_LIBRARIES_OF_${component})
  string(APPEND FELT_FIND_LINES "if(\"${component}\" IN_LIST _felt_wanted)\n")
  foreach(library IN LISTS libraries)
    string(APPEND FELT_FIND_LINES "${FELT_FIND_${library}}\n")
  endforeach()
  string(APPEND FELT_FIND_LINES "endif()\n")
endforeach()
# A linker reads archives from left to right, so a layer must come before the layers that it uses. This is
# the reverse of the order in which they are declared.
set(felt_archives "")
foreach(layer IN LISTS FELT_LAYERS)
  get_target_property(type felt_${layer} TYPE)
  if(type STREQUAL "STATIC_LIBRARY")
    string(PREPEND felt_archives " -lfelt_${layer}")
  endif()
endforeach()
string(PREPEND FELT_PC_LIBS "${felt_archives}")

set(felt_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/feltline)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/feltlineConfig.cmake.in
  ${CMAKE_BINARY_DIR}/package/feltlineConfig.cmake INSTALL_DESTINATION ${felt_cmake_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/feltlineConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/package/feltlineConfig.cmake
              ${CMAKE_BINARY_DIR}/package/feltlineConfigVersion.cmake
  DESTINATION ${felt_cmake_dir} COMPONENT dev)
install(EXPORT feltline-targets NAMESPACE feltline:: DESTINATION ${felt_cmake_dir} COMPONENT dev)

# The .pc file gives the prefix relative to its own folder, so that the installed tree can be moved.
file(RELATIVE_PATH FELT_PC_UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" FELT_PC_UP ${FELT_PC_UP})
configure_file(${CMAKE_CURRENT_LIST_DIR}/feltline.pc.in ${CMAKE_BINARY_DIR}/package/feltline.pc
  @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/package/feltline.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)

if(TARGET feltline)
  install(TARGETS feltline RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT bin)
endif()
if(FELT_FITTER_ONLY)
  return()
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/share/samples
  DESTINATION ${CMAKE_INSTALL_DATADIR}/feltline COMPONENT bin OPTIONAL
  FILES_MATCHING PATTERN "*.ndjson")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/share/materials
  DESTINATION ${CMAKE_INSTALL_DATADIR}/feltline COMPONENT bin FILES_MATCHING PATTERN "*.toml")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/share/studies
  DESTINATION ${CMAKE_INSTALL_DATADIR}/feltline COMPONENT bin FILES_MATCHING PATTERN "*.toml")
set(felt_completions ${PROJECT_SOURCE_DIR}/share/completions)
install(FILES ${felt_completions}/bash/feltline COMPONENT bin
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${felt_completions}/zsh/_feltline COMPONENT bin
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${felt_completions}/fish/feltline.fish COMPONENT bin
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES ${PROJECT_SOURCE_DIR}/share/man/feltline.1 COMPONENT bin OPTIONAL
  DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT bin)
