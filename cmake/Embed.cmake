# Run by texelscope_embed: writes a C++ file that holds the text of FILES, each under its path from ROOT.
set(text "#include \"core/trace/listing.h\"\n\nnamespace texelscope {\n\nstd::span<const EmbeddedFile> embedded_files() {\n    static constexpr EmbeddedFile kFiles[] = {\n")
foreach(file IN LISTS FILES)
  file(READ ${file} body)
  file(RELATIVE_PATH name ${ROOT} ${file})
  string(APPEND text "        {\"${name}\", R\"TEXELSCOPE(${body})TEXELSCOPE\"},\n")
endforeach()
string(APPEND text "    };\n    return kFiles;\n}\n\n}  // namespace texelscope\n")
file(WRITE ${OUT} "${text}")
