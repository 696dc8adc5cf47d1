# SPDX-License-Identifier: GPL-3.0-or-later
# scree_kernel(FILE.cl): makes FILE_source.h beside the same path in the build folder, with
# the kernel's text as `inline constexpr const char* FILE_source`; made again when FILE.cl changes.
function(scree_kernel file)
  get_filename_component(name ${file} NAME_WE)
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR}/${file} DIRECTORY)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/${folder}/${name}_source.h CONTENT
[[// Made by CMake from @file@.
#pragma once

namespace scree {

inline constexpr const char* @name@_source = R"kernel(@text@)kernel";

} // namespace scree
]] @ONLY)
endfunction()
