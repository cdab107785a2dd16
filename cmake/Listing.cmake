# Embeds text files in the program, so that the listing on screen is the very source that was compiled.
# texelscope_embed(OUT name.cpp FILES a.h b.h) writes generated/OUT, which defines embedded_files() (core/trace/listing.h).
function(texelscope_embed)
  cmake_parse_arguments(EMBED "" "OUT" "FILES" ${ARGN})
  set(out ${PROJECT_BINARY_DIR}/generated/${EMBED_OUT})
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DROOT=${PROJECT_SOURCE_DIR} "-DFILES=${EMBED_FILES}"
            -P ${PROJECT_SOURCE_DIR}/cmake/Embed.cmake
    DEPENDS ${EMBED_FILES} ${PROJECT_SOURCE_DIR}/cmake/Embed.cmake VERBATIM)
endfunction()
