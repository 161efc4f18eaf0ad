// usage: outside MODEL PROGRAM OUTPUT: compensates a program that is in memory, as an export script would.
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include <plumbline/plumbline.hpp>

namespace api = plumbline::api;

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  std::ifstream in(argv[2], std::ios::binary);
  const std::string program((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  try {
    const api::Model model(api::Input::file(argv[1]));
    const api::Options options = api::Options().set("work-offset", "G54=0,0,-1008,0,0,0");
    std::string corrected;
    const api::Result done =
        api::compensate(api::Input::text(program, argv[2]), model, options, api::Output::text(corrected));
    std::ofstream(argv[3], std::ios::binary) << corrected;
    std::cout << api::version() << ", interface " << PLUMBLINE_INTERFACE << ": " << done.number("moves") << " moves\n";
  } catch (const api::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  try {
    std::string none;
    api::trace(api::Input::text("G0 X1\nG99999\n", "bad.ngc"), {}, api::Output::text(none));
  } catch (const api::Error& error) {  // it comes through the edge of the library as what it is
    std::cout << error.diagnostic().code << " in line " << error.diagnostic().place.line << '\n';
    return 0;
  }
  return 1;
}
