# What nearly every source includes, compiled once: half of a source's compile time is these headers. Not nlohmann/json,
# whose literals make every source instantiate the parser, for 0.4 s each.
# Sources still name what they use; `cmake -D FOURPOST_PRECOMPILED=OFF` shows where one does not.
option(FOURPOST_PRECOMPILED "Compile the headers that nearly every source includes only once" ON)

# One position-independent form for libraries and programs, so that all share what is precompiled.
add_compile_options(-fPIC)

# g++ collects garbage from a few MB on, which takes a tenth of its time with so many templates and saves little memory.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=500000>)

function(fourpost_precompiled target)
  file(WRITE ${PROJECT_BINARY_DIR}/${target}.cpp "")
  add_library(${target} OBJECT ${PROJECT_BINARY_DIR}/${target}.cpp)
  target_link_libraries(${target} PRIVATE fourpost_warnings Eigen3::Eigen)
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <cmath> <complex> <cstddef> <cstdint> <filesystem> <functional> <limits> <map> <memory>
    <numbers> <numeric> <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector>
    <Eigen/Core> <Eigen/Geometry> ${ARGN})
endfunction()

# fourpost_reuse(TARGET FROM): TARGET's sources use what FROM precompiled.
function(fourpost_reuse target from)
  if(FOURPOST_PRECOMPILED)
    target_precompile_headers(${target} REUSE_FROM ${from})
  endif()
endfunction()

# Sources of a room are compiled some at a time, which reads headers and instantiates templates once for all of them.
option(FOURPOST_UNITY "Compile several sources of a room as one: less work for the compiler in all" ON)
set(CMAKE_UNITY_BUILD ${FOURPOST_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 32)
