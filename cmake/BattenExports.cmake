# A linker map that lets out what the public headers name and nothing else: the types and the
# functions that stand directly in namespace batten. Nested namespaces are private, and so is all
# that the headers behind the core compile into it. tests/consume checks the outcome.
#
# Itanium C++ names: a type T of 5 letters is 6batten5T...., a function f of 6 is 6batten6f.....E;
# types begin with a capital letter, all else does not.
function(batten_write_exports file)
    set(patterns "")
    foreach(prefix _ZN _ZNK _ZTVN _ZTIN _ZTSN)
        string(APPEND patterns "    ${prefix}6batten[0-9][A-Z]*;\n"
                               "    ${prefix}6batten[0-9][0-9][A-Z]*;\n")
    endforeach()
    string(APPEND patterns "    _ZN6batten[a-z][a-z]E*;\n")  # operators
    set(any "")
    foreach(length RANGE 1 40)
        string(APPEND any "?")
        string(APPEND patterns "    _ZN6batten${length}${any}E*;\n"
                               "    _ZN6batten${length}${any}B5cxx11E*;\n")
    endforeach()
    file(CONFIGURE OUTPUT ${file} CONTENT "{\nglobal:\n@patterns@local:\n    *;\n};\n" @ONLY)
endfunction()
