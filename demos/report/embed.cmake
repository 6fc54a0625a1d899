# Writes a C++ source with a function that returns a file's bytes.
#   cmake -Dinput=FILE -Doutput=FILE.cpp -Dheader=HEADER -Dfunction=NAME -P embed.cmake
file(READ ${input} bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE ${output} "#include \"${header}\"

namespace polhode::demos {

namespace {

constexpr unsigned char kBytes[] = {
${bytes}};

}  // namespace

std::string_view ${function}() {
  return {reinterpret_cast<const char*>(kBytes), sizeof kBytes};
}

}  // namespace polhode::demos
")
