# optimise(LEVEL TARGET...), optimise_sources(LEVEL FILE...): compile these in a release at another level than
# CMake's -O3. It takes the compiler half as long again as -O1, which makes most sources as fast. Flags that the
# user gives for a release stay: tests/audit compares what programs of other levels write.
function(optimise level)
  if(CMAKE_CXX_FLAGS_RELEASE STREQUAL "-O3 -DNDEBUG")
    foreach(target ${ARGN})
      target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
    endforeach()
  endif()
endfunction()
function(optimise_sources level)
  if(CMAKE_CXX_FLAGS_RELEASE STREQUAL "-O3 -DNDEBUG")
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS $<$<CONFIG:Release>:${level}>)
    # GCC 12 crashes where headers were precompiled at another level.
    set_property(SOURCE ${ARGN} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()
