# fourpost_room(FOLDER USES room... PUBLIC library... PRIVATE library...)
# A room is a folder and a static library of all that lies in it. USES names the rooms that it may include, "vehicles/laws";
# the build refuses any other (arrows.cmake), and a circle of rooms.
add_library(fourpost_warnings INTERFACE)
target_compile_options(fourpost_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  # Aggregates have defaults; a designated initialiser names what differs.
  -Wno-missing-field-initializers
  # Contracted multiply-adds would make results depend on the processor.
  -ffp-contract=off
  $<$<BOOL:${FOURPOST_WERROR}>:-Werror>)

include(${CMAKE_CURRENT_LIST_DIR}/precompiled.cmake)
fourpost_precompiled(fourpost_headers)

set(fourpost_cmake_dir ${CMAKE_CURRENT_LIST_DIR})

function(fourpost_room folder)
  cmake_parse_arguments(ROOM "" "" "SOURCES;USES;PUBLIC;PRIVATE" ${ARGN})
  string(REPLACE "/" "_" name ${folder})
  set(target fourpost_${name})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  string(REPLACE "/" "_" rooms "${ROOM_USES}")
  list(TRANSFORM rooms PREPEND fourpost::)

  # A stamp that is newer than all files whose arrows have been looked at.
  set(stamp ${PROJECT_BINARY_DIR}/arrows/${name})
  string(REPLACE ";" "," uses "${ROOM_USES}")
  add_custom_command(OUTPUT ${stamp}
    COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR} -D ROOM=${folder} -D USES=${uses} -D STAMP=${stamp}
      -P ${fourpost_cmake_dir}/arrows.cmake
    DEPENDS ${sources} ${headers} ${fourpost_cmake_dir}/arrows.cmake VERBATIM
    COMMENT "Arrows of ${folder}")

  add_library(${target} STATIC ${sources} ${ROOM_SOURCES} ${stamp})
  add_library(fourpost::${name} ALIAS ${target})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC ${rooms} ${ROOM_PUBLIC}
    PRIVATE ${ROOM_PRIVATE} $<BUILD_INTERFACE:fourpost_warnings>)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  fourpost_reuse(${target} fourpost_headers)
  set_property(GLOBAL APPEND PROPERTY fourpost_rooms ${target})
endfunction()

# fourpost_public(FOLDER INCLUDE_DIR): a room as the library fourpost::fourpost with the headers that are installed; each
# of them is compiled alone.
function(fourpost_public folder include_dir)
  string(REPLACE "/" "_" name ${folder})
  set(target fourpost_${name})
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include_dir}/*.h)
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${include_dir} FILES ${headers})
  set_target_properties(${target} PROPERTIES EXPORT_NAME fourpost VERIFY_INTERFACE_HEADER_SETS ON)
  add_library(fourpost::fourpost ALIAS ${target})
  set_property(GLOBAL PROPERTY fourpost_public_target ${target})
endfunction()

# fourpost_part(NAME): all rooms under a folder of the top level, as one library to link to.
function(fourpost_part name)
  get_property(rooms GLOBAL PROPERTY fourpost_rooms)
  list(FILTER rooms INCLUDE REGEX "^fourpost_${name}_")
  add_library(fourpost_${name} INTERFACE)
  add_library(fourpost::${name} ALIAS fourpost_${name})
  string(REPLACE "fourpost_" "fourpost::" rooms "${rooms}")
  target_link_libraries(fourpost_${name} INTERFACE ${rooms})
  set_target_properties(fourpost_${name} PROPERTIES EXPORT_NAME ${name})
  set_property(GLOBAL APPEND PROPERTY fourpost_parts fourpost_${name})
endfunction()
