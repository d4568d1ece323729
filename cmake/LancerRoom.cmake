# lancer_room(NAME SOURCES ... LINKS ...): one folder, one namespace, one static library `lancer_NAME`, known to users as `lancer::NAME`.
function(lancer_flags target)
  # Contraction would let a*b-c*d differ between compilers and processors: every fma is explicit.
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wconversion -Wshadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC 12 takes "text" + std::string for an overlapping copy (GCC bug 105651).
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  if(LANCER_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(LANCER_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${LANCER_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${LANCER_SANITIZE})
  endif()
endfunction()

function(lancer_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(lancer_${name} STATIC ${ROOM_SOURCES})
  add_library(lancer::${name} ALIAS lancer_${name})
  set_target_properties(lancer_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(lancer_${name} PUBLIC cxx_std_20)
  target_include_directories(lancer_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/lancer>)
  target_link_libraries(lancer_${name} PUBLIC ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS})
  lancer_flags(lancer_${name})
  set_property(GLOBAL APPEND PROPERTY LANCER_ROOMS lancer_${name})
endfunction()
