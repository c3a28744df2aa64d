# Writes sweep_script.cpp with the text of the scripts.   cmake -D OUTPUT=sweep_script.cpp -D "SCRIPTS=a.js;b.js" -P embed_script.cmake
set(pieces "")
foreach(file IN LISTS SCRIPTS)
  file(READ ${file} text)
  if(text MATCHES "</script|<!--")
    message(FATAL_ERROR "${file} would end its script element")
  endif()
  string(APPEND pieces "    R\"soft~(${text})soft~\"sv,\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by embed_script.cmake.
#include \"view/sweep_script.hpp\"

namespace soft::view {
namespace {
using namespace std::string_view_literals;
constexpr std::string_view pieces[] = {
    \"{'use strict';\\n\"sv,
${pieces}    \"}\\n\"sv,
};
}  // namespace

std::span<const std::string_view> sweep_script() noexcept { return pieces; }

}  // namespace soft::view
")
