# cmake -D BUILD_DIR=... -D SCRATCH_DIR=... -D GENERATOR=... -D CXX_COMPILER=... -D CXX_FLAGS=... -P install_test.cmake
set(prefix ${SCRATCH_DIR}/prefix)
set(consumer ${SCRATCH_DIR}/consumer)

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# A file left by an earlier run must not stand in for one that is no longer installed.
file(REMOVE_RECURSE ${SCRATCH_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
if(EXISTS ${prefix}/bin/fourpost)
  run(${prefix}/bin/fourpost --help)
  foreach(file IN ITEMS man/man1/fourpost.1 bash-completion/completions/fourpost zsh/site-functions/_fourpost
      fish/vendor_completions.d/fourpost.fish fourpost/python/fourpost_batch/__main__.py)
    if(NOT EXISTS ${prefix}/share/${file})
      message(FATAL_ERROR "share/${file} is not installed")
    endif()
  endforeach()
endif()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${consumer} -G ${GENERATOR}
  -D EXAMPLES=${CMAKE_CURRENT_LIST_DIR}/../../examples -D fourpost_ROOT=${prefix} -D CMAKE_CXX_COMPILER=${CXX_COMPILER} -D CMAKE_CXX_FLAGS=${CXX_FLAGS})
run(${CMAKE_COMMAND} --build ${consumer})
run(${consumer}/load_and_respond ${prefix}/share/fourpost)
