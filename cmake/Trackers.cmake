# trackers(TARGET TRACKER...): compiles path trackers into a library, each once for each instruction set that a
# machine may have, from TRACKER_portable.cpp, TRACKER_avx2.cpp and TRACKER_avx512.cpp. Which one is used is decided
# when the program runs. Sets TRACKERS to all these files.
function(trackers target)
  set(portable ${ARGN})
  list(TRANSFORM portable APPEND _portable.cpp)
  set(fastest ${portable})
  set(TRACKERS ${portable})
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(avx2 ${ARGN})
    list(TRANSFORM avx2 APPEND _avx2.cpp)
    set(avx512 ${ARGN})
    list(TRANSFORM avx512 APPEND _avx512.cpp)
    set_source_files_properties(${avx2} PROPERTIES COMPILE_OPTIONS "-mavx2;-mfma" SKIP_PRECOMPILE_HEADERS ON)
    set_source_files_properties(${avx512} PROPERTIES COMPILE_OPTIONS "-mavx512f;-mfma" SKIP_PRECOMPILE_HEADERS ON)
    set(fastest ${avx2} ${avx512})
    list(APPEND TRACKERS ${fastest})
    optimise_sources(-O1 ${portable}) # hardly ever run
  endif()
  target_sources(${target} PRIVATE ${TRACKERS})
  optimise_sources(-O3 ${fastest})
  # GCC 12 miscompiles the AVX-512 tracker at -O1 and -O2: it then followed other paths, and lost some, where
  # -O0, -O3, clang and the sanitizers agree. Without this analysis of its own it agrees with them.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-ipa-modref>)
  set(TRACKERS ${TRACKERS} PARENT_SCOPE)
endfunction()
