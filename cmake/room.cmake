# fourpost_room(NAME HEADERS ... SOURCES ... PUBLIC ... PRIVATE ...)
# A room is a static library with an explicit file list; each public header must compile alone.
add_library(fourpost_warnings INTERFACE)
target_compile_options(fourpost_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  # Aggregates have defaults; a designated initialiser names what differs.
  -Wno-missing-field-initializers
  # Contracted multiply-adds would make results depend on the processor.
  -ffp-contract=off
  $<$<BOOL:${FOURPOST_WERROR}>:-Werror>)

function(fourpost_room name)
  cmake_parse_arguments(ROOM "" "" "HEADERS;SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(fourpost_${name} STATIC ${ROOM_SOURCES})
  add_library(fourpost::${name} ALIAS fourpost_${name})
  target_sources(fourpost_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ROOM_HEADERS})
  target_compile_features(fourpost_${name} PUBLIC cxx_std_20)
  target_link_libraries(fourpost_${name} PUBLIC ${ROOM_PUBLIC}
    PRIVATE ${ROOM_PRIVATE} $<BUILD_INTERFACE:fourpost_warnings>)
  set_target_properties(fourpost_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  # All headers of a room in one check per header: `cmake --build ... --target fourpost_<room>_verify_interface_header_sets`.
  set_target_properties(fourpost_${name} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
endfunction()
