# Writes the bytes of FILE as one string literal a line; hexadecimal escapes, so that no byte needs thought.
file(READ ${FILE} text HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" text "${text}")
string(REPLACE "\\x0a" "\\x0a\"\n    \"" text "${text}")
file(WRITE ${SOURCE}
"#include <string_view>
namespace plumbline::embedded {
extern const std::string_view ${NAME};
const std::string_view ${NAME} =
    \"${text}\";
}  // namespace plumbline::embedded
")
