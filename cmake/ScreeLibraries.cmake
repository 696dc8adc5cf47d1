# Every outside library, found once; Debian 12 and 13 have all of them (see packages.txt).
find_package(Imath CONFIG REQUIRED)
find_package(OpenEXR CONFIG REQUIRED)
find_package(OpenImageIO CONFIG REQUIRED)
# Debian installs the configuration beside its name, where CMake does not look by itself.
find_package(OpenColorIO CONFIG REQUIRED HINTS /usr/share/cmake)
find_package(TBB CONFIG REQUIRED)
find_package(OpenCL REQUIRED)
find_package(CGAL CONFIG REQUIRED)
find_package(fmt CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)
find_package(Lua 5.4 REQUIRED)
find_package(pugixml CONFIG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(libhwy REQUIRED IMPORTED_TARGET libhwy)
pkg_check_modules(librsvg REQUIRED IMPORTED_TARGET librsvg-2.0>=2.52)
find_path(RANDOM123_INCLUDE_DIR Random123/philox.h REQUIRED)

# OpenVDB's own module asks for the development files of all that the library was built with.
find_path(OPENVDB_INCLUDE_DIR openvdb/openvdb.h REQUIRED)
find_library(OPENVDB_LIBRARY openvdb REQUIRED)
if(NOT TARGET OpenVDB::openvdb)
  add_library(OpenVDB::openvdb UNKNOWN IMPORTED)
  set_target_properties(OpenVDB::openvdb PROPERTIES
    IMPORTED_LOCATION ${OPENVDB_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OPENVDB_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "Imath::Imath;TBB::tbb")
endif()

# lib3mf's own description names the development files of all that the library was built with.
find_path(LIB3MF_INCLUDE_DIR Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf REQUIRED)
find_library(LIB3MF_LIBRARY 3MF REQUIRED)
if(NOT TARGET Lib3MF::lib3mf)
  add_library(Lib3MF::lib3mf UNKNOWN IMPORTED)
  set_target_properties(Lib3MF::lib3mf PROPERTIES
    IMPORTED_LOCATION ${LIB3MF_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${LIB3MF_INCLUDE_DIR})
endif()

# Embree 3 or 4, whichever there is; render/world.cpp adapts to both.
find_package(embree 4 CONFIG QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 CONFIG REQUIRED)
endif()

# Debian's OpenImageIO and OpenColorIO name include folders that only exist where they were built.
foreach(target OpenImageIO::OpenImageIO OpenColorIO::OpenColorIO)
  get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
  set(existing "")
  foreach(folder ${folders})
    if(EXISTS ${folder})
      list(APPEND existing ${folder})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${existing}")
endforeach()
