# The packages that the rooms link to. Read by the build and, installed, by the package configuration, since a static
# library hands its dependencies on. A new dependency of a room goes here and into packages.txt.

# In a package configuration a missing package leaves ours not found, with the reason; in the build it is an error.
macro(fourpost_dependency)
  if(CMAKE_FIND_PACKAGE_NAME STREQUAL "fourpost")
    find_dependency(${ARGV})
  else()
    find_package(${ARGV} REQUIRED)
  endif()
endmacro()

fourpost_dependency(Eigen3 3.4 NO_MODULE)
fourpost_dependency(Ceres 2.1)
fourpost_dependency(Simbody 3.7)
fourpost_dependency(SQLite3 3.35)
fourpost_dependency(TBB)
fourpost_dependency(ZLIB)
fourpost_dependency(assimp)
fourpost_dependency(nlohmann_json 3.11)
fourpost_dependency(tinyxml2)
fourpost_dependency(urdfdom)
fourpost_dependency(yaml-cpp)

# Simbody's own targets are three libraries that do not name each other.
if(NOT TARGET fourpost::simbody)
  add_library(fourpost::simbody INTERFACE IMPORTED)
  target_link_libraries(fourpost::simbody INTERFACE ${Simbody_LIBRARIES})
endif()

# HDF5's own CMake module compiles programs to find out where it is.
if(NOT TARGET fourpost::hdf5)
  find_path(HDF5_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial)
  find_library(HDF5_LIBRARY NAMES hdf5_serial hdf5)
  if(HDF5_INCLUDE_DIR AND HDF5_LIBRARY)
    add_library(fourpost::hdf5 INTERFACE IMPORTED)
    set_target_properties(fourpost::hdf5 PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES ${HDF5_INCLUDE_DIR} INTERFACE_LINK_LIBRARIES ${HDF5_LIBRARY})
  elseif(CMAKE_FIND_PACKAGE_NAME STREQUAL "fourpost")
    set(fourpost_FOUND FALSE)
    set(fourpost_NOT_FOUND_MESSAGE "fourpost needs HDF5: apt-get install libhdf5-dev")
  else()
    message(FATAL_ERROR "fourpost needs HDF5: apt-get install libhdf5-dev")
  endif()
endif()
