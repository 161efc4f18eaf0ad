// Any bytes as an undo file, "=====" and the program that it shall belong to. What is given back has the size and the
// hash that the undo file promised; anything else is refused.
#include "fuzz/fuzz.hpp"
#include "nc/rewrite/output/undo.hpp"

using namespace plumbline;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Two input = fuzz::split(fuzz::text_of(data, size));
  const InputFile undo(fuzz::folder().file("undo", input.first));
  const InputFile rewritten(fuzz::folder().file("rewritten", input.second));
  const std::string path = fuzz::folder() / "restored";
  fuzz::is_taken([&] {
    OutputFile out(path);
    nc::restore(rewritten, undo, out);
    out.commit();
    const std::string text = read_text(path);
    // "end SIZE SIZE HASH HASH" is the last line of the undo file; the original's size and hash are in it.
    FUZZ_CHECK(input.first.find(std::to_string(text.size())) != std::string_view::npos);
  });
  return 0;
}
