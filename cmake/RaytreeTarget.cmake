# What every target of the project has in common.

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")

find_program(RAYTREE_CCACHE ccache)
if(RAYTREE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${RAYTREE_CCACHE}")
endif()

# One compile setting for all of raytree's code, so that no number depends on the target it is
# computed in. Contraction breaks error-free transformations and the symmetry of edge functions;
# GCC 12's vectoriser of straight-line code loses the rounding of double to float.
add_library(raytree_options INTERFACE)
target_compile_features(raytree_options INTERFACE cxx_std_20)
target_compile_options(raytree_options INTERFACE
  -ffp-contract=off $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)

# How raytree itself is built, which is no business of those who use the library.
add_library(raytree_build INTERFACE)
target_compile_options(raytree_build INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 warns of its own std::string (bug 105329)
  $<$<BOOL:${RAYTREE_WARNINGS_AS_ERRORS}>:-Werror>)
if(RAYTREE_SANITIZE)
  target_compile_options(raytree_build INTERFACE
    -fsanitize=${RAYTREE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(raytree_build INTERFACE -fsanitize=${RAYTREE_SANITIZE})
endif()
if(RAYTREE_COVERAGE)
  # -pthread makes GCC count lines atomically, as -fprofile-update=atomic does, which ccache refuses.
  target_compile_options(raytree_build INTERFACE --coverage -pthread)
  target_link_options(raytree_build INTERFACE --coverage)
endif()
link_libraries($<BUILD_INTERFACE:raytree_build>)

include(GNUInstallDirs)
set_target_properties(raytree_options PROPERTIES EXPORT_NAME options)
install(TARGETS raytree_options EXPORT raytree)

# raytree_layer(NAME [DEPENDS LAYER...] [LIBRARIES TARGET...])
# A folder of lib/ as a target of its own, raytree::NAME. It may use the layers it depends on and
# no others.
function(raytree_layer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;LIBRARIES")
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  list(TRANSFORM arg_DEPENDS PREPEND raytree::)
  if(sources)
    add_library(raytree_${name} STATIC ${sources})
    set(scope PUBLIC)
  else()
    add_library(raytree_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(raytree::${name} ALIAS raytree_${name})
  target_include_directories(raytree_${name} ${scope}
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/lib>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/raytree>")
  set_target_properties(raytree_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS raytree_${name} EXPORT raytree)
  install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/raytree"
    FILES_MATCHING PATTERN "*.h")
  target_link_libraries(raytree_${name} ${scope} raytree_options ${arg_DEPENDS} ${arg_LIBRARIES})
endfunction()

# raytree_alone(FILE...)
# Files with names of their own that others use for something else: never compiled as one with them
# (CMAKE_UNITY_BUILD).
function(raytree_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
