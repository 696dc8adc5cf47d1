# One static library per folder. scree_library(name SOURCES ... LIBRARIES ...): LIBRARIES are seen
# by users of the library's headers, PRIVATE_LIBRARIES only by its own files (one door per library).
include(GNUInstallDirs)

function(scree_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 and 14 report std::string and std::variant members that are plainly initialised
    # (GCC bugs 105562, 105651).
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized -Wno-restrict)
  endif()
endfunction()

function(scree_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/scree>)
  target_link_libraries(${name} PUBLIC ${arg_LIBRARIES} PRIVATE ${arg_PRIVATE_LIBRARIES})
  # The same bytes on every machine of a kind: no contraction of a * b + c behind our back.
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  scree_warnings(${name})
  set_property(GLOBAL APPEND PROPERTY SCREE_LIBRARIES ${name})
endfunction()
