# Lists the tests of PROGRAM for ctest, when it starts: fast ones a suite each, since most of them take less time than
# their process, and SLOW ones, patterns of --gtest_filter, one by one; these start first.
if(NOT EXISTS ${PROGRAM})
  get_filename_component(name ${PROGRAM} NAME)
  add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)
  return()
endif()

# The parent names SLOW.
if(NOT EXISTS ${LIST} OR ${PROGRAM} IS_NEWER_THAN ${LIST} OR ${CMAKE_CURRENT_LIST_FILE} IS_NEWER_THAN ${LIST}
    OR ${CMAKE_PARENT_LIST_FILE} IS_NEWER_THAN ${LIST})
  function(suites_of filter lines)
    execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${filter}
      OUTPUT_VARIABLE text RESULT_VARIABLE failure)
    if(failure)
      message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${failure}")
    endif()
    # What follows a '#' are values of parameters, which may hold anything.
    string(REGEX REPLACE " *#[^\n]*" "" text "${text}")
    string(REGEX MATCHALL "[^\n]+" text "${text}")
    set(${lines} ${text} PARENT_SCOPE)
  endfunction()

  set(tests "")
  suites_of("-${SLOW}" lines)
  foreach(line IN LISTS lines)
    if(line MATCHES "^([^ ].*)[.]$")
      string(APPEND tests "add_test([=[${CMAKE_MATCH_1}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${CMAKE_MATCH_1}.*-${SLOW}]=])\n"
        "set_tests_properties([=[${CMAKE_MATCH_1}]=] PROPERTIES LABELS fast)\n")
    endif()
  endforeach()
  if(SLOW)
    suites_of("${SLOW}" lines)
    foreach(line IN LISTS lines)
      if(line MATCHES "^([^ ].*[.])$")
        set(suite ${CMAKE_MATCH_1})
      elseif(line MATCHES "^  (.*)$")
        string(APPEND tests "add_test([=[${suite}${CMAKE_MATCH_1}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}${CMAKE_MATCH_1}]=])\n"
          "set_tests_properties([=[${suite}${CMAKE_MATCH_1}]=] PROPERTIES LABELS slow COST 5)\n")
      endif()
    endforeach()
  endif()
  file(WRITE ${LIST} "${tests}")
endif()
include(${LIST})
