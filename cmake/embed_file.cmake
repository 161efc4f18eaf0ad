# Writes the bytes of FILES (| between them) as one string literal a line; hexadecimal escapes, so that no byte needs
# thought.
string(REPLACE "|" ";" files "${FILES}")
set(text "")
foreach(file IN LISTS files)
  file(READ ${file} bytes HEX)
  string(APPEND text "${bytes}")
endforeach()
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" text "${text}")
string(REPLACE "\\x0a" "\\x0a\"\n    \"" text "${text}")
file(WRITE ${SOURCE}
"#include <string_view>
namespace plumbline::embedded {
extern const std::string_view ${NAME};
static constexpr char kBytes[] =
    \"${text}\";
constinit const std::string_view ${NAME}(kBytes, sizeof(kBytes) - 1);
}  // namespace plumbline::embedded
")
